#include "render/scene/exact.h"

#include <gtest/gtest.h>

namespace crest {
namespace {

// What has no part in the exact picture makes no other one of it.
TEST(Exact, SettingsOfTheSamePictureAreEqual) {
  Rendering a;
  a.mode = Mode::peak_xor_dvr;
  a.shading = Shading::gradient;
  Rendering b = a;
  b.step = 2;
  b.classification = ClassificationMethod::preintegrated;
  b.placement = Placement::eye;
  b.sampling = Sampling::footprint;
  b.early_termination = 0.1;
  b.peak_form = PeakForm::paper;
  b.engine = Engine::vdls;
  EXPECT_EQ(exact_rendering(a), exact_rendering(b));
  EXPECT_TRUE(is_exact(exact_rendering(b)));
  EXPECT_FALSE(is_exact(b));
  for (const auto change :
       {+[](Rendering& r) { r.mode = Mode::dvr_only; }, +[](Rendering& r) { r.shading = Shading::none; },
        +[](Rendering& r) { r.clip_box = ClipBox{}; }, +[](Rendering& r) { r.background = glm::dvec3(1); }}) {
    Rendering other = a;
    change(other);
    EXPECT_NE(exact_rendering(a), exact_rendering(other));
  }
}

TEST(Exact, WhatIsMadeOfSamplesIsNotExact) {
  Rendering r;
  EXPECT_EQ(why_not_exact(r), "");
  r.filter = Filter::bspline;
  EXPECT_NE(why_not_exact(r).find("bspline"), std::string::npos);
  r.filter = Filter::linear_exact;
  EXPECT_EQ(why_not_exact(r), "");
  r.blend_mode = BlendMode::maximum;
  EXPECT_NE(why_not_exact(r).find("maximum"), std::string::npos);
  r.mode = Mode::peak_only;
  EXPECT_EQ(why_not_exact(r), "") << "surfaces are not blended so";
}

}  // namespace
}  // namespace crest
