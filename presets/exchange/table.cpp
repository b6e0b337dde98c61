#include "presets/exchange/table.h"

#include <algorithm>
#include <cmath>

namespace crest {
namespace {

using Points = std::vector<ControlPoint>;

/// One step of an 8-bit picture.
constexpr double tolerance = 1.0 / 255;

bool is_within(double value, ValueRange range) { return value >= range.min && value <= range.max; }

/// A point, or several of one opacity, higher than what is on either side: as peaks are found, shown or not.
struct Summit {
  std::size_t point;  ///< whose colour it has
  double first, last;

  double middle() const { return 0.5 * (first + last); }
};

std::vector<Summit> summits_of(const Points& points) {
  std::vector<Summit> summits;
  for (std::size_t first = 0, past = 0; first < points.size(); first = past) {
    while (past < points.size() && points[past].opacity == points[first].opacity) ++past;
    const double opacity = points[first].opacity;
    if (first > 0 && past < points.size() && points[first - 1].opacity < opacity &&
        points[past].opacity < opacity)
      summits.push_back({first, points[first].value, points[past - 1].value});
  }
  return summits;
}

/// Where a value lies among the rows.
double row_of(double value, ValueRange range, int count) {
  return (value - range.min) / range.width() * (count - 1);
}

glm::dvec4 exact(const TransferFunction& tf, double value) {
  const auto [color, opacity] = evaluate(tf, value);
  return {color, opacity};
}

double row_value(ValueRange range, std::size_t row, int count) {
  return std::lerp(range.min, range.max, double(row) / (count - 1));
}

/// How far a table's entry is from a point: in opacity, and in colour as far as that shows.
double distance(const glm::dvec4& entry, const ControlPoint& point) {
  const glm::dvec3 off = glm::dvec3(entry) * entry.a - point.color * point.opacity;
  return std::max({std::abs(entry.a - point.opacity), std::abs(off.r), std::abs(off.g), std::abs(off.b)});
}

/// The rows of a table, those of peaks put in; only those that are asked for are made.
class Rows {
 public:
  Rows(const TransferFunction& tf, const std::vector<Summit>& summits, ValueRange range, int count)
      : tf_(tf), range_(range), count_(count) {
    for (const Summit& summit : summits) {
      if (!is_within(summit.middle(), range)) continue;
      const double first = row_of(summit.first, range, count), last = row_of(summit.last, range, count);
      if (std::ceil(first) <= std::floor(last) && summit.first < summit.last) continue;  // a row is on it
      const auto row = std::size_t(std::lround(row_of(summit.middle(), range, count)));
      const bool is_between = row_value(range, row, count) != summit.middle();
      if (!peaks_.empty() && peaks_.back().row == row) {
        ++lost;
        if (tf.points[peaks_.back().point].opacity < tf.points[summit.point].opacity)
          peaks_.back() = {row, summit.point, is_between};
      } else {
        peaks_.push_back({row, summit.point, is_between});
      }
    }
    widened = int(std::ranges::count_if(peaks_, &PeakRow::is_between));
  }

  glm::dvec4 at(std::size_t row) const {
    const auto found = std::ranges::lower_bound(peaks_, row, {}, &PeakRow::row);
    if (found != peaks_.end() && found->row == row) {
      const ControlPoint& point = tf_.points[found->point];
      return {point.color, point.opacity};
    }
    return exact(tf_, row_value(range_, row, count_));
  }

  /// How far the table is from a point, after interpolation; or of the rows about it, the best.
  double error_at(std::size_t i) const {
    const ControlPoint& point = tf_.points[i];
    if (!is_within(point.value, range_)) return 0;
    const double place = row_of(point.value, range_, count_);
    const auto below = std::min(std::size_t(place), std::size_t(count_ - 2));
    const double between = place - double(below);
    double error = distance(at(below) * (1 - between) + at(below + 1) * between, point);
    if (!is_crowded(i) && !is_tip(i)) return error;
    const auto first = std::size_t(std::max(0.0, std::ceil(place - 1.5)));
    const auto last = std::size_t(std::min(count_ - 1.0, std::floor(place + 1.5)));
    for (std::size_t row = first; row <= last; ++row) error = std::min(error, distance(at(row), point));
    return error;
  }

  int widened = 0, lost = 0;

 private:
  struct PeakRow {
    std::size_t row, point;
    bool is_between;
  };
  bool is_tip(std::size_t i) const {
    const auto found = std::ranges::lower_bound(peaks_, i, {}, &PeakRow::point);
    return found != peaks_.end() && found->point == i;
  }
  bool is_crowded(std::size_t i) const {
    const double least = 2 * range_.width() / most_automatic_rows;
    const Points& points = tf_.points;
    return (i > 0 && points[i].value - points[i - 1].value < least) ||
           (i + 1 < points.size() && points[i + 1].value - points[i].value < least);
  }

  const TransferFunction& tf_;
  ValueRange range_;
  int count_;
  std::vector<PeakRow> peaks_;
};

}  // namespace

double TfTable1d::value(std::size_t row) const { return row_value(range, row, int(rows.size())); }

TfTable1d make_table(const TransferFunction& tf, ValueRange range, int count) {
  const Rows rows(tf, summits_of(tf.points), range, count);
  TfTable1d table{.range = range, .rows = {}, .widened = rows.widened, .lost = rows.lost};
  table.rows.reserve(std::size_t(count));
  for (std::size_t row = 0; row < std::size_t(count); ++row) table.rows.push_back(rows.at(row));
  for (std::size_t i = 0; i < tf.points.size(); ++i)
    if (const double error = rows.error_at(i); error > table.largest_error) {
      table.largest_error = error;
      table.at_value = tf.points[i].value;
    }
  return table;
}

int fewest_rows(const TransferFunction& tf, ValueRange range) {
  if (tf.points.size() > most_automatic_rows / 4)
    return most_automatic_rows;  // hardly fewer, and long to find
  const std::vector<Summit> summits = summits_of(tf.points);
  // Two peaks that are apart by less than a row's width may share one
  double least_gap = range.width();
  for (std::size_t i = 1; i < summits.size(); ++i)
    least_gap = std::min(least_gap, summits[i].middle() - summits[i - 1].middle());
  const double least = std::max(0.5 * range.width() / std::max(least_gap, 1e-300), 2.0);
  if (!(least < most_automatic_rows)) return most_automatic_rows;
  std::size_t hardest = 0;  // which failed last is asked first
  for (int count = int(least); count < most_automatic_rows; ++count) {
    const Rows rows(tf, summits, range, count);
    if (rows.lost > 0) continue;
    const auto fails = [&](std::size_t i) { return rows.error_at(i) > tolerance; };
    if (fails(hardest)) continue;
    bool holds = true;
    for (std::size_t i = 0; holds && i < tf.points.size(); ++i)
      if (fails(i)) {
        holds = false;
        hardest = i;
      }
    if (holds) return count;
  }
  return most_automatic_rows;
}

}  // namespace crest
