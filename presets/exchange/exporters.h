#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "presets/preset.h"

namespace crest {

/// The volume that a preset is written for.
struct ExportVolume {
  std::string file;  ///< its absolute path; empty where it is built in
  std::string name;
  ValueRange range;
  glm::ivec3 dims{2};
  glm::dvec3 spacing{1}, origin{0};
  /// Of a file without a header: how its voxels lie in it.
  struct Raw {
    std::string type;  ///< "uint8" ... "float64"
    bool big_endian = false;
    std::uint64_t offset = 0;
  };
  std::optional<Raw> raw;
};

struct ExportInput {
  std::string name;  ///< of the preset, for people
  std::string stem;  ///< of the files that are written: their name without folder and extension
  Preset preset;     ///< its TF in a volume's values and world units: see ready_for_export
  std::optional<ExportVolume> volume;
  int rows = 0;                 ///< of a table, 2..most_table_rows; 0 = the fewest that hold all points
  glm::ivec2 size{1024, 1024};  ///< of a script's picture
};

struct ExportFile {
  std::string suffix;  ///< takes the place of the extension that a person gave; empty: the file itself
  std::string content;
};

/// What is to be written, and what a person should know before.
struct Exported {
  std::vector<ExportFile> files;  ///< the first is the one that was asked for
  std::vector<std::string>
      losses;  ///< what the target cannot hold of this preset, each a sentence without its stop
  std::vector<std::string> advice;  ///< what to do there
};

/// One format that presets are written to. A new one is a new file, and one line in the table.
struct Exporter {
  std::string_view name;       ///< as the command line knows it
  std::string_view title;      ///< as people call it
  std::string_view extension;  ///< with the dot
  std::string_view summary;    ///< one line
  /// Throws Error for what cannot be written.
  Exported (*write)(const ExportInput& input);
  /// The preset that Crest draws as the target draws the file: its TF as the target reads it, its unit
  /// distance, step and shading, and surfaces only where it has them.
  Preset (*as_drawn)(const ExportInput& input);
  bool is_table = false;  ///< `rows` counts
};

std::span<const Exporter> exporters();
/// Throws Error that lists the known names.
const Exporter& find_exporter(std::string_view name);

/// The preset in the volume's values and units. Throws Error for a preset that has none of its own -
/// normalized, or with its unit distance in voxels - where there is no volume, and for a TF without points.
Preset ready_for_export(const Preset& preset, const std::optional<ExportVolume>& volume);

}  // namespace crest
