#include "render/slices/slice.h"

#include "render/volume/probe.h"
#include "tests/ui/harness.h"

namespace crest::test {
namespace {

class Slices : public Studio {
 protected:
  Slices() {
    EXPECT_FALSE(frame().slices);
    click("tab/Slices");
    frames(3);
  }
  ImVec2 place_in(const std::string& slice, double x, double y) const {
    const auto& [low, high] = state->widgets.items.at(slice);
    return {low.x + float(x) * (high.x - low.x), low.y + float(y) * (high.y - low.y)};
  }
};

TEST_F(Slices, AreAskedForInTheirShape) {
  ASSERT_TRUE(requests.slices);
  EXPECT_EQ(requests.slices->cursor, glm::dvec3(0.5));
  for (const glm::ivec2 size : requests.slices->pixels) {
    EXPECT_GT(size.x, 100);
    EXPECT_NEAR(size.x, size.y, 1);
  }
  volume.grid.spacing = {1, 1, 3};
  frames(2);
  EXPECT_NEAR(requests.slices->pixels[0].y / double(requests.slices->pixels[0].x), 3, 0.1);
  EXPECT_NEAR(requests.slices->pixels[2].x, requests.slices->pixels[2].y, 1);
}

TEST_F(Slices, ADragMovesTheCursorOfTheOthers) {
  drag(place_in("slice/z", 0.5, 0.5), place_in("slice/z", 0.25, 0.2));
  frames(1);
  EXPECT_NEAR(requests.slices->cursor.x, 0.25, 0.01);
  EXPECT_NEAR(requests.slices->cursor.y, 0.8, 0.01);  // up is greater
  EXPECT_EQ(requests.slices->cursor.z, 0.5);
  drag(place_in("slice/x", 0.5, 0.5), place_in("slice/x", 2, -1));  // beyond its edges
  frames(1);
  EXPECT_NEAR(requests.slices->cursor.x, 0.25, 0.01);
  EXPECT_EQ(requests.slices->cursor.y, 1);
  EXPECT_EQ(requests.slices->cursor.z, 1);
}

TEST_F(Slices, TheWheelGoesFromPointToPoint) {
  move_to(place_in("slice/y", 0.3, 0.3));
  frames(1);
  wheel(1);
  frames(1);
  EXPECT_NEAR(state->slice_cursor.y, 7 / 11.0, 1e-12);  // of 12 points; from the middle to the next but one
  wheel(-2);
  frames(1);
  EXPECT_NEAR(state->slice_cursor.y, 5 / 11.0, 1e-12);
  EXPECT_FALSE(state->history.can_undo(document)) << "looking is no edit";
}

TEST_F(Slices, ASpikeIsAddedAtTheCursorsValue) {
  state->slice_cursor = {0.3, 0.7, 0.45};
  frames(1);
  const double value = *value_at(volume, {}, state->slice_cursor);
  click("add spike here");
  frames(2);
  EXPECT_NEAR(tf().points[state->editor.selection.at(0)].value, value, 0.02);
  ctrl('Z');
  tf() = in_domain(tf(), Domain::normalized, volume.statistics.range);
  frames(2);
  click("add spike here");
  EXPECT_NEAR(tf().points[state->editor.selection.at(0)].value, value / 100, 0.0002);
}

TEST_F(Slices, WithoutAVolumeThereAreNone) {
  inputs.volume = nullptr;
  frames(2);
  EXPECT_FALSE(requests.slices);
  EXPECT_FALSE(has("slice/z"));
}

}  // namespace
}  // namespace crest::test
