#pragma once

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "render/measure/measurement.h"
#include "render/measure/methods.h"
#include "render/renderer.h"
#include "render/studies/random/scenes.h"

namespace crest {

/// Of a method that has one, in units of the smallest spacing.
inline constexpr double random_study_steps[] = {0.5, 0.125, 0.03125};

/// A pixel that is off by more is an outlier.
inline constexpr double outlier_difference = 0.1;

/// A method's picture of a scene at a step, against one of the exact answers of its mode.
struct RandomMeasurement {
  int scene = 0;       ///< its index in random_scenes()
  std::string method;  ///< Method::id
  double step = 0;     ///< 0 for a method without one
  ExactAnswer answer{Answer::integral};
  ImageError error;  ///< crossings are known where the method shows surfaces
  // Of the compared pixels:
  std::size_t wrong = 0;     ///< those off by more than 1/255
  std::size_t outliers = 0;  ///< those off by more than outlier_difference
  glm::ivec2 worst{0};       ///< the one that is off furthest; row 0 at the top
};

/// All methods' pictures of a scene.
struct RandomSceneStudy {
  std::vector<RandomMeasurement> measurements;
  std::vector<LeftOut> left_out;  ///< methods that make no sense in it
  Image exact;                    ///< of the surfaces and the volume: `integral+crossings`, or `integral`
};

struct RandomStudySettings {
  glm::ivec2 size{96, 72};
  std::filesystem::path cache;  ///< where exact answers are kept; empty for nowhere
  std::stop_token stop = {};
  /// What is being done, and how much of the scene is done, in [0, 1]; from the caller's thread.
  std::function<void(std::string_view doing, double done)> progress = [](std::string_view, double) {};
};

/// Draws the scene with these methods at each step and compares. A GL 4.5 context must be current. Throws
/// Error, Cancelled.
RandomSceneStudy study_random_scene(Renderer& renderer, const RandomScene& random, int index,
                                    const RandomStudySettings& settings,
                                    std::span<const Method> methods = crest::methods());

/// Compares one picture; `crossings` as in image_error().
RandomMeasurement compare_random(const Reference& exact, const Image& image,
                                 std::span<const std::uint32_t> crossings);

}  // namespace crest
