// make_vessels FILE.raw AxBxC: a tree of thin bright vessels in empty space, 8 bits a point, written as a
// file with holes, so that a volume of any size takes what its vessels take.

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "presets/error.h"
#include "render/files/raw_layout.h"

namespace {

/// From `a` to `b`, in points.
struct Vessel {
  glm::dvec3 a, b;
  double radius;
};

/// Two narrower ones from the end of each, to the sides of it.
void grow(std::vector<Vessel>& tree, std::mt19937& random, glm::dvec3 from, glm::dvec3 direction,
          double length, double radius, int generations) {
  const glm::dvec3 to = from + length * direction;
  tree.push_back({from, to, radius});
  if (generations == 0) return;
  std::uniform_real_distribution<double> bend(-0.7, 0.7);
  for (int branch = 0; branch < 2; ++branch)
    grow(tree, random, to, glm::normalize(direction + glm::dvec3(bend(random), bend(random), bend(random))),
         0.82 * length, std::max(0.8 * radius, 1.5), generations - 1);
}

double distance_to(const Vessel& vessel, glm::dvec3 p) {
  const glm::dvec3 along = vessel.b - vessel.a;
  const double share = std::clamp(glm::dot(p - vessel.a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(p, vessel.a + share * along);
}

/// Brightest in the middle, and nothing beyond twice the radius.
void draw(std::uint8_t* points, glm::u64vec3 dims, const Vessel& vessel) {
  const glm::ivec3 last = glm::ivec3(dims) - 1;
  const glm::ivec3 first =
      glm::clamp(glm::ivec3(glm::min(vessel.a, vessel.b) - 2 * vessel.radius), glm::ivec3(0), last);
  const glm::ivec3 end =
      glm::clamp(glm::ivec3(glm::max(vessel.a, vessel.b) + 2 * vessel.radius), glm::ivec3(0), last);
  for (int z = first.z; z <= end.z; ++z)
    for (int y = first.y; y <= end.y; ++y)
      for (int x = first.x; x <= end.x; ++x) {
        const double share = distance_to(vessel, {x, y, z}) / (2 * vessel.radius);
        if (share >= 1) continue;
        const auto value = std::uint8_t(std::lround(255 * (1 - share * share)));
        std::uint8_t& point =
            points[std::uint64_t(x) + dims.x * (std::uint64_t(y) + dims.y * std::uint64_t(z))];
        point = std::max(point, value);
      }
}

void make(const char* path, glm::u64vec3 dims) {
  const std::uint64_t bytes = dims.x * dims.y * dims.z;
  const int file = ::open(path, O_RDWR | O_CREAT | O_TRUNC, 0644);
  if (file < 0 || ::ftruncate(file, off_t(bytes)) != 0)
    throw crest::Error(fmt::format("{}: it cannot be written", path));
  void* const mapped = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (mapped == MAP_FAILED) throw crest::Error(fmt::format("{}: it cannot be written", path));
  std::vector<Vessel> tree;
  std::mt19937 random(1);
  const glm::dvec3 size(dims);
  grow(tree, random, {size.x / 2, size.y / 2, 0.02 * size.z}, {0, 0, 1}, 0.2 * size.z, 0.008 * size.x, 9);
  for (const Vessel& vessel : tree) draw(static_cast<std::uint8_t*>(mapped), dims, vessel);
  ::munmap(mapped, bytes);
  ::close(file);
}

}  // namespace

int main(int argc, char** argv) {
  const auto dims = argc == 3 ? crest::raw_size(argv[2]) : std::nullopt;
  if (!dims) {
    fmt::print(stderr, "make_vessels FILE.raw 2048x2048x1024\n");
    return 2;
  }
  try {
    make(argv[1], *dims);
  } catch (const std::exception& error) {
    fmt::print(stderr, "make_vessels: {}\n", error.what());
    return 1;
  }
}
