#include "tests/convergence/order.h"

namespace crest::testing {
namespace {

TEST_F(Order, MidpointOfASmoothFieldIsTwoInTheStep) {
  const auto volume = make_volume(unit_cube(33), transversal);
  constexpr double steps[] = {8, 4, 2, 1, 0.5, 0.25};
  const OrderFit fitted = order_in_step(
      "step, smooth TF, DVR_ONLY", scene_of(volume, smooth_tf(), Mode::dvr_only), Answer::integral, steps);
  EXPECT_NEAR(fitted.order, 2, 0.2);
}

TEST_F(Order, AJumpInTheTfMakesItOne) {
  const auto volume = make_volume(unit_cube(33), transversal);
  const auto tf = make_tf(
      {point(-0.3, 0.1, blue), point(0.5, 0.1, blue), point(0.5, 0.7, orange), point(1.3, 0.7, orange)}, 0.6);
  constexpr double steps[] = {4, 2, 1, 0.5, 0.25, 0.125};
  const OrderFit fitted = order_in_step("step, TF with a jump, DVR_ONLY",
                                        scene_of(volume, tf, Mode::dvr_only), Answer::integral, steps);
  EXPECT_NEAR(fitted.order, 1, 0.2);
}

// The product's argument: what a spike costs plain sampling, and what peak finding gives back.
TEST_F(Order, ASpikeAndPeakFinding) {
  const auto volume = make_volume(unit_cube(33), transversal);
  const auto tf = spike_tf(2e-3);
  constexpr double steps[] = {8, 4, 2, 1, 0.5, 0.25};
  const OrderFit plain =
      order_in_step("step, spike, DVR_ONLY", scene_of(volume, tf, Mode::dvr_only), Answer::integral, steps);
  EXPECT_GT(plain.order, -0.2);
  EXPECT_LT(plain.order, 1.2);
  const OrderFit paper = order_in_step("step, spike, PEAK_XOR_DVR as in the paper",
                                       scene_of(volume, tf, Mode::peak_xor_dvr, PeakForm::paper),
                                       Answer::base_and_crossings, steps);
  EXPECT_NEAR(paper.order, 1, 0.2);
  const OrderFit split = order_in_step("step, spike, PEAK_XOR_DVR split",
                                       scene_of(volume, tf, Mode::peak_xor_dvr, PeakForm::split),
                                       Answer::base_and_crossings, steps);
  EXPECT_NEAR(split.order, 2, 0.2);
}

TEST_F(Order, TrilinearIsTwoInTheGrid) {
  const FormulaField formula{transversal, gradient_of_transversal};
  std::vector<double> spacings, errors;
  for (const int n : {5, 9, 17, 33, 65}) {
    Scene scene = scene_of(make_volume(unit_cube(n), transversal), smooth_tf(), Mode::dvr_only);
    const Camera camera = whole_volume_camera(scene.volume->grid, 1, 20);
    const Image truth = render_reference(formula, scene, camera, small, Answer::integral).image();
    scene.rendering.step = (n - 1) / 512.0;  // the same in the world: its error is small beside the grid's
    spacings.push_back(1.0 / (n - 1));
    errors.push_back(rmse(render(scene, camera, small), truth));
  }
  EXPECT_NEAR(fit("grid, smooth TF, DVR_ONLY", spacings, errors).order, 2, 0.2);
}

/// The picture at a place of the image plane, [0,1]^2: its nearest pixel, or bilinear between pixel centres.
glm::dvec4 reconstruct(const Image& image, glm::dvec2 place, bool bilinear) {
  const glm::dvec2 position = place * glm::dvec2(image.size) - 0.5;
  if (!bilinear) return glm::dvec4(image.at(int(std::lround(position.x)), int(std::lround(position.y))));
  const glm::ivec2 corner = glm::clamp(glm::ivec2(glm::floor(position)), glm::ivec2(0), image.size - 2);
  const glm::dvec2 w = position - glm::dvec2(corner);
  const auto pixel = [&](int x, int y) { return glm::dvec4(image.at(corner.x + x, corner.y + y)); };
  return glm::mix(glm::mix(pixel(0, 0), pixel(1, 0), w.x), glm::mix(pixel(0, 1), pixel(1, 1), w.x), w.y);
}

TEST_F(Order, ThePixelIsOneForNearestAndTwoForBilinear) {
  Scene scene = scene_of(make_volume(unit_cube(129), transversal), smooth_tf(), Mode::dvr_only);
  const Camera camera = along_z(scene.volume->grid, 0.8);  // no edge of the volume in the picture
  const Image fine = render(scene, camera, {384, 384});
  for (const bool bilinear : {false, true}) {
    std::vector<double> sizes, errors;
    for (const int n : {6, 12, 24, 48, 96}) {
      const Image coarse = render(scene, camera, glm::ivec2(n));
      double sum = 0;
      int count = 0;
      for (int y = 32; y < 352; ++y)  // where even the coarsest has pixels around
        for (int x = 32; x < 352; ++x, ++count) {
          const glm::dvec4 d =
              reconstruct(coarse, (glm::dvec2(x, y) + 0.5) / 384.0, bilinear) - glm::dvec4(fine.at(x, y));
          sum += glm::dot(d, d) / 4;
        }
      sizes.push_back(0.8 / n);
      errors.push_back(std::sqrt(sum / count));
    }
    EXPECT_NEAR(fit(bilinear ? "pixel, bilinear" : "pixel, nearest", sizes, errors).order, bilinear ? 2 : 1,
                0.2);
  }
}

// A surface that a ray only grazes is entered and left within one step: at the silhouette of radius R the
// steps of length h lose a rim that is h^2/(8R) wide. So the mean error is of order 2, RMSE of order 1, and
// the largest never falls.
TEST_F(Order, SilhouettesOfPeakOnly) {
  const auto volume = make_volume(Grid{glm::ivec3(129), glm::dvec3(1), glm::dvec3(0)}, [](glm::dvec3 p) {
    return 60 - glm::length(p - glm::dvec3(63.2, 64.3, 65.1));
  });
  const auto tf =
      make_tf({point(-60, 0), point(19.9, 0), point(20, 0.6, orange), point(20.1, 0), point(60, 0)});
  // So few pixels are lost in the split form that their number depends on the view: it is this one
  const Camera camera{
      {336.248, -419.996, 305.998}, glm::dvec3(64), {0, 0, 1}, 20, Projection::perspective, {}};
  const glm::ivec2 size(512);
  for (const PeakForm form : {PeakForm::paper, PeakForm::split}) {
    Scene scene = scene_of(volume, tf, Mode::peak_only, form);
    const Image truth = render_reference(scene, camera, size, Answer::crossings).image();
    constexpr double steps[] = {32, 16, 8, 4, 2};
    std::vector<double> mean, root_mean_square, largest;
    for (const double step : steps) {
      scene.rendering.step = step;
      const Image image = render(scene, camera, size);
      double sum = 0, most = 0;
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const double d = std::abs(double(image.pixels[i].a) - double(truth.pixels[i].a));
        sum += d;
        most = std::max(most, d);
      }
      mean.push_back(sum / double(image.pixels.size()));
      root_mean_square.push_back(rmse(image, truth));
      largest.push_back(most);
    }
    const std::string name =
        form == PeakForm::paper ? "step, silhouettes, paper form, " : "step, silhouettes, split form, ";
    const double bound = form == PeakForm::paper ? 0.2 : 0.4;  // few pixels are lost at all in the split form
    EXPECT_NEAR(fit((name + "mean").c_str(), steps, mean).order, 2, bound);
    EXPECT_NEAR(fit((name + "RMSE").c_str(), steps, root_mean_square).order, 1, bound);
    EXPECT_NEAR(fit((name + "maximum").c_str(), steps, largest).order, 0, 0.05);
  }
}

}  // namespace
}  // namespace crest::testing
