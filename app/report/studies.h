#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include "app/scene_options.h"
#include "presets/json_text.h"

namespace crest {

/// What `crest report --study NAME` says about how to run one.
struct StudyOptions {
  std::filesystem::path folder;          ///< where its files go; it is there
  SceneOptions scene;                    ///< its volume is empty where none was given
  std::optional<glm::ivec2> size;        ///< in pixels, where --size was given; else each study's own
  std::optional<double> budget_seconds;  ///< where --budget was given, and is not "none"
  std::string data_folder;               ///< of real volumes; empty where none was given
  int device = -1;
  bool json = false;       ///< also print its JSON
  std::uint64_t seed = 1;  ///< of what a study makes by chance
  std::string command;     ///< as typed, for the page
  std::stop_token stop;    ///< asked for by Ctrl-C
};

/// A report on one question, with scenes of its own.
struct Study {
  std::string_view name, summary;
  void (*run)(const StudyOptions& options);
  bool takes_volume = false;  ///< VOLUME and the options of its scene, in place of a scene of its own
  bool takes_budget = false;  ///< and leaves out what it has no time for
  bool takes_seed = false;    ///< of scenes that it makes by chance
};

/// All studies: a new one is a line here.
std::span<const Study> studies();

/// Does a study's work. Throws Error, which says so, where it was stopped (Cancelled): nothing is written
/// yet.
void work_on_study(const StudyOptions& options, const std::function<void()>& work);

/// Prints what was written: its JSON, where that was asked for, else `text`.
void print_study(const StudyOptions& options, const Json& json, const std::string& text);

}  // namespace crest
