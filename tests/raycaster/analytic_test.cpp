// The exact march (rendering.classification analytic) against the exact answer on the CPU.
#include <fmt/core.h>

#include "presets/choices.h"
#include "presets/names.h"
#include "render/measure/image_error.h"
#include "render/reference/reference.h"
#include "tests/raycaster/fixture.h"
#include "tests/raycaster/random_view.h"

namespace crest::testing {
namespace {

constexpr Mode modes[] = {Mode::dvr_only, Mode::peak_only, Mode::peak_xor_dvr, Mode::both};

class Analytic : public RaycasterTest {
 protected:
  struct Drawn {
    Image image;
    std::vector<std::uint32_t> crossings;
  };
  Drawn draw(const Scene& scene, const Camera& camera, glm::ivec2 size) {
    gl::RenderTarget target(size, true);
    Drawn drawn;
    for (const PixelCounts& counts : raycaster.draw_counts(scene, camera, target))
      drawn.crossings.push_back(counts.crossings);
    drawn.image = target.read_color();
    return drawn;
  }

  ImageError error_of(Scene scene, const Camera& camera, glm::ivec2 size) {
    scene.rendering.classification = ClassificationMethod::analytic;
    const ExactAnswer exact = exact_answers_of(scene.rendering).front();
    const Reference truth = render_reference(scene, camera, size, exact.answer, 1e-6);
    const Drawn drawn = draw(scene, camera, size);
    return image_error(truth, drawn.image, drawn.crossings, glm::vec3(0));
  }
};

/// A random scene that the exact march draws.
View analytic_view(std::uint64_t seed) {
  View view = random_view(seed);
  Rendering& r = view.scene.rendering;
  r.classification = ClassificationMethod::analytic;
  r.filter = Filter::linear;
  r.root_filter.reset();
  r.shading = Shading::none;
  r.early_termination = 0;
  return view;
}

TEST_F(Analytic, RandomScenesAreExact) {
  double pixels = 0, wrong = 0, crossings = 0, missed = 0, invented = 0, largest = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const View view = analytic_view(seed);
    const ImageError error = error_of(view.scene, view.camera, {24, 24});
    pixels += double(error.compared.pixels);
    wrong += error.compared.share * double(error.compared.pixels);
    if (error.compared.share > 0)
      fmt::print("seed {}: {} of {} wrong, {:.3g} at most ({}), missed {} invented {}\n", seed,
                 std::round(error.compared.share * double(error.compared.pixels)), error.compared.pixels,
                 error.compared.max, name_of(view.scene.rendering.mode), error.crossings->missed,
                 error.crossings->invented);
    largest = std::max(largest, error.compared.max);
    crossings += error.crossings->exact;
    missed += error.crossings->missed;
    invented += error.crossings->invented;
  }
  fmt::print("{} pixels, {} wrong, {} crossings, {} missed, {} invented, largest {}\n", pixels, wrong,
             crossings, missed, invented, largest);
  EXPECT_GT(pixels, 40000);
  EXPECT_LE(wrong, 1e-4 * pixels);
}

}  // namespace
}  // namespace crest::testing
