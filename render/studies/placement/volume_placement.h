#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/measure/convergence.h"
#include "render/measure/image_error.h"
#include "render/raycaster/raycaster.h"
#include "render/studies/placement/scenes.h"

namespace crest {

/// In smallest spacings.
inline constexpr std::array<double, 5> study_steps{2, 1, 0.5, 0.25, 0.125};
inline constexpr double pictured_step = 1;

/// One placement in one scene.
struct VolumePlacement {
  struct Point {
    double step = 1;
    ImageError error;  ///< against `integral`
    double dvr_samples_per_ray = 0;
  };
  Placement placement;
  std::vector<Point> points;  ///< by step
  Image picture;              ///< at `pictured_step`
  /// Of the RMSE: fit_finest_order(); nothing where it is that of rounding at every step.
  std::optional<OrderFit> order;
};

struct VolumeStudy {
  PlacementScene scene;
  glm::ivec2 size{0};
  Reference exact;
  std::vector<VolumePlacement> placements;
};

/// All placements and steps of a scene. A GL 4.5 context is current. Throws Cancelled when a stop is asked
/// for.
VolumeStudy study_volume(Raycaster& raycaster, const PlacementScene& scene, glm::ivec2 size,
                         std::stop_token stop);

/// How far the middle row of the extruded square's exact picture is from the plane study's closed form,
/// largest over its pixels: what straight lines in the TF cost.
double distance_from_plane(const VolumeStudy& square);

/// "Planes only bring new entry and exit points": by placement, what a clip box shows against what the volume
/// shows that is cropped to it.
struct ClipDifference {
  Placement placement;
  double max = 0;          ///< of a pixel
  double share = 0;        ///< of all pixels, those that differ by more than 1/255
  std::size_t pixels = 0;  ///< that show something
};
std::vector<ClipDifference> clip_against_crop(Raycaster& raycaster, const PlacementScene& clipped,
                                              glm::ivec2 size);

/// Frame times of the placements in one scene, turn by turn in changing order. The default placement is timed
/// a second time as if it were another: how far its ratio is from 1 is what the machine does by itself.
struct PlacementTime {
  Placement placement;
  bool is_control = false;
  std::vector<double> frame_ms;
  double median_ms = 0;
  double ratio = 0;  ///< median over the rounds, to entry_exit_corner's frame of the same round
  double dvr_samples_per_ray = 0;
};
std::vector<PlacementTime> time_placements(Raycaster& raycaster, const PlacementScene& scene, double step,
                                           glm::ivec2 size, int rounds, std::stop_token stop);

}  // namespace crest
