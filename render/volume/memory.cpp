#include "render/volume/memory.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "presets/error.h"

namespace crest {
namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

/// The number that follows `key` in one of the kernel's text files.
std::optional<std::uint64_t> number_after(const char* path, std::string_view key) {
  std::ifstream file(path);
  for (std::string word; file >> word;) {
    std::uint64_t number = 0;
    if (word == key && file >> number) return number;
  }
  return std::nullopt;
}

std::uint64_t system_memory() {
  const auto kilobytes = number_after("/proc/meminfo", "MemAvailable:");
  return kilobytes ? *kilobytes * 1024 : no_limit;
}

/// Where a version of control groups keeps a group's limit and what it uses.
struct GroupFiles {
  const char* limit;
  std::string_view used;  ///< in memory.stat; what the kernel can take back does not count
};
constexpr GroupFiles v1{"memory.limit_in_bytes", "total_rss"}, v2{"memory.max", "anon"};

/// What a group's limit still leaves; "max", or no such file, is no limit.
std::uint64_t left_in(const std::filesystem::path& group, const GroupFiles& files) {
  std::uint64_t limit = 0;
  std::ifstream file(group / files.limit);
  if (!(file >> limit)) return no_limit;
  const std::uint64_t used = number_after((group / "memory.stat").c_str(), files.used).value_or(0);
  return limit > used ? limit - used : 0;
}

/// The least that a group and those above it leave. In a container the names may be those outside: then the
/// group is the root.
std::uint64_t left_up_from(const std::filesystem::path& root, std::string_view group,
                           const GroupFiles& files) {
  std::uint64_t left = left_in(root, files);
  for (std::filesystem::path below = std::filesystem::path(group).relative_path(); !below.empty();
       below = below.parent_path())
    left = std::min(left, left_in(root / below, files));
  return left;
}

}  // namespace

// Lines are "number:controllers:/group"; version 2 has the number 0 and no controllers.
std::uint64_t group_memory(const std::filesystem::path& membership, const std::filesystem::path& mounted) {
  std::uint64_t left = left_in(mounted, v2);
  std::ifstream file(membership);
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == line.npos || second == line.npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string group = line.substr(second + 1);
    if (controllers == ",,") left = std::min(left, left_up_from(mounted, group, v2));
    if (controllers.find(",memory,") != controllers.npos)
      left = std::min(left, left_up_from(mounted / "memory", group, v1));
  }
  return left;
}

std::uint64_t available_memory() {
  return std::min(system_memory(), group_memory("/proc/self/cgroup", "/sys/fs/cgroup"));
}

std::optional<std::uint64_t> checked_product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t product = 0;
  if (__builtin_mul_overflow(a, b, &product)) return std::nullopt;
  return product;
}

std::optional<std::uint64_t> checked_product(std::initializer_list<std::uint64_t> factors) {
  std::optional<std::uint64_t> product = 1;
  for (const std::uint64_t factor : factors) product = product ? checked_product(*product, factor) : product;
  return product;
}

std::string byte_text(std::uint64_t bytes) {
  if (bytes < 1000) return fmt::format("{} bytes", bytes);
  double number = double(bytes) / 1000;
  const char* unit = "kB";
  for (const char* next : {"MB", "GB"}) {
    if (number < 999.5) break;
    number /= 1000;
    unit = next;
  }
  return number < 999.5 ? fmt::format("{:.3g} {}", number, unit) : fmt::format("{:.0f} {}", number, unit);
}

std::optional<std::uint64_t> bytes_of(const MemoryNeed& need) {
  const glm::u64vec3 dims = need.part.dims();
  const auto plane = checked_product(dims.x, dims.y);
  const auto points = plane ? checked_product(*plane, dims.z) : plane;
  const auto bytes = points ? checked_product(*points, need.bytes_per_point) : points;
  if (!bytes || *bytes > no_limit - need.besides) return std::nullopt;
  return *bytes + need.besides;
}

std::optional<GridPart> part_that_fits(const MemoryNeed& need, std::uint64_t memory) {
  const auto is_too_large = [&](std::uint64_t stride) {
    MemoryNeed smaller = need;
    smaller.part = at_stride(need.part, stride);
    const auto bytes = bytes_of(smaller);
    return !bytes || *bytes > memory;
  };
  const glm::u64vec3 box = need.part.end - need.part.first;
  const std::uint64_t longest = std::max({box.x, box.y, box.z, std::uint64_t(2)}) - 1;
  if (is_too_large(longest)) return std::nullopt;
  std::uint64_t low = 1, high = longest;  // by halves: a smaller stride takes more
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (is_too_large(middle))
      low = middle + 1;
    else
      high = middle;
  }
  return at_stride(need.part, low);
}

void require_memory(std::string_view name, const MemoryNeed& need, std::uint64_t memory) {
  constexpr std::uint64_t most_points = std::uint64_t(std::numeric_limits<int>::max());
  const glm::u64vec3 dims = need.part.dims();
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t points = dims[axis];
    if (points < 2 || points > most_points) {
      throw Error(fmt::format("{}: {}x{}x{}: axis {} has {} points; a volume has 2 to {} on each", name,
                              dims.x, dims.y, dims.z, axis + 1, points, most_points));
    }
  }
  const auto bytes = bytes_of(need);
  if (!bytes) {
    throw Error(
        fmt::format("{}: {}x{}x{} points are more than any memory holds", name, dims.x, dims.y, dims.z));
  }
  if (*bytes > memory) {
    throw TooLarge(fmt::format("{}: {}x{}x{} points need {} of memory, and {} are free", name, dims.x, dims.y,
                               dims.z, byte_text(*bytes), byte_text(memory)),
                   need, memory);
  }
}

}  // namespace crest
