#pragma once

#include <algorithm>

#include "presets/preset_file.h"
#include "render/renderer.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {

/// What pictures of the same samples may differ by. Positions are rounded to 2^-24 of the box's longest side
/// either way and compositing to 2^-24 a sample, and the scenes' materials change little over such lengths.
constexpr double rounding = 4e-6;

inline std::shared_ptr<const Volume> builtin(const char* query) {
  return std::make_shared<const Volume>(make_builtin(query));
}

/// A scene of the library that VDLS renders.
inline Scene dvr_scene(std::shared_ptr<const Volume> volume, const char* preset, double step = 0.5) {
  Scene scene = make_scene(std::move(volume), load_preset(preset));
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.shading = Shading::none;
  scene.rendering.step = step;
  return scene;
}

/// One context and one renderer for all tests of a suite: what was drawn before must not matter.
class VdlsTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { gpu_ = std::make_unique<Gpu>(); }
  static void TearDownTestSuite() { gpu_.reset(); }

  Image render(Scene scene, const Camera& camera, glm::ivec2 size, Engine engine) {
    scene.rendering.engine = engine;
    gl::RenderTarget target(size, false);
    renderer.draw(scene, camera, target);
    return target.read_color();
  }
  /// How far VDLS with these options is from the ray caster.
  double difference(Scene scene, const Camera& camera, const VdlsOptions& options,
                    glm::ivec2 size = {40, 40}) {
    scene.rendering.vdls = options;
    return largest_difference(render(scene, camera, size, Engine::vdls),
                              render(scene, camera, size, Engine::raycaster));
  }
  std::vector<PixelCounts> counts(Scene scene, const Camera& camera, glm::ivec2 size, Engine engine) {
    scene.rendering.engine = engine;
    gl::RenderTarget target(size, true);
    return renderer.draw_counts(scene, camera, target);
  }

 private:
  struct Gpu {
    DebugContext context;
    Renderer renderer;
  };
  static inline std::unique_ptr<Gpu> gpu_;

 protected:
  Renderer& renderer = gpu_->renderer;
};

}  // namespace crest::testing
