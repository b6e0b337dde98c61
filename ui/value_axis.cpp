#include "ui/value_axis.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace crest {
namespace {

/// The narrowest range about `value` in which doubles still make a smooth axis.
double least_width(double value, ValueRange whole) {
  const double magnitude = std::max({std::abs(value), std::abs(whole.min), std::abs(whole.max)});
  return std::max(whole.width() * deepest_zoom, magnitude * 1e-13);
}

ValueRange moved_inside(ValueRange range, ValueRange whole) {
  const double width = range.width();
  if (!(width < whole.width())) return whole;
  if (range.min < whole.min) return {whole.min, whole.min + width};
  if (range.max > whole.max) return {whole.max - width, whole.max};
  return range;
}

/// 1, 2 or 5 times a power of ten, at least `least`; `decimals` = digits after the point that it needs.
double nice_step(double least, int& decimals) {
  const int exponent = int(std::floor(std::log10(least)));
  const double base = std::pow(10.0, exponent);
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (factor * base >= least * (1 - 1e-9)) {
      decimals = std::max(0, factor == 10.0 ? -exponent - 1 : -exponent);
      return factor * base;
    }
  decimals = std::max(0, -exponent - 1);
  return 10 * base;
}

double rounded(double value, int decimals) {
  return std::strtod(fmt::format("{:.{}f}", value, decimals).c_str(), nullptr);
}

}  // namespace

ValueRange whole_range(ValueRange volume, ValueRange points) {
  constexpr double largest = 1e300;
  double low = std::min(volume.min, points.min), high = std::max(volume.max, points.max);
  if (!std::isfinite(low) || !std::isfinite(high)) low = 0, high = 1;
  low = std::clamp(low, -largest, largest);
  high = std::clamp(high, -largest, largest);
  const double magnitude = std::max(std::abs(low), std::abs(high));
  if (!(high - low > magnitude * 1e-9)) {
    const double half = magnitude > 0 ? magnitude / 2 : 0.5;
    low -= half;
    high += half;
  }
  const double margin = 0.02 * (high - low);
  return {low - margin, high + margin};
}

ValueRange zoom(ValueRange visible, ValueRange whole, double value, double factor) {
  const double width =
      std::clamp(visible.width() * factor, std::min(least_width(value, whole), whole.width()), whole.width());
  const double share = (value - visible.min) / visible.width();
  const double low = value - share * width;
  return moved_inside({low, low + width}, whole);
}

ValueRange pan(ValueRange visible, ValueRange whole, double shift) {
  return moved_inside({visible.min + shift, visible.max + shift}, whole);
}

AxisTicks axis_ticks(ValueRange visible, int most) {
  AxisTicks result;
  const double width = visible.width();
  if (!(width > 0) || !std::isfinite(width) || most < 1) return result;
  int decimals = 0;
  const double step = nice_step(width / most, decimals);
  const double magnitude = std::max(std::abs(visible.min), std::abs(visible.max));
  const bool plain = magnitude / step < 1e6 && magnitude < 1e7 && step > 1e-7;
  double base = 0;
  if (!plain) {
    // Far from zero the shared digits are told once; near it the labels are just small (or large) numbers.
    int base_decimals = 0;
    const double coarse = nice_step(width * 2, base_decimals);
    base = magnitude > 10 * width ? std::round((visible.min + visible.max) / 2 / coarse) * coarse : 0;
    if (base != 0) {
      base = base_decimals > 0 ? rounded(base, base_decimals) : base;
      result.offset = fmt::format("{} +", base);
    }
  }
  const double first = std::ceil((visible.min - base) / step), last = std::floor((visible.max - base) / step);
  for (double k = first; k <= last && result.ticks.size() <= std::size_t(most) + 1; ++k) {
    const double offset = k == 0 ? 0 : k * step;
    result.ticks.push_back(
        {base + offset, plain ? fmt::format("{:.{}f}", offset, decimals) : fmt::format("{:.6g}", offset)});
  }
  return result;
}

double round_to_resolution(double value, double resolution) {
  if (!std::isfinite(value) || !(resolution > 0) || !std::isfinite(resolution)) return value;
  const int decimals = -int(std::floor(std::log10(resolution))) + 1;
  if (decimals > 300) return value;
  if (decimals >= 0) return rounded(value, decimals);
  const double quantum = std::pow(10.0, -decimals);
  return std::round(value / quantum) * quantum;
}

double OpacityAxis::unit_of(double opacity) const {
  if (!logarithmic) return std::clamp(opacity, 0.0, 1.0);
  return opacity > 0 ? std::clamp(1 + std::log10(opacity) / opacity_decades, 0.0, 1.0) : 0.0;
}

double OpacityAxis::opacity_at(double unit) const {
  if (!(unit > 0)) return 0;
  if (unit >= 1) return 1;
  return logarithmic ? std::pow(10.0, opacity_decades * (unit - 1)) : unit;
}

}  // namespace crest
