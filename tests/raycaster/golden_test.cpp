#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "presets/preset_file.h"
#include "render/volume/builtin.h"
#include "tests/paths.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

namespace fs = std::filesystem;

struct GoldenCase {
  const char *name, *volume, *preset;
  Mode mode;
  PeakForm form;
};

void PrintTo(const GoldenCase& golden, std::ostream* out) { *out << golden.name; }

class Golden : public RaycasterTest, public ::testing::WithParamInterface<GoldenCase> {};

constexpr glm::ivec2 size{96, 96};

/// Pictures are kept as 8-bit PNG over black. To accept new ones: CREST_UPDATE_GOLDEN=1, and look at them.
TEST_P(Golden, IsWhatItWas) {
  const GoldenCase& golden = GetParam();
  Scene scene =
      make_scene(std::make_shared<const Volume>(make_builtin(golden.volume)), load_preset(golden.preset));
  scene.rendering.mode = golden.mode;
  scene.rendering.peak_form = golden.form;
  const Image image = over_background(render(scene, sees_unit_cube, size), glm::vec3(0));

  const fs::path kept = test::source_folder() / "tests/data/golden" / (std::string(golden.name) + ".png");
  if (std::getenv("CREST_UPDATE_GOLDEN")) write_image(kept, image, glm::vec3(0));
  const Image expected = read_image(kept);
  ASSERT_EQ(expected.size, image.size);
  // Half a step is lost to the file's 8 bits. A silhouette may move by rounding on another driver: very few
  // pixels.
  int off = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    off += glm::any(glm::greaterThan(glm::abs(image.pixels[i] - expected.pixels[i]), glm::vec4(1.5f / 255)));
  EXPECT_LE(off, 5);
}

INSTANTIATE_TEST_SUITE_P(
    All, Golden,
    ::testing::Values(
        GoldenCase{"shell-dvr", "plume?n=48", "dirac-shell", Mode::dvr_only, PeakForm::split},
        GoldenCase{"shell-peaks", "plume?n=48", "dirac-shell", Mode::peak_only, PeakForm::split},
        GoldenCase{"shell-xor", "plume?n=48", "dirac-shell", Mode::peak_xor_dvr, PeakForm::split},
        GoldenCase{"shell-xor-paper", "plume?n=48", "dirac-shell", Mode::peak_xor_dvr, PeakForm::paper},
        GoldenCase{"four-both", "gyroid?n=48", "four-peaks", Mode::both, PeakForm::split},
        GoldenCase{"onion-peaks", "sphere?n=48", "onion", Mode::peak_only, PeakForm::split},
        GoldenCase{"vessels-xor", "vessels?n=64", "vessels-shell", Mode::peak_xor_dvr, PeakForm::split}),
    [](const auto& param) {
      std::string name = param.param.name;
      std::ranges::replace(name, '-', '_');
      return name;
    });

}  // namespace
}  // namespace crest::testing
