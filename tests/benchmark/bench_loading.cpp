// bench_loading SOURCE...: seconds, and seconds of processor time on all cores, from opening a volume until
// it can be drawn, and of its parts. Each is the least of two.

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>

#include "render/files/load.h"
#include "render/volume/by_value.h"
#include "render/volume/macrocells.h"

namespace crest {
namespace {

double seconds_of(int who) {
  rusage usage{};
  ::getrusage(who, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void measure(const char* what, const std::function<void()>& work) {
  double least = INFINITY, least_own = INFINITY, least_readers = INFINITY;
  for (int i = 0; i < 2; ++i) {
    const double own = seconds_of(RUSAGE_SELF), readers = seconds_of(RUSAGE_CHILDREN);
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    least = std::min(least, taken.count());
    least_own = std::min(least_own, seconds_of(RUSAGE_SELF) - own);
    least_readers = std::min(least_readers, seconds_of(RUSAGE_CHILDREN) - readers);
  }
  fmt::print("  {:<22} {:7.3f} s, processor {:7.3f} s", what, least, least_own);
  if (least_readers > 0) fmt::print(", its reader's {:7.3f} s", least_readers);
  fmt::print("\n");
  std::fflush(stdout);
}

void measure_all(const char* source) {
  fmt::print("{}\n", source);
  Volume volume;
  measure("until it is there", [&] {
    volume = {};
    volume = load_volume(source);
  });
  const Grid& grid = volume.grid;
  const Voxels& values = volume.values;
  measure("statistics", [&] { compute_statistics(grid, values); });
  measure("  histogram", [&] { histogram_of(values, volume.statistics.range, histogram_bins); });
  measure("macrocells", [&] { build_macrocells(volume, {}, macrocell_side(grid, volume.statistics)); });
  if (grid.point_count() <= (std::size_t(1) << 22))
    measure("curves by value", [&] { measure_by_value(volume, 256, {}); });
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "bench_loading SOURCE...\n");
    return 2;
  }
  try {
    for (int i = 1; i < argc; ++i) crest::measure_all(argv[i]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_loading: {}\n", error.what());
    return 1;
  }
}
