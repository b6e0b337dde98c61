#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/ext/vector_uint3_sized.hpp>
#include <optional>
#include <string_view>

namespace crest {

/// Bytes that the machine, and the limit on this group of processes, leave for a new volume.
std::uint64_t available_memory();

/// What the limits on the groups of processes of cgroup v1 and v2 leave: on those that `membership` (as
/// /proc/self/cgroup) names, below `mounted`, and on all above them. The greatest number where there is none.
std::uint64_t group_memory(const std::filesystem::path& membership, const std::filesystem::path& mounted);

/// a * b, or nothing when it does not fit.
std::optional<std::uint64_t> checked_product(std::uint64_t a, std::uint64_t b);

/// What reading a volume of `dims` points takes: its float32 values, and `bytes_per_point` more while it is
/// read. Throws Error when an axis has fewer than 2 points, the sizes overflow, or that is over `memory`.
void require_memory(std::string_view name, glm::u64vec3 dims, std::uint64_t bytes_per_point,
                    std::uint64_t memory);

}  // namespace crest
