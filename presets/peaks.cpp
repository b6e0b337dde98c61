#include "presets/peaks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace crest {
namespace {

using Points = std::vector<ControlPoint>;

/// Successive points of equal opacity. Neighbouring runs differ in opacity.
struct Run {
  std::size_t first = 0, last = 0;
};

std::vector<Run> runs_of(const Points& points) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && points[i].opacity == points[i - 1].opacity)
      runs.back().last = i;
    else
      runs.push_back({i, i});
  }
  return runs;
}

double width_of(const Points& points, Run run) { return points[run.last].value - points[run.first].value; }

/// Whether b lies on the line from a to c in opacity: its slopes to both agree to 1e-9, beside what rounding
/// does to a value and an opacity. A peak or a minimum never lies on a line.
bool on_line(const ControlPoint& a, const ControlPoint& b, const ControlPoint& c) {
  const auto [low, high] = std::minmax(a.opacity, c.opacity);
  if (b.opacity < low || b.opacity > high) return false;
  if (a.value == c.value) return true;
  const double slope = (c.opacity - a.opacity) / (c.value - a.value);
  const double off = b.opacity - std::lerp(a.opacity, c.opacity, (b.value - a.value) / (c.value - a.value));
  const double shorter_arm = std::min(std::abs(b.opacity - a.opacity), std::abs(c.opacity - b.opacity));
  const double rounding = 4 * std::numeric_limits<double>::epsilon() *
                          (high + std::abs(slope) * std::max(std::abs(a.value), std::abs(c.value)));
  return std::abs(off) <= 1e-9 * shorter_arm + rounding;
}

/// The runs at which the TF's opacity bends, by one pass with a stack.
std::vector<Run> corners_of(const Points& points, const std::vector<Run>& runs) {
  std::vector<Run> corners;
  for (const Run& run : runs) {
    while (corners.size() >= 2) {
      const ControlPoint& before = points[corners[corners.size() - 2].last];
      const Run middle = corners.back();
      // Both ends: on a gentle slope, points side by side may round to the same opacity.
      if (!on_line(before, points[middle.first], points[run.first]) ||
          !on_line(before, points[middle.last], points[run.first]))
        break;
      corners.pop_back();
    }
    corners.push_back(run);
  }
  return corners;
}

/// For each point the least opacity from it back to the nearest strictly higher point, or to the start:
/// scipy.signal.peak_prominences' base on that side, for all points in one pass.
template <class Iterator>
std::vector<double> side_minima(Iterator begin, Iterator end) {
  struct Hill {
    double opacity, minimum;
  };
  std::vector<Hill> higher;
  std::vector<double> minima;
  for (; begin != end; ++begin) {
    double minimum = begin->opacity;
    for (; !higher.empty() && higher.back().opacity <= begin->opacity; higher.pop_back())
      minimum = std::min(minimum, higher.back().minimum);
    higher.push_back({begin->opacity, minimum});
    minima.push_back(minimum);
  }
  return minima;
}

