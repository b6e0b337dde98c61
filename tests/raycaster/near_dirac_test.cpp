#include <cstdlib>
#include <filesystem>
#include <optional>

#include "render/files/load.h"
#include "tests/paths.h"
#include "tests/raycaster/brute_force.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

/// A spike of width 1e-4 of the range, opacity 0.9, and nothing else.
TransferFunction near_dirac(double value) {
  auto tf = make_tf(
      {point(0, 0), point(value - 0.5e-4, 0), point(value, 0.9), point(value + 0.5e-4, 0), point(1, 0)});
  tf.domain = Domain::normalized;
  tf.unit = LengthUnit::voxel;
  return tf;
}

struct Coverage {
  int surface = 0;   ///< pixels whose ray crosses the isovalue, by brute force
  double share = 0;  ///< of them, those that show it
};

class NearDirac : public RaycasterTest {
 protected:
  static constexpr glm::ivec2 size{384, 384};

  void load(const std::string& source, double normalized_value, const std::optional<Camera>& view = {}) {
    volume = std::make_shared<const Volume>(load_volume(source));
    tf = resolve(near_dirac(normalized_value), volume->statistics.range, volume->grid.smallest_spacing());
    camera = view.value_or(whole_volume_camera(volume->grid, 1));
    const double isovalue = tf.points[2].value;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        has_surface.push_back(
            brute_crossings(*volume, brute_ray(camera, volume->grid, size, x, y), isovalue, 32) > 0);
  }

  Coverage coverage(Mode mode, PeakForm form = PeakForm::split) {
    Scene scene{volume, tf, {}};
    scene.rendering.mode = mode;
    scene.rendering.peak_form = form;
    scene.rendering.step = 0.5;
    const Image image = render(scene, camera, size);
    Coverage result;
    int shown = 0;
    for (std::size_t i = 0; i < has_surface.size(); ++i) {
      result.surface += has_surface[i];
      shown += has_surface[i] && image.pixels[i].a > 1.0f / 255;
    }
    result.share = double(shown) / result.surface;
    return result;
  }

  void expect_found_by_peaks_alone() {
    EXPECT_GT(coverage(Mode::peak_only).surface, 500);
    EXPECT_GE(coverage(Mode::peak_only).share, 0.999);
    EXPECT_GE(coverage(Mode::peak_xor_dvr).share, 0.999);
    // The rule of signs alone loses more: surfaces that are entered and left within one step
    EXPECT_LT(coverage(Mode::peak_only, PeakForm::paper).share, coverage(Mode::peak_only).share);
    EXPECT_LT(coverage(Mode::dvr_only).share, 0.05);
    std::printf(
        "surface pixels %d; shown: PEAK_ONLY %.4f (paper form %.4f), PEAK_XOR_DVR %.4f, DVR_ONLY %.4f\n",
        coverage(Mode::peak_only).surface, coverage(Mode::peak_only).share,
        coverage(Mode::peak_only, PeakForm::paper).share, coverage(Mode::peak_xor_dvr).share,
        coverage(Mode::dvr_only).share);
  }

  std::shared_ptr<const Volume> volume;
  TransferFunction tf;
  Camera camera;
  std::vector<char> has_surface;
};

TEST_F(NearDirac, Plume) {
  load("builtin:plume", 0.4, sees_unit_cube);  // the view of docs/measured.md
  expect_found_by_peaks_alone();
}

TEST_F(NearDirac, RealVolume) {
  const char* given = std::getenv("CREST_DATA");
  const std::filesystem::path data =
      given ? std::filesystem::path(given) : test::source_folder() / "../shared/data";
  const auto file = data / "engine.nii.gz";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no real volumes here: set CREST_DATA to their folder";
  load(file.string(), 0.3034);
  expect_found_by_peaks_alone();
}

}  // namespace
}  // namespace crest::testing
