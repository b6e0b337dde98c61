#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "presets/error.h"
#include "presets/export_formats.h"

namespace crest {
namespace {

constexpr int most_samples = 1 << 20;

/// Equidistant values over the TF's span; one of no width counts as 1.
struct Rows {
  double min, max;
  int count;

  Rows(const TransferFunction& tf, const ExportOptions& options)
      : min(tf.range().min), max(tf.range().width() > 0 ? tf.range().max : min + 1), count(options.samples) {
    if (count < 2 || count > most_samples)
      throw Error(fmt::format("{} samples are not in [2, {}]", count, most_samples));
  }
  double spacing() const { return (max - min) / (count - 1); }
  double value(int row) const { return std::lerp(min, max, double(row) / (count - 1)); }
};

/// What a reader of the table gets at `value`, by interpolating its rows linearly.
double table_opacity(const TransferFunction& tf, const Rows& rows, double value) {
  const double position = std::clamp((value - rows.min) / rows.spacing(), 0.0, double(rows.count - 1));
  const int row = std::min(int(position), rows.count - 2);
  return std::lerp(evaluate(tf, rows.value(row)).opacity, evaluate(tf, rows.value(row + 1)).opacity,
                   position - row);
}

int peaks_between_rows(const TransferFunction& tf, double spacing) {
  int count = 0;
  for (std::size_t i = 1; i + 1 < tf.points.size(); ++i) {
    const ControlPoint &before = tf.points[i - 1], &point = tf.points[i], &after = tf.points[i + 1];
    if (point.opacity > before.opacity && point.opacity > after.opacity &&
        after.value - before.value < spacing)
      ++count;
  }
  return count;
}

}  // namespace

std::string write_csv(std::string_view, const TransferFunction& tf, const ExportOptions& options) {
  const Rows rows(tf, options);
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "value,red,green,blue,opacity,extinction\n");
  for (int row = 0; row < rows.count; ++row) {
    const double value = rows.value(row);
    const auto [color, opacity] = evaluate(tf, value);
    fmt::format_to(out, "{},{},{},{},{},{}\n", value, color.r, color.g, color.b, opacity,
                   extinction(opacity, tf.unit_distance));
  }
  return fmt::to_string(text);
}

std::string csv_losses(const TransferFunction& tf, const ExportOptions& options) {
  const Rows rows(tf, options);
  double largest_error = 0, at_value = 0;
  for (const ControlPoint& point : tf.points) {
    const double error = std::abs(table_opacity(tf, rows, point.value) - point.opacity);
    if (error > largest_error) {
      largest_error = error;
      at_value = point.value;
    }
  }
  std::string losses;
  if (largest_error > 1e-9)
    losses += fmt::format(
        "{} rows are {} apart: the opacity is off by up to {:.3g} at the control points (at {})\n",
        rows.count, rows.spacing(), largest_error, at_value);
  if (const int count = peaks_between_rows(tf, rows.spacing()))
    losses += fmt::format("peaks narrower than the distance of two rows: {}\n", count);
  return losses + surface_losses(tf);
}

}  // namespace crest
