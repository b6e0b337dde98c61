// How much of a surface each mode shows where the TF is a spike, and how much of it is right.
#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

#include "render/files/load.h"
#include "render/measure/image_error.h"
#include "render/reference/reference.h"
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

/// Shares of the pixels whose ray crosses the isovalue, by brute force.
struct Coverage {
  double shown = 0;  ///< an alpha over 1/255
  double right = 0;  ///< within 1/255 of the exact answer of the mode
};

std::string text_of(const Coverage& c) { return fmt::format("{:.4f} / {:.4f}", c.shown, c.right); }

class NearDirac : public RaycasterTest {
 protected:
  static constexpr glm::ivec2 size{384, 384};

  void load(const std::string& source, double normalized_value, const std::optional<Camera>& view = {}) {
    volume = std::make_shared<const Volume>(load_volume(source));
    tf = resolve(near_dirac(normalized_value), volume->statistics.range, volume->grid.smallest_spacing());
    camera = view.value_or(whole_volume_camera(volume->grid, 1));
    const double isovalue = tf.points[2].value;
    has_surface.clear();
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        has_surface.push_back(
            brute_crossings(*volume, brute_ray(camera, volume->grid, size, x, y), isovalue, 32) > 0);
    surface_pixels = int(std::ranges::count(has_surface, 1));
    exact_surface = exact_image(Mode::peak_only);
    exact_volume = exact_image(Mode::dvr_only);
  }

  Coverage coverage(Mode mode, PeakForm form = PeakForm::split,
                    ClassificationMethod classification = ClassificationMethod::post) {
    Scene scene{volume, tf, {}};
    scene.rendering.mode = mode;
    scene.rendering.peak_form = form;
    scene.rendering.step = 0.5;
    scene.rendering.classification = classification;
    const Image image = render(scene, camera, size);
    // But for the spike nothing is there: the base TF is clear
    const auto differences = pixel_differences(mode == Mode::dvr_only ? exact_volume : exact_surface, image);
    Coverage result;
    for (std::size_t i = 0; i < has_surface.size(); ++i) {
      if (!has_surface[i]) continue;
      result.shown += (image.pixels[i].a > 1.0f / 255) / double(surface_pixels);
      result.right += (differences[i] <= 1.0f / 255) / double(surface_pixels);
    }
    return result;
  }

  struct Coverages {
    Coverage peaks, both, paper, analytic, dvr;
  };
  /// All of them, printed as a row of docs/measured.md.
  Coverages measure(const std::string& name) {
    const Coverages c{coverage(Mode::peak_only), coverage(Mode::peak_xor_dvr),
                      coverage(Mode::peak_only, PeakForm::paper),
                      coverage(Mode::peak_xor_dvr, PeakForm::split, ClassificationMethod::analytic),
                      coverage(Mode::dvr_only)};
    fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", name, surface_pixels, text_of(c.analytic),
               text_of(c.peaks), text_of(c.both), text_of(c.paper), text_of(c.dvr));
    return c;
  }

  static void expect_exact(const Coverage& analytic) {
    EXPECT_GE(analytic.shown, 0.9999);
    EXPECT_GE(analytic.right, 0.9999);
  }

  /// `right_at_least`: of the sampled methods that look for peaks.
  void expect_found_by_peaks_alone(const std::string& name, double right_at_least) {
    const Coverages c = measure(name);
    EXPECT_GT(surface_pixels, 500);
    expect_exact(c.analytic);
    EXPECT_GE(c.peaks.shown, 0.999);
    EXPECT_GE(c.both.shown, 0.999);
    // A pixel that shows the surface may have missed another one in front of it or behind it
    for (const Coverage& sampled : {c.peaks, c.both}) {
      EXPECT_GE(sampled.right, right_at_least);
      EXPECT_LE(sampled.right, c.analytic.right);
    }
    // The rule of signs alone loses more: surfaces that are entered and left within one step
    EXPECT_LT(c.paper.shown, c.peaks.shown);
    EXPECT_LT(c.paper.right, c.peaks.right);
    EXPECT_LT(c.dvr.shown, 0.05);
  }

  std::shared_ptr<const Volume> volume;
  TransferFunction tf;
  Camera camera;
  std::vector<char> has_surface;
  int surface_pixels = 0;
  Image exact_surface, exact_volume;

 private:
  Image exact_image(Mode mode) const {
    Scene scene{volume, tf, {}};
    scene.rendering.mode = mode;
    return render_reference(scene, camera, size, answers_of(scene.rendering).front(), 1e-8).image();
  }
};

TEST_F(NearDirac, Plume) {
  load("builtin:plume", 0.4, sees_unit_cube);  // the view of docs/measured.md
  expect_found_by_peaks_alone("builtin:plume, 0.4", 0.995);
}

TEST_F(NearDirac, RealVolume) {
  const char* given = std::getenv("CREST_DATA");
  const std::filesystem::path data =
      given ? std::filesystem::path(given) : test::source_folder() / "../shared/data";
  const auto file = data / "engine.nii.gz";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no real volumes here: set CREST_DATA to their folder";
  load(file.string(), 0.3034);
  expect_found_by_peaks_alone("engine, 0.3034", 0.999);
}

// CREST_NEAR_DIRAC="VOLUME@VALUE ..." prints a row for each: volumes as on the command line, values as shares
// of their range.
TEST_F(NearDirac, GivenVolumes) {
  const char* given = std::getenv("CREST_NEAR_DIRAC");
  if (!given) GTEST_SKIP() << "set CREST_NEAR_DIRAC to VOLUME@VALUE, or several with spaces between";
  std::istringstream words{given};
  for (std::string word; words >> word;) {
    const std::size_t at = word.rfind('@');
    ASSERT_NE(at, word.npos) << word << " is not VOLUME@VALUE";
    const std::string source = word.substr(0, at), value = word.substr(at + 1);
    const bool is_builtin = source.starts_with("builtin:");
    load(source, std::stod(value), is_builtin ? std::optional(sees_unit_cube) : std::nullopt);
    const auto name = is_builtin ? source : std::filesystem::path(source).filename().string();
    expect_exact(measure(fmt::format("{}, {}", name, value)).analytic);
  }
}

}  // namespace
}  // namespace crest::testing
