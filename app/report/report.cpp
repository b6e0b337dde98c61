#include "app/report/report.h"

#include <algorithm>
#include <cmath>

#include "app/cache_folder.h"
#include "render/measure/measure_scene.h"
#include "render/measure/method_convergence.h"

namespace crest {

std::vector<std::size_t> pictured_points(const std::vector<Measurement>& points, const TargetError& target) {
  std::vector<std::size_t> chosen;
  std::map<std::string, std::size_t> typical;
  const auto distance = [&](std::size_t i) { return std::abs(std::log2(points[i].step / typical_step)); };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [best, is_first] = typical.try_emplace(points[i].method, i);
    if (!is_first && distance(i) < distance(best->second)) best->second = i;
  }
  for (const auto& [method, index] : typical) chosen.push_back(index);
  for (const MethodConvergence& convergence : convergence_of(points, target))
    if (convergence.cheapest) chosen.push_back(*convergence.cheapest);
  std::ranges::sort(chosen);
  const auto repeated = std::ranges::unique(chosen);
  chosen.erase(repeated.begin(), repeated.end());
  return chosen;
}

void measure_report(Report& report, std::stop_token stop, const SweepStatus& status) {
  Sweep sweep(report.scene, measure_scene(report.scene, report.camera, report.size, cache_folder()),
              report.settings);
  while (auto point = sweep.next(stop, status)) {
    report.pictures[report.points.size()] = std::move(point->image);
    report.points.push_back(std::move(point->measurement));
    const auto kept = pictured_points(report.points, report.settings.target);
    std::erase_if(report.pictures, [&](const auto& p) { return !std::ranges::binary_search(kept, p.first); });
  }
  report.starts = sweep.starts();
  report.references = sweep.references();
  report.left_out = sweep.left_out();
  report.seconds = sweep.seconds();
  report.reference_seconds = sweep.reference_seconds();
  report.stopped = stop.stop_requested();
}

}  // namespace crest
