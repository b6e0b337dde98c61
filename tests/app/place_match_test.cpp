#include "app/place_match.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "render/volume/builtin.h"

namespace crest {
namespace {

PlaceMatch::Outcome outcome_of(PlaceMatch& match) {
  for (;;) {
    if (auto outcome = match.take()) return *outcome;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

TEST(PlaceMatch, TheLastVolumeIsReadAgainAndFitted) {
  const auto present = std::make_shared<const Volume>(make_builtin("linear?n=17&a=2&b=1&c=0.5"));
  PlaceMatch match;
  match.start("builtin:linear?n=17", present);
  EXPECT_TRUE(match.is_busy());
  const PlaceMatch::Outcome outcome = outcome_of(match);
  ASSERT_TRUE(outcome.fit) << outcome.error;
  EXPECT_NEAR(fitted_value(*outcome.fit, 0.3), 0.6, 1e-3);
  EXPECT_FALSE(match.is_busy());
}

TEST(PlaceMatch, WhatCannotBeComparedIsSaid) {
  const auto present = std::make_shared<const Volume>(make_builtin("linear?n=17"));
  PlaceMatch match;
  match.start("nowhere.nrrd", present);
  EXPECT_NE(outcome_of(match).error.find("nowhere.nrrd"), std::string::npos);
  match.start("builtin:linear?n=9", present);
  EXPECT_NE(outcome_of(match).error.find("same grid"), std::string::npos);
}

}  // namespace
}  // namespace crest
