#pragma once

#include <filesystem>

#include "app/report/report.h"
#include "presets/json_text.h"

namespace crest {

/// Writes report.json, report.csv, report.html and the pictures in images/ into `folder`, the page last.
/// Returns what report.json holds. Throws Error.
Json write_report(const Report& report, const std::filesystem::path& folder);

}  // namespace crest
