#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "render/measure/image_error.h"
#include "render/raycaster/raycaster.h"
#include "render/studies/knoll/scene.h"

namespace crest {

/// What a variant of a scene costs, and how far its picture is from the exact one.
struct Shot {
  Variant variant;
  Rendering rendering;         ///< as measured
  double samples_per_ray = 0;  ///< field evaluations, over all pixels of the picture, as in the paper
  double dvr_samples_per_ray = 0, crossings_per_ray = 0;
  bool skips = false;                ///< empty macrocells
  int peak_bins = 0;                 ///< of the peak table, where there is one
  Answer answer = Answer::integral;  ///< what the error is against; in the paper's form base+crossings
  ImageError error;
  /// RMSE between its exact answer and the integral's, where that was asked for: what peaks change by design.
  std::optional<double> model_difference;
  Image picture;        ///< shaded, as the paper's figures are
  Image error_picture;  ///< of the measured, unshaded one; these two where pictures were asked for

  std::vector<double> frame_ms;  ///< wall clock, until the device has finished
  double median_ms = 0;
  double ratio = 1;  ///< median over the rounds, to the group's first in the same round

  double fps() const { return 1000 / median_ms; }
};

/// Shots of one scene that were timed turn by turn.
struct ShotGroup {
  std::string id, title, scene;  ///< the scene's id
  std::vector<Shot> shots;

  /// Null where there is none of this variant.
  const Shot* find(std::string_view variant) const;
};

/// Draws, times and judges the scenes of the study. A GL 4.5 context is current while it lives. Each of its
/// functions throws Cancelled when a stop is asked for.
class KnollLab {
 public:
  struct Settings {
    glm::ivec2 size{256, 256};
    std::stop_token stop;
    std::filesystem::path cache_folder;  ///< of exact answers; empty: none
    std::function<Image(const Reference&, const Image&)> paint_error;
  };
  explicit KnollLab(Settings settings);

  const Settings& settings() const { return settings_; }

  /// One variant, not timed.
  Shot shoot(const KnollScene& scene, const Variant& variant, bool with_pictures);

  /// Times the shots of a scene, turn by turn in changing order: as many rounds as some seconds hold, at
  /// least 3.
  void time(const KnollScene& scene, std::vector<Shot>& shots);

  /// Both; where the first is DVR_ONLY, with the others' model difference.
  ShotGroup shoot_group(std::string id, std::string title, const KnollScene& scene,
                        std::span<const Variant> variants,
                        const std::function<bool(const Variant&)>& is_pictured);

  /// The root mean square error alone.
  double rmse(const KnollScene& scene, const Variant& variant);
  RenderCounts counts(const KnollScene& scene, const Variant& variant);
  /// One frame's time by another's, the median of `pairs` that follow each other.
  double time_ratio(const KnollScene& scene, const Variant& a, const Variant& b, int pairs);

  /// The exact picture of a variant. It stays valid until a picture of another scene is asked for.
  const Reference& exact(const KnollScene& scene, const Variant& variant);

 private:
  void throw_if_stopped() const;
  Image draw(const Scene& scene, const Camera& camera);

  Settings settings_;
  Raycaster raycaster_;
  gl::RenderTarget target_, counted_;
  std::string exact_scene_;  ///< of which `exact_` are
  std::map<std::string, Reference> exact_;
};

/// The answer that a variant's error is against.
Answer answer_of(const Rendering& rendering);

}  // namespace crest
