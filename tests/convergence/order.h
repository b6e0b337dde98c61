#pragma once

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "render/measure/convergence.h"
#include "render/reference/reference.h"
#include "tests/raycaster/fixture.h"

// Verification by orders of convergence (Etienne et al., TVCG 20(1), 2014): the step, the grid and the pixel
// are refined one at a time, and the error must fall as theory says. The slopes are printed.
namespace crest::testing {

inline constexpr double float_floor =
    4e-7;  // RMSE of a picture that differs from the truth by float rounding alone

inline double rmse(const Image& image, const Image& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int channel = 0; channel < 4; ++channel) {
      const double d = double(image.pixels[i][channel]) - double(truth.pixels[i][channel]);
      sum += d * d;
    }
  return std::sqrt(sum / double(4 * image.pixels.size()));
}

inline void print(const char* what, std::span<const double> sizes, std::span<const double> errors,
                  const OrderFit& fit) {
  fmt::print("{:<52} order {:5.2f} between {:g} and {:g} ({} sizes); errors", what, fit.order, fit.coarsest,
             fit.finest, fit.points);
  for (std::size_t i = 0; i < sizes.size(); ++i) fmt::print(" {:.2e}", errors[i]);
  fmt::print("\n");
}

/// A field without symmetries that rises along z, so that every ray crosses its level sets transversally.
inline double transversal(glm::dvec3 p) {
  return p.z + 0.12 * std::sin(2.1 * p.x + 0.4) * std::cos(1.7 * p.y) + 0.05 * std::sin(5 * p.z + p.x);
}

inline glm::dvec3 gradient_of_transversal(glm::dvec3 p) {
  return {0.252 * std::cos(2.1 * p.x + 0.4) * std::cos(1.7 * p.y) + 0.05 * std::cos(5 * p.z + p.x),
          -0.204 * std::sin(2.1 * p.x + 0.4) * std::sin(1.7 * p.y), 1 + 0.25 * std::cos(5 * p.z + p.x)};
}

/// The cube [0,1]^3 with n points an axis.
inline Grid unit_cube(int n) { return Grid{glm::ivec3(n), glm::dvec3(1.0 / (n - 1)), glm::dvec3(0)}; }

inline constexpr glm::ivec2 small{40, 40};

class Order : public RaycasterTest {
 protected:
  /// RMSE of the ray caster's picture at each step.
  std::vector<double> errors_in_step(Scene scene, const Camera& camera, Answer answer,
                                     std::span<const double> steps) {
    const Image truth = render_reference(scene, camera, small, answer).image();
    std::vector<double> errors;
    for (const double step : steps) {
      scene.rendering.step = step;
      errors.push_back(rmse(render(scene, camera, small), truth));
    }
    return errors;
  }

  OrderFit order_in_step(const char* what, const Scene& scene, Answer answer, std::span<const double> steps) {
    const Camera camera = whole_volume_camera(scene.volume->grid, 1, 20);
    return fit(what, steps, errors_in_step(scene, camera, answer, steps));
  }

  OrderFit fit(const char* what, std::span<const double> sizes, std::span<const double> errors) {
    const auto result = fit_order(sizes, errors, float_floor, 5);  // four halvings
    EXPECT_TRUE(result) << what << ": fewer than four halvings above the floor of float: "
                        << ::testing::PrintToString(std::vector(errors.begin(), errors.end()));
    if (!result) return {};
    print(what, sizes, errors, *result);
    return *result;
  }
};

inline Scene scene_of(std::shared_ptr<const Volume> volume, TransferFunction tf, Mode mode,
                      PeakForm form = PeakForm::split) {
  Scene scene{std::move(volume), std::move(tf), {}};
  scene.rendering.mode = mode;
  scene.rendering.peak_form = form;
  return scene;
}

inline const glm::dvec3 blue(0.1, 0.3, 1), orange(1, 0.5, 0.1);

inline TransferFunction smooth_tf() {
  return make_tf({point(-0.3, 0.02, blue), point(1.3, 0.8, orange)}, 0.25);
}

/// Haze with a spike in its middle.
inline TransferFunction spike_tf(double width) {
  return make_tf({point(-0.3, 0.05, blue), point(0.5 - width / 2, 0.375, blue), point(0.5, 0.8, orange),
                  point(0.5 + width / 2, 0.375, blue), point(1.3, 0.7, blue)},
                 0.25);
}

}  // namespace crest::testing
