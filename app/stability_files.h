#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "presets/json_text.h"
#include "render/studies/stability/row.h"

namespace crest {

/// The table of `crest stability`. What is not finite is null.
Json stability_json(const std::vector<stability::Row>& rows, const std::string& renderer);

/// Writes stability.json, which is `table`, and stability.html, which has the rows' pictures in it, into
/// `folder`; the page last. Throws Error.
void write_stability(const std::vector<stability::Row>& rows, const Json& table,
                     const std::filesystem::path& folder);

}  // namespace crest
