#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/ext/vector_uint3_sized.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "presets/error.h"
#include "render/volume/grid_part.h"

namespace crest {

/// Bytes that the machine, and the limit on this group of processes, leave for a new volume.
std::uint64_t available_memory();

/// What the limits on the groups of processes of cgroup v1 and v2 leave: on those that `membership` (as
/// /proc/self/cgroup) names, below `mounted`, and on all above them. The greatest number where there is none.
std::uint64_t group_memory(const std::filesystem::path& membership, const std::filesystem::path& mounted);

/// a * b, or of all factors, or nothing when it does not fit.
std::optional<std::uint64_t> checked_product(std::uint64_t a, std::uint64_t b);
std::optional<std::uint64_t> checked_product(std::initializer_list<std::uint64_t> factors);

/// What a volume takes while it is read.
struct MemoryNeed {
  GridPart part;
  std::uint64_t bytes_per_point = 0;  ///< of the points that are taken
  std::uint64_t besides = 0;          ///< bytes, of any part
  bool operator==(const MemoryNeed&) const = default;
};
/// "1.5 GB", "340 MB".
std::string byte_text(std::uint64_t bytes);
/// Nothing where it is more than 64 bits hold.
std::optional<std::uint64_t> bytes_of(const MemoryNeed& need);
/// The same part at the smallest stride that fits, no smaller than it is; nothing where none does.
std::optional<GridPart> part_that_fits(const MemoryNeed& need, std::uint64_t memory);

/// A volume that takes more memory than it may.
struct TooLarge : Error {
  TooLarge(const std::string& text, const MemoryNeed& what, std::uint64_t bytes)
      : Error(text), need(what), memory(bytes) {}
  MemoryNeed need;
  std::uint64_t memory;
};

/// Throws Error when an axis has fewer than 2 points or the sizes overflow, and TooLarge when the volume
/// takes more than `memory`.
void require_memory(std::string_view name, const MemoryNeed& need, std::uint64_t memory);

}  // namespace crest
