#include "render/studies/knoll/table_builds.h"

#include <chrono>
#include <functional>

#include "render/classify/peak_table.h"
#include "render/classify/preintegration_table.h"
#include "render/measure/timing.h"

namespace crest {
namespace {

constexpr int builds = 9;
constexpr double step = 0.5;  ///< smallest spacings

double ms_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

std::vector<TableBuild> time_table_builds(const TransferFunction& tf, ValueRange field,
                                          double smallest_spacing, std::span<const int> bins) {
  std::vector<TableBuild> results;
  for (const int n : bins) {
    std::vector<double> peak_ms, preintegration_ms;
    for (int i = 0; i < builds; ++i) {
      peak_ms.push_back(ms_of([&] { build_peak_table(shown_peaks(find_peaks(tf)), field, n); }));
      preintegration_ms.push_back(
          ms_of([&] { build_preintegration_table(tf, field, smallest_spacing, step, n); }));
    }
    results.push_back({n, median(peak_ms), median(preintegration_ms)});
  }
  return results;
}

}  // namespace crest
