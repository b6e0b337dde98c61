#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/report/studies.h"
#include "presets/json_text.h"
#include "render/studies/random/summary.h"

namespace crest {

/// All that the study of random scenes found.
struct RandomReport {
  std::string command, renderer, made_at;
  std::uint64_t seed = 1;
  glm::ivec2 size{0};
  double seconds = 0;
  std::vector<RandomScene> scenes;        ///< those that the budget allowed
  std::vector<RandomSceneStudy> studies;  ///< of each of them
};

/// Groups of scenes that are told apart: labels jump from voxel to voxel, which is hardest for samples.
struct SceneGroup {
  std::string_view id, title;
  std::vector<MethodSummary> summaries;
  int scenes = 0;
};
/// All scenes, those without labels, and those of labels.
std::vector<SceneGroup> groups_of(const RandomReport& report);

/// File name of a scene's exact picture, below the report's folder.
std::string random_picture_name(int scene);

Json random_json(const RandomReport& report);
/// A row for each scene, method, step and exact answer.
std::string random_csv(const RandomReport& report);
/// The groups' tables as text, and each method without steps that is wrong somewhere, with the pixel.
std::string random_table(const RandomReport& report);

/// Every method on twelve random scenes: writes random.json, .csv, .html and pictures in images/ into the
/// folder, the page last. A budget leaves out the last scenes. Throws Error.
void run_random_study(const StudyOptions& options);

}  // namespace crest
