#pragma once

#include <string>
#include <vector>

#include "app/report/studies.h"
#include "presets/json_text.h"
#include "render/studies/placement/plane_placement.h"
#include "render/studies/placement/volume_placement.h"

namespace crest {

/// All that the study of placements found.
struct PlacementReport {
  std::string command, renderer, made_at;
  PlaneStudy plane;
  std::vector<VolumeStudy> volumes;
  double distance_from_plane = 0;  ///< see distance_from_plane()
  std::vector<ClipDifference> clip_against_crop;
  std::string timed_scene;  ///< its id
  double timed_step = 0.5;
  glm::ivec2 timed_size{0};
  std::vector<PlacementTime> times;
};

/// File names of a scene's pictures, below the report's folder.
std::string placement_exact_picture_name(const std::string& scene);
std::string placement_picture_name(const std::string& scene, Placement placement);
std::string placement_error_picture_name(const std::string& scene, Placement placement);

Json placement_json(const PlacementReport& report);

/// The plane study's rays: a row for each field, sum, placement, rate and ray.
std::string placement_csv(const PlacementReport& report);

/// "Where to place the samples" (Steneteg et al.): writes placement.json, .csv, .html and pictures in images/
/// into the folder, the page last. Throws Error.
void run_placement_study(const StudyOptions& options);

}  // namespace crest
