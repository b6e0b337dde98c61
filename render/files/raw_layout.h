#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/ext/vector_uint3_sized.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/volume/query.h"
#include "render/volume/volume.h"

namespace crest {

/// How voxels lie in a file without a header, x fastest.
struct RawLayout {
  glm::ivec3 size{0};  ///< points on each axis; 0 while it is not known
  ScalarType type = ScalarType::uint8;
  bool big_endian = false;
  std::uint64_t offset = 0;  ///< bytes before the voxels
  glm::dvec3 spacing{1};     ///< world units, > 0
  bool operator==(const RawLayout&) const = default;
};

/// "256x256x128" as three numbers, and "uint8" ... "float64".
std::optional<glm::u64vec3> raw_size(std::string_view text);
std::optional<ScalarType> raw_type(std::string_view text);
/// What a name in the manner of Open SciVis says: name_256x256x256_uint8.raw.
Query query_from_name(const std::string& stem);

/// What the query says, and of what it does not say, or wrong, the default.
RawLayout layout_of(const Query& query);
/// The query for this layout, with what else `before` said.
Query query_of(const RawLayout& layout, const Query& before);

/// How the layout and a file's length go together.
struct RawFit {
  bool fits = false;
  std::string text;              ///< in a sentence
  std::vector<RawLayout> mends;  ///< with another depth, or another offset, that fits
};
RawFit fit_of(const RawLayout& layout, std::uint64_t file_bytes);

/// A layout that fits a file, and what speaks for it.
struct RawGuess {
  RawLayout layout;
  std::string why;
};
/// The most likely ones first, a dozen at most: what digits in the name say ("foot 256 x 256 x 128", also
/// with a header before it), cubes, and stacks of square slices. The name's words for types count too.
std::vector<RawGuess> likely_layouts(const std::filesystem::path& path, std::uint64_t file_bytes);

}  // namespace crest
