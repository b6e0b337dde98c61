#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "presets/preset.h"

namespace crest {

struct ExportOptions {
  int samples = 1024;  ///< rows of a sampled format, 2..1048576
};

/// One format that presets are written to. A new one is a new file, and one line in the table.
struct Exporter {
  std::string_view name;       ///< as the command line knows it
  std::string_view extension;  ///< with the dot
  std::string_view summary;    ///< one line
  /// The file's text. `tf` is as the preset has it, or resolved against a volume. Throws Error for options
  /// that are out of bounds.
  std::string (*write)(std::string_view preset_name, const TransferFunction& tf,
                       const ExportOptions& options);
  /// What the format cannot hold of this TF: lines that end with a newline, "" for nothing.
  std::string (*losses)(const TransferFunction& tf, const ExportOptions& options);
};

std::span<const Exporter> exporters();
/// Throws Error that lists the known names.
const Exporter& find_exporter(std::string_view name);

}  // namespace crest
