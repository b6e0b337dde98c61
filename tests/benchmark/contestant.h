#pragma once

#include <filesystem>

#include "render/measure/timing.h"
#include "render/raycaster/raycaster.h"
#include "render/scene/camera.h"
#include "tests/benchmark/feature_cases.h"

namespace crest::bench {

/// A frame with a ray caster of its own, so that it keeps its textures and tables.
class Contestant {
 public:
  Contestant(const Frame& frame, glm::ivec2 size, const std::filesystem::path& shaders = {})
      : scene_(frame.scene),
        camera_(whole_volume_camera(scene_.volume->grid, 1)),
        target_(size, frame.counts),
        raycaster_(shaders) {
    raycaster_.force(frame.forced);
    if (frame.in_bricks) raycaster_.resources().whole_volume_bytes = 0;
    draw_ms();  // uploads and compiles
  }
  double draw_ms() {
    return finished_ms([&] { raycaster_.draw(scene_, camera_, target_); });
  }
  /// What a change of the TF takes, beside a draw of next to nothing.
  double edit_ms(const std::function<void(TransferFunction&)>& edit) {
    edit(scene_.tf);
    const double edited = draw_pixel_ms();
    return edited - draw_pixel_ms();
  }
  double samples() {
    gl::RenderTarget counted(target_.size(), true);
    return raycaster_.draw_counted(scene_, camera_, counted).samples;
  }

 private:
  double draw_pixel_ms() {
    return finished_ms([&] { raycaster_.draw(scene_, camera_, target_, {{0, 0}, {1, 1}}); });
  }

  Scene scene_;
  Camera camera_;
  gl::RenderTarget target_;
  Raycaster raycaster_;
};

}  // namespace crest::bench
