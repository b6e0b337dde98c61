#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace crest::test {

/// Expects a page that needs no other file and no network, and returns the data in it.
nlohmann::json expect_standalone_page(const std::string& page);

}  // namespace crest::test
