#include "render/classify/occupancy.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest {
namespace {

/// Equal bins over the field's range: a narrow spike lets pass few cells that do not meet it.
constexpr int value_bins = 1 << 14;

/// A part of the TF that shows, with what its table makes of it.
ValueRange blurred(ValueRange part, const TableBlur& blur) {
  return {std::max(part.min - blur.width, std::min(part.min, blur.within.min)),
          std::min(part.max + blur.width, std::max(part.max, blur.within.max))};
}

/// Which bins hold something that shows, as sums up to each.
class VisibleBins {
 public:
  VisibleBins(const Shown& shown, ValueRange field)
      : field_(field), scale_(field.width() > 0 ? value_bins / field.width() : 0), begun_(value_bins + 1, 0) {
    if (shown.tf) add(*shown.tf, shown.blur);
    if (shown.surfaces)
      for (const Peak& peak : *shown.surfaces) add({peak.value, peak.value});
    count();
  }

  bool any_in(double min, double max) const {
    return before_[std::size_t(bin_of(max)) + 1] != before_[std::size_t(bin_of(min))];
  }

 private:
  int bin_of(double value) const {
    if (scale_ == 0) return 0;
    return int(std::clamp((value - field_.min) * scale_, 0.0, value_bins - 1.0));
  }

  /// One bin more on either side, for what is rounded.
  void add(ValueRange part) {
    if (part.max < field_.min || part.min > field_.max) return;
    ++begun_[std::size_t(std::max(bin_of(part.min) - 1, 0))];
    --begun_[std::size_t(std::min(bin_of(part.max) + 2, value_bins))];
  }

  void add(const TransferFunction& tf, const TableBlur& blur) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto& points = tf.points;
    for (std::size_t i = 0; i <= points.size() && !points.empty(); ++i) {
      const ControlPoint *from = i > 0 ? &points[i - 1] : nullptr,
                         *to = i < points.size() ? &points[i] : nullptr;
      if (std::max(from ? from->opacity : 0, to ? to->opacity : 0) > 0)
        add(blurred({from ? from->value : -infinity, to ? to->value : infinity}, blur));
    }
  }

  void count() {
    before_.assign(value_bins + 1, 0);
    for (int bin = 0, open = 0; bin < value_bins; ++bin) {
      open += begun_[std::size_t(bin)];
      before_[std::size_t(bin) + 1] = before_[std::size_t(bin)] + (open > 0 ? 1 : 0);
    }
  }

  ValueRange field_;
  double scale_;
  std::vector<int> begun_;   ///< parts that begin in a bin, less those that ended
  std::vector<int> before_;  ///< visible bins before each
};

void count_share(Occupancy& occupancy) {
  const auto occupied = std::ranges::count(occupancy.cells, 1);
  occupancy.share = double(occupied) / double(std::max(occupancy.cells.size(), std::size_t(1)));
}

}  // namespace

Occupancy find_occupancy(const Macrocells& macrocells, const Shown& shown, ValueRange field) {
  const VisibleBins visible(shown, field);
  Occupancy occupancy;
  occupancy.cells.resize(macrocells.count());
  tbb::parallel_for(tbb::blocked_range(std::size_t(0), macrocells.count(), 1 << 14), [&](const auto& part) {
    for (std::size_t i = part.begin(); i < part.end(); ++i)
      occupancy.cells[i] = macrocells.min[i] <= macrocells.max[i] &&
                           visible.any_in(double(macrocells.min[i]), double(macrocells.max[i]));
  });
  count_share(occupancy);
  return occupancy;
}

Occupancy either(Occupancy a, const Occupancy& b) {
  for (std::size_t i = 0; i < a.cells.size(); ++i) a.cells[i] |= b.cells[i];
  count_share(a);
  return a;
}

std::vector<std::int8_t> step_multiples(const Macrocells& macrocells, double volume_deviation) {
  std::vector<std::int8_t> multiples(macrocells.count());
  std::transform(macrocells.deviation.begin(), macrocells.deviation.end(), multiples.begin(),
                 [&](float deviation) {
                   const double inverse = deviation > 0 ? volume_deviation / double(deviation) : 1e9;
                   return std::int8_t(std::min(std::floor(2 * inverse + 1), double(most_joined_steps)));
                 });
  return multiples;
}

}  // namespace crest
