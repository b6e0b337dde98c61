#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/studies/knoll/scene.h"

namespace crest {

/// What a scene of the study is made from: a file of the folder of real volumes, where that has it, or else a
/// built-in volume.
struct KnollSceneRow {
  std::string_view id, title;
  PaperRow paper;  ///< without a dataset where Table 1 has no such scene
  std::string_view file, builtin;
  std::string_view note_on_file,
      note_on_builtin;  ///< where they are not the paper's data: what stands for it
  std::string_view preset, settings;
  const BoxView *view_of_file = nullptr, *view_of_builtin = nullptr;  ///< null: the whole volume is in view
};

/// The scenes in the order in which they are measured.
std::span<const KnollSceneRow> knoll_scene_rows();
const KnollSceneRow& knoll_scene_row(std::string_view id);

/// Makes scenes, and keeps the volumes.
class KnollScenes {
 public:
  /// `folder` of real volumes: empty where there is none. `aspect` is the pictures'. Throws Error
  /// where it is no folder.
  KnollScenes(std::filesystem::path folder, double aspect);

  /// Throws Error for a volume that cannot be read.
  KnollScene make(const KnollSceneRow& row);

 private:
  std::shared_ptr<const Volume> load(const std::string& source);

  std::filesystem::path folder_;
  double aspect_;
  std::map<std::string, std::shared_ptr<const Volume>> volumes_;
};

/// The whole scene as a preset, its camera and its settings in a variant among it: what `crest render` takes.
Preset preset_of(const KnollScene& scene, const Variant& variant);

}  // namespace crest
