#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "presets/preset.h"

namespace crest {

/// One preset from another tool's file.
struct Imported {
  Preset preset;
  std::vector<std::string>
      notes;  ///< what the file did not say and was assumed, or could not be kept: sentences
  bool has_colors = true, has_opacities = true;
  /// Opacities are those of this share of the volume's side, which the file does not know; 0: as the preset
  /// says.
  double share_of_side = 0;
};

/// One format that presets are read from. A new one is a new file, and one line in the table.
struct Importer {
  std::string_view name;     ///< as exporters have it where there is one
  std::string_view summary;  ///< one line
  /// Whether a file is in this format: by its content; `extension` is in lower case, with its dot.
  bool (*recognises)(std::string_view content, std::string_view extension);
  /// All presets in the file; at least one. Throws Error: what is wrong, and where.
  std::vector<Imported> (*read)(std::string_view content);
};

std::span<const Importer> importers();

/// How the names of presets end that are opened: Crest's own and those of other programs, in lower case with
/// the dot.
std::span<const std::string_view> preset_extensions();

/// The format of a file; null where it is none of them, as a preset of Crest's own is not.
const Importer* find_importer(std::string_view content, const std::filesystem::path& name);

/// All presets in a file. Throws Error, which begins with the file's name: that it is none of the known
/// formats, or what is wrong in it; also what a preset cannot hold. At most 64 MB.
std::vector<Imported> import_presets(const std::filesystem::path& path);
/// Of its content.
std::vector<Imported> import_presets(std::string_view content, const std::filesystem::path& name);

/// Its TF, with the unit distance that a share of the side of a volume of this size is (of the mean of its
/// three).
TransferFunction for_volume(const Imported& imported, const glm::dvec3& volume_size);

/// The one of this name; without a name, the only one. Throws Error that lists the names.
const Imported& choose(const std::vector<Imported>& all, std::string_view name, std::string_view source);

/// What to take of a TF that is opened.
enum class TfParts { both, colors, opacities };

/// `base` with the colours or the opacities of `other`, over the points of both; or `other` whole. With
/// `fit`, and where the two are not in the same domain, the other's points are first laid over the base's
/// range.
TransferFunction combined(const TransferFunction& base, const TransferFunction& other, TfParts take,
                          bool fit);

/// Whether a TF is over 0..1, as maps are that a person lays over data.
bool is_over_unit_range(const TransferFunction& tf);

}  // namespace crest