std::vector<double> prominences_of(const Points& points) {
  const std::vector<double> left = side_minima(points.begin(), points.end());
  std::vector<double> right = side_minima(points.rbegin(), points.rend());
  std::reverse(right.begin(), right.end());
  std::vector<double> prominences(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    prominences[i] = points[i].opacity - std::max(left[i], right[i]);
  return prominences;
}

/// The points at both ends of each corner, ascending: where flanks start and end.
std::vector<std::size_t> flank_ends_of(const Points& points, const std::vector<Run>& runs) {
  std::vector<std::size_t> ends;
  for (const Run& corner : corners_of(points, runs)) {
    ends.push_back(corner.first);
    if (corner.last != corner.first) ends.push_back(corner.last);
  }
  return ends;
}

/// From where the flank before `run` starts to where the one after it ends; its own points at the TF's ends.
Run with_flanks(Run run, const std::vector<std::size_t>& flank_ends) {
  const auto left = std::lower_bound(flank_ends.begin(), flank_ends.end(), run.first);
  const auto right = std::upper_bound(flank_ends.begin(), flank_ends.end(), run.last);
  return {left == flank_ends.begin() ? run.first : *std::prev(left),
          right == flank_ends.end() ? run.last : *right};
}

/// The peak rule but for the prominence.
bool is_local_maximum(const TransferFunction& tf, Run run) {
  if (run.first == 0 || run.last + 1 == tf.points.size()) return false;
  const double width = width_of(tf.points, run);
  if (width > 0 && width >= tf.plateau_width) return false;
  const ControlPoint &first = tf.points[run.first], &last = tf.points[run.last];
  const ControlPoint &before = tf.points[run.first - 1], &after = tf.points[run.last + 1];
  const bool step_up = before.value == first.value, step_down = after.value == last.value;
  return before.opacity < first.opacity && after.opacity < last.opacity && step_up == step_down;
}

/// The peak or surface that `run` makes, without what its surroundings tell of it.
Peak make_peak(const TransferFunction& tf, Run run) {
  const ControlPoint &first = tf.points[run.first], &last = tf.points[run.last];
  Peak peak;
  peak.value = std::midpoint(first.value, last.value);
  // A spike of no width has its own colour; the TF at its value already is what follows it.
  peak.color = first.value == last.value ? last.color : evaluate(tf, peak.value).color;
  peak.opacity = last.opacity;
  for (std::size_t i = run.last + 1; i-- > run.first;)
    peak.opacity = tf.points[i].surface.opacity.value_or(peak.opacity);
  peak.first_point = run.first;
  peak.last_point = run.last;
  return peak;
}

bool any_point_is(const Points& points, Run run, SurfaceMode mode) {
  return std::any_of(points.begin() + std::ptrdiff_t(run.first),
                     points.begin() + std::ptrdiff_t(run.last + 1),
                     [mode](const ControlPoint& p) { return p.surface.mode == mode; });
}

}  // namespace

std::vector<Peak> find_peaks(const TransferFunction& tf) {
  const Points& points = tf.points;
  const std::vector<Run> runs = runs_of(points);
  const std::vector<std::size_t> flank_ends = flank_ends_of(points, runs);
  const std::vector<double> prominences = prominences_of(points);
  const double widest_spike =
      tf.spike_width * tf.range().width() * (1 + 1e-9);  // 0.505 - 0.495 is within 0.01

  std::vector<Peak> peaks;
  const auto add = [&](Run run, bool detected) {
    if (!detected && !any_point_is(points, run, SurfaceMode::on)) return;
    const Run flanks = with_flanks(run, flank_ends);
    Peak peak = make_peak(tf, run);
    peak.left = flanks.first;
    peak.right = flanks.last;
    peak.width = width_of(points, flanks);
    peak.prominence = prominences[run.first];
    peak.detected = detected;
    peak.shown = !any_point_is(points, run, SurfaceMode::off);
    peak.spike = detected && peak.width <= widest_spike;
    peaks.push_back(peak);
  };
  for (const Run& run : runs) {
    const bool detected = is_local_maximum(tf, run) && prominences[run.first] >= tf.min_prominence;
    if (detected || width_of(points, run) == 0) {
      add(run, detected);
    } else {
      for (std::size_t i = run.first; i <= run.last; ++i) add({i, i}, false);
    }
  }
  return peaks;
}

std::vector<Peak> shown_peaks(const std::vector<Peak>& peaks) {
  std::vector<Peak> shown;
  std::copy_if(peaks.begin(), peaks.end(), std::back_inserter(shown), [](const Peak& p) { return p.shown; });
  return shown;
}

TransferFunction base_transfer_function(const TransferFunction& tf, const std::vector<Peak>& peaks) {
  TransferFunction base = tf;
  base.points.clear();
  std::size_t next = 0;  // of tf's points
  const auto copy_up_to = [&](std::size_t last) {
    for (; next <= last && next < tf.points.size(); ++next) base.points.push_back(tf.points[next]);
  };
  for (const Peak& peak : peaks) {
    if (!peak.spike || !peak.shown) continue;
    copy_up_to(peak.left);
    next = std::max(next, peak.right);
  }
  copy_up_to(tf.points.size());
  return base;
}

}  // namespace crest
