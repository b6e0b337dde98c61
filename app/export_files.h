#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "presets/exchange/exporters.h"

namespace crest {

/// A file's name without its extension: without the format's (".vp.json") if it has it, else without the last
/// one.
std::string stem_of(const std::filesystem::path& output, std::string_view extension);

/// The path of one of an export's files.
std::filesystem::path path_of(const std::filesystem::path& output, const std::string& stem,
                              const ExportFile& file);

/// Writes all of them. Throws Error.
void write_export(const Exported& exported, const std::string& stem, const std::filesystem::path& output);

}  // namespace crest
