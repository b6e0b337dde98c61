#include "app/view_renderer.h"

#include <gtest/gtest.h>

#include "presets/preset_file.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"
#include "tests/debug_context.h"

namespace crest {
namespace {

class Views : public ::testing::Test {
 protected:
  Views() {
    const auto volume = std::make_shared<const Volume>(make_builtin("gyroid?n=24"));
    for (std::size_t i = 0; i < view_count; ++i) {
      requests[i] = {
          make_scene(volume, load_preset("dirac-shell")), whole_volume_camera(volume->grid, 1), {64, 48}};
      requests[i].scene.rendering.mode = view_modes[i];
    }
  }
  /// Works until nothing is left to do; how often that took.
  int finish(double budget_ms, bool interactive) {
    for (int calls = 1; calls < 100000; ++calls) {
      views.work(requests, budget_ms, interactive);
      if (!views.is_busy()) return calls;
    }
    return -1;
  }
  void expect_all_done() {
    EXPECT_EQ(views.error(), "");
    EXPECT_EQ(views.shown_versions(), views.wanted_versions());
    for (int i = 0; i < view_count; ++i) {
      const ViewPicture picture = views.picture(i);
      EXPECT_EQ(picture.coarseness, 1);
      EXPECT_EQ(picture.progress, 1);
      EXPECT_GT(picture.frame_ms, 0) << "the device's times came in";
      EXPECT_GT(picture.samples_per_ray, 0);
    }
  }

  testing::DebugContext context;
  ViewRenderer views;
  std::array<ViewRequest, view_count> requests;
};

TEST_F(Views, AreFinishedHoweverSmallTheBudget) {
  EXPECT_GT(finish(1e-3, true), view_count) << "a slice of a view at a time";
  expect_all_done();
  for (ViewRequest& request : requests) request.camera.fov_y_degrees += 1;
  EXPECT_GT(finish(1e9, false), 0);
  expect_all_done();
}

// A table for one step length is made once an edit: a coarse picture, which would step further, takes the
// same.
TEST_F(Views, ACoarsePictureMakesNoTableOfItsOwn) {
  for (std::size_t i = 1; i < view_count; ++i) requests[i].size = {0, 0};
  requests[0].size = {512, 384};  // takes so long that a coarse picture comes first
  requests[0].scene.rendering.mode = Mode::dvr_only;
  requests[0].scene.rendering.skipping = false;
  const auto made_by_an_edit = [&](ClassificationMethod method) {
    requests[0].scene.rendering.classification = method;
    requests[0].scene.rendering.placement = Placement::entry;
    finish(1e-3, true);
    const auto& held = views.renderer().resources().held;
    const int before = held.made();
    requests[0].scene.tf.points.front().color.r += 0.01;
    EXPECT_GT(finish(1e-3, true), 2) << "coarse, full and counted";
    EXPECT_EQ(views.error(), "");
    return held.made() - before;
  };
  const int with_a_table = made_by_an_edit(ClassificationMethod::preintegrated_table);
  EXPECT_EQ(with_a_table, 2) << "the classification, and one table";
}

// What cannot be drawn leaves nothing behind that keeps the others from being drawn and timed.
TEST_F(Views, AViewThatCannotBeDrawnDoesNotStopTheOthers) {
  requests[0].camera.target = requests[0].camera.eye;  // no view
  EXPECT_GT(finish(5, false), 0);
  EXPECT_NE(views.error(), "");
  for (int i = 1; i < view_count; ++i) EXPECT_GT(views.picture(i).frame_ms, 0);
  requests[0] = requests[1];
  EXPECT_GT(finish(5, false), 0);
  expect_all_done();
}

}  // namespace
}  // namespace crest
