#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "presets/transfer_function.h"

namespace crest {

/// Equal bins over a closed range, the last one closed.
class HistogramBins {
 public:
  HistogramBins(ValueRange range, int bins)
      : range_(range),
        size_(std::size_t(std::max(bins, 1))),
        scale_(range.width() > 0 ? double(size_) / range.width() : 0) {}
  std::size_t size() const { return size_; }
  bool has(double value) const { return std::isfinite(value) && value >= range_.min && value <= range_.max; }
  /// Of a value that it has.
  std::size_t operator()(double value) const {
    return std::min(std::size_t((value - range_.min) * scale_), size_ - 1);
  }

 private:
  ValueRange range_;
  std::size_t size_;
  double scale_;
};

}  // namespace crest
