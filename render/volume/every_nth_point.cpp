#include "render/volume/every_nth_point.h"

#include <fmt/core.h>

#include <algorithm>

#include "render/volume/by_value.h"
#include "render/volume/take_part.h"

namespace crest {

Volume every_nth_point(const Volume& volume, int stride) {
  const GridPart part =
      part_from_query(volume.name, {{"stride", fmt::format("{}", stride)}}, glm::u64vec3(volume.grid.dims));
  Volume thin;
  thin.grid = volume.grid;
  thin.name = volume.name;
  thin.file_type = volume.file_type;
  take_part(thin, part);
  thin.statistics = volume.statistics;
  std::vector<float>& values = thin.values.floats();
  values.reserve(thin.grid.point_count());
  for (int k = 0; k < thin.grid.dims.z; ++k)
    for (int j = 0; j < thin.grid.dims.y; ++j)
      for (int i = 0; i < thin.grid.dims.x; ++i)
        values.push_back(volume.at(i * stride, j * stride, k * stride));
  return thin;
}

std::vector<std::optional<double>> surface_left(const Volume& volume, int stride,
                                                const std::vector<double>& values) {
  const ByValue whole = measure_by_value(volume).value();
  const std::vector<double> before = surface_area(whole),
                            after = surface_area(measure_by_value(every_nth_point(volume, stride)).value());
  std::vector<std::optional<double>> left;
  for (const double value : values) {
    const double bin = (value - whole.range.min) / whole.bin_width();
    const bool is_there = bin >= 0 && bin <= double(whole.bins());
    const std::size_t i = is_there ? std::min(std::size_t(bin), whole.bins() - 1) : 0;
    left.push_back(is_there && before[i] > 0 ? std::optional(after[i] / before[i]) : std::nullopt);
  }
  return left;
}

}  // namespace crest
