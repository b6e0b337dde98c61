#include "render/studies/stability/table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>

#include "presets/atomic_file.h"
#include "presets/error.h"
#include "render/reference/reference.h"
#include "render/studies/stability/cases.h"
#include "tests/changed_shaders.h"
#include "tests/debug_context.h"

namespace crest::stability {
namespace {

namespace fs = std::filesystem;

std::vector<Row> one_row(Lab&) {
  Row row;
  row.claim.name = "a row";
  row.verdict = Verdict::pass;
  return {row};
}

std::vector<Row> two_rows(Lab& lab) { return {one_row(lab)[0], one_row(lab)[0]}; }

std::vector<Row> impossible(Lab&) { throw Error("it cannot be drawn"); }

constexpr Case made_up[] = {
    {"first", "two", two_rows}, {"second", "thrown", impossible}, {"second", "one", one_row}};

class StabilityTable : public ::testing::Test {
 protected:
  std::vector<Row> run_made_up(const std::function<void(const Case&)>& progress = {}) {
    Raycaster raycaster;
    Lab lab{raycaster};
    return run(lab, made_up, progress);
  }

  /// The rows of a case that fail with the shaders in this folder; without one, with those of the program.
  long failures(std::vector<Row> (*rows)(Lab&), const fs::path& shaders = {}) {
    Raycaster raycaster(shaders);
    Lab lab{raycaster, {16, 16}};
    return std::ranges::count(rows(lab), Verdict::fail, &Row::verdict);
  }

  crest::testing::DebugContext context;
};

TEST_F(StabilityTable, HasTheRowsOfAllCasesInTheirGroups) {
  std::vector<std::string_view> told;
  const auto rows = run_made_up([&](const Case& next) { told.push_back(next.name); });
  EXPECT_EQ(told, (std::vector<std::string_view>{"two", "thrown", "one"}));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1].group, "first");
  EXPECT_EQ(rows[3].group, "second");
}

TEST_F(StabilityTable, ACaseThatThrowsIsARowThatFails) {
  const Row row = run_made_up()[2];
  EXPECT_EQ(row.group, "second");
  EXPECT_EQ(row.claim.name, "thrown");
  EXPECT_EQ(row.claim.quantity, "it cannot be drawn");
  EXPECT_EQ(row.verdict, Verdict::fail);
}

TEST_F(StabilityTable, AStopEndsTheRun) {
  Raycaster raycaster;
  std::stop_source stop;
  Lab lab{raycaster, {16, 16}, stop.get_token()};
  std::vector<std::string_view> told;
  const auto stop_at_third = [&](const Case& next) {
    told.push_back(next.name);
    if (told.size() == 3) stop.request_stop();
  };
  const Case cases[] = {{"", "one", faint_and_opaque_haze},
                        {"", "two", touching_extrema},
                        {"", "three", touching_extrema},
                        made_up[0]};
  EXPECT_THROW(run(lab, cases, stop_at_third), Cancelled);
  EXPECT_EQ(told, (std::vector<std::string_view>{"one", "two", "three"}));
}

TEST_F(StabilityTable, NoCaseStandsInItTwice) {
  std::set<std::string_view> names;
  std::set<std::vector<Row> (*)(Lab&)> rows;
  for (const Case& one : all_cases()) {
    EXPECT_FALSE(one.group.empty());
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_TRUE(rows.insert(one.rows).second) << one.name;
  }
  EXPECT_GE(names.size(), 40U);
}

TEST_F(StabilityTable, NothingOrNoNumberDrawnFails) {
  ASSERT_EQ(failures(faint_and_opaque_haze), 0);
  ASSERT_EQ(failures(touching_extrema), 0);
  const std::string right = "out_color = collected;";
  EXPECT_GT(failures(faint_and_opaque_haze,
                     ChangedShaders("raycaster.frag", right, "out_color = vec4(0.0);").folder()),
            0);
  const std::string nan =
      "out_color = gl_FragCoord.x < 1.0 && gl_FragCoord.y < 1.0 ? vec4(uintBitsToFloat(0x7fc00000u)) : "
      "collected;";
  const ChangedShaders one_pixel("raycaster.frag", right, nan);
  EXPECT_GT(failures(faint_and_opaque_haze, one_pixel.folder()), 0);
  EXPECT_GT(failures(touching_extrema, one_pixel.folder()), 0);
}

TEST_F(StabilityTable, FaultsThatRenderersHaveAreNoticed) {
  struct {
    const char *file, *right, *wrong;
    std::vector<Row> (*rows)(Lab&);
  } const faults[] = {
      // Digits lost in 1 - exp(-x), where x is small
      {"compositing.glsl", "x < 0.01 ?", "x < 0.0 ?", extinction_times_step},
      // A root sought by the sign of a product: it misses samples on the isovalue
      {"peaks.glsl", "return inside0 != inside1;", "return (f0 - v) * (f1 - v) < 0.0;",
       samples_on_the_isovalue},
      // A touch taken for a crossing
      {"peaks.glsl", "(f1 == v && f0 >= v)", "f1 == v", touching_extrema},
      // A picture shifted by half a pixel
      {"ray.glsl", "gl_FragCoord.xy", "(gl_FragCoord.xy + 0.5)", mirrored},
  };
  for (const auto& fault : faults) {
    SCOPED_TRACE(fault.wrong);
    ASSERT_EQ(failures(fault.rows), 0);
    EXPECT_GT(failures(fault.rows, ChangedShaders(fault.file, fault.right, fault.wrong).folder()), 0);
  }
}

}  // namespace
}  // namespace crest::stability
