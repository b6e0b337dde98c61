#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "presets/json_text.h"
#include "render/files/image.h"

namespace crest {

/// Writes a web page that stands alone: `body` (HTML) in the look that all of Crest's pages have
/// (web/page.css), and `script`, which finds web/chart.js' functions and `data`. Throws Error.
void write_page(const std::filesystem::path& path, std::string_view title, std::string_view body,
                std::string_view script, const Json& data);

/// The time as pages and files tell it: UTC, ISO 8601.
std::string utc_now();

/// A file of app/report/web, by its name: "report.html".
std::string_view web_file(std::string_view name);

/// A picture as a "data:" address, to be shown by a page without a file: one of a PNG file, or one that has
/// none.
std::string data_address(const std::filesystem::path& png);
std::string data_address(const Image& image, glm::vec3 background);

}  // namespace crest
