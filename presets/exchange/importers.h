#pragma once

#include <filesystem>
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

/// The format of a file; null where it is none of them, as a preset of Crest's own is not.
const Importer* find_importer(std::string_view content, const std::filesystem::path& name);

/// All presets in a file. Throws Error, which begins with the file's name: that it is none of the known
/// formats, or what is wrong in it. At most 64 MB.
std::vector<Imported> import_presets(const std::filesystem::path& path);

/// The one of this name; without a name, the only one. Throws Error that lists the names.
const Imported& choose(const std::vector<Imported>& all, std::string_view name, std::string_view source);

/// What to take of a TF that is opened.
enum class TfParts { both, colors, opacities };

/// `base` with the colours or the opacities of `other`, over the points of both; or `other` whole. They are
/// in the same domain, or the other's points are laid over the base's range.
TransferFunction combined(const TransferFunction& base, const TransferFunction& other, TfParts take);

}  // namespace crest
