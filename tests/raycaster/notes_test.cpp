#include "render/notes.h"

#include <functional>
#include <limits>

#include "render/renderer.h"

#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

using Notes = RaycasterTest;

constexpr glm::ivec2 size{16, 16};

TransferFunction haze(double low = 0, double high = 1) {
  return make_tf({point(low, 0.1), point((low + high) / 2, 0.9), point(high, 0.1)});
}

Scene ramp_scene() {
  const Grid grid{glm::ivec3(8), glm::dvec3(1), glm::dvec3(0)};
  return {make_volume(grid, [](glm::dvec3 p) { return p.x / 7; }), haze(), {}};
}

Scene scene_of_values(const std::function<double(glm::dvec3)>& formula) {
  Scene scene = ramp_scene();
  scene.volume = make_volume(scene.volume->grid, formula);
  return scene;
}

std::vector<std::string> notes_of(Renderer& renderer, const Scene& scene, const Camera& camera) {
  gl::RenderTarget target(size, false);
  renderer.draw(scene, camera, target);
  return picture_notes(scene, camera, target.read_color());
}

// Samples beside a region whose value is that of a step, a spike or a surface fall on either side of it.
TEST_F(Notes, TellOfRegionsOnEdges) {
  Scene labels = scene_of_values([](glm::dvec3 p) { return p.x < 3.5 ? 0.0 : 1.0; });
  const auto notes = [&](const TransferFunction& tf, Mode mode, ClassificationMethod method) {
    labels.tf = tf;
    labels.rendering.mode = mode;
    labels.rendering.classification = method;
    return scene_notes(labels);
  };
  const TransferFunction step = make_tf({point(0, 0), point(1, 0), point(1, 0.9)}),
                         beside = make_tf({point(0, 0), point(0.5, 0), point(0.5, 0.9)}),
                         wide = make_tf({point(0, 0), point(1, 0.9), point(2, 0)});
  const auto post = ClassificationMethod::post;
  ASSERT_EQ(notes(step, Mode::dvr_only, post).size(), 1);
  EXPECT_NE(notes(step, Mode::dvr_only, post)[0].find("--exact"), std::string::npos);
  EXPECT_TRUE(notes(step, Mode::dvr_only, ClassificationMethod::analytic).empty());
  EXPECT_TRUE(notes(beside, Mode::dvr_only, post).empty());
  EXPECT_TRUE(notes(wide, Mode::dvr_only, post).empty()) << "no edge, but a surface";
  EXPECT_EQ(notes(wide, Mode::peak_only, post).size(), 1);
}

TEST_F(Notes, SayWhyAPictureShowsNothing) {
  const Camera camera = whole_volume_camera(ramp_scene().volume->grid, 1);
  Camera away = camera;
  away.target = 2.0 * camera.eye - camera.target;
  Scene transparent = ramp_scene(), hidden = ramp_scene(), beside = ramp_scene(), black = ramp_scene();
  for (ControlPoint& p : transparent.tf.points) p.opacity = 0;
  hidden.rendering.clip_box = ClipBox{{100, 0, 0}, {101, 7, 7}, {}};
  beside.tf = make_tf({point(2, 0), point(3, 0.9), point(4, 0)});
  for (ControlPoint& p : black.tf.points) p.color = glm::dvec3(0);
  Scene no_peak = ramp_scene();
  no_peak.tf = make_tf({point(0, 0), point(1, 0.9)});
  no_peak.rendering.mode = Mode::peak_only;
  const auto nothing = [](glm::dvec3) { return std::numeric_limits<double>::quiet_NaN(); };

  struct Case {
    const char* name;
    Scene scene;
    Camera camera;
    std::vector<const char*> parts;  ///< of one note each
  };
  const std::vector<Case> cases{
      {"ordinary", ramp_scene(), camera, {}},
      {"all NaN", scene_of_values(nothing), camera, {"No voxel has a value"}},
      {"constant", scene_of_values([](glm::dvec3) { return 0.5; }), camera, {"constant: every value is 0.5"}},
      {"beside", beside, camera, {"from 2 to 4, lies in the volume's range, from 0 to 1", "shows nothing"}},
      {"turned away", ramp_scene(), away, {"the camera does not see the volume"}},
      {"clipped", hidden, camera, {"the clip box leaves nothing of the volume"}},
      {"transparent", transparent, camera, {"the transfer function shows nothing in the volume's range"}},
      {"no peak", no_peak, camera, {"the mode is PEAK_ONLY, and the transfer function has no peak"}},
      {"black on black", black, camera, {"the background's colour"}}};
  Renderer renderer;
  for (const Case& one : cases) {
    const auto notes = notes_of(renderer, one.scene, one.camera);
    ASSERT_EQ(notes.size(), one.parts.size()) << one.name;
    for (std::size_t i = 0; i < notes.size(); ++i)
      EXPECT_NE(notes[i].find(one.parts[i]), std::string::npos) << one.name << ": " << notes[i];
  }
}

TEST_F(Notes, AHalfStepOfAFileIsSeen) {
  Image image{{2, 1}, {glm::vec4(0), glm::vec4(0)}};
  EXPECT_FALSE(has_visible_pixel(image, glm::vec3(0)));
  image.pixels[1] = glm::vec4(0, 0.4F / 255, 0, 0.4F / 255);
  EXPECT_FALSE(has_visible_pixel(image, glm::vec3(0)));
  image.pixels[1].g = 0.6F / 255;
  EXPECT_TRUE(has_visible_pixel(image, glm::vec3(0)));
  // White over white is not seen, black is; what is no number is no background
  image.pixels[1] = glm::vec4(1);
  EXPECT_FALSE(has_visible_pixel(image, glm::vec3(1)));
  image.pixels[1] = glm::vec4(0, 0, 0, 1);
  EXPECT_TRUE(has_visible_pixel(image, glm::vec3(1)));
  image.pixels[1].r = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(has_visible_pixel(image, glm::vec3(0)));
}

}  // namespace
}  // namespace crest::testing
