#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "render/volume/query.h"

namespace crest {

/// What load_volume asks of a reader. The path is there, and readable.
struct FileRequest {
  std::filesystem::path path;
  Query query;
  std::uint64_t memory = 0;  ///< bytes that reading may take
  bool asks = false;         ///< ChoiceNeeded also where the query left something open that has a default

  std::string name() const { return path.string(); }  ///< what errors call it
};

/// A lower-case extension with its dot.
std::string extension_of(const std::filesystem::path& path);

}  // namespace crest
