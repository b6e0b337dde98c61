#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace crest {

/// The values from `min` to `max`, both included.
struct ValueRange {
  double min = 0, max = 1;
  double width() const { return max - min; }
  bool operator==(const ValueRange&) const = default;
};

/// The range, or where it has no width, one of width 1.
ValueRange with_width(ValueRange range);

/// Whether a control point is shown as a surface: as the peak rule says, always, or never.
enum class SurfaceMode { automatic, on, off };

struct Surface {
  SurfaceMode mode = SurfaceMode::automatic;
  std::optional<double> opacity;  ///< in [0, 1]; without it the point's own
  bool operator==(const Surface&) const = default;
};

struct ControlPoint {
  double value = 0;     ///< in the units of the TF's domain
  glm::dvec3 color{1};  ///< display-referred RGB in [0, 1]
  double opacity = 0;   ///< in [0, 1]: what one unit distance of this material absorbs
  Surface surface;
  std::string unknown;  ///< JSON object of keys that this version does not know, kept as they were; or empty
  bool operator==(const ControlPoint&) const = default;
};

/// What the values of the points are: the volume's own numbers, or 0..1 over the volume's range.
enum class Domain { data, normalized };
/// What `unit_distance` is measured in: world units, or the volume's smallest spacing.
enum class LengthUnit { world, voxel };

/// A one-dimensional, piecewise-linear transfer function: constant beyond its ends, linear in colour and in
/// opacity between its points, which are in file order with non-decreasing values. Points may share a value:
/// two make a step, three (0, a, 0) a spike of no width; at the value itself the last one holds.
struct TransferFunction {
  Domain domain = Domain::data;
  double unit_distance = 1;  ///< > 0
  LengthUnit unit = LengthUnit::world;
  double min_prominence = 0;  ///< least topographic prominence of a peak, in opacity
  double plateau_width = 0;   ///< a flat top narrower than this is one peak; in the domain's units
  double spike_width =
      0.01;  ///< a peak whose neighbours are no further apart is a spike; fraction of the points' range
  std::vector<ControlPoint> points;
  std::string unknown;

  /// From the first point's value to the last one's.
  ValueRange range() const;
  bool operator==(const TransferFunction&) const = default;
};

/// The TF at one value.
struct Classified {
  glm::dvec3 color{0};
  double opacity = 0;
};

/// The TF at `value`, exactly: at a shared value the last point holds. No points: nothing is shown.
Classified evaluate(const TransferFunction& tf, double value);
/// The limit from below, and from above: they differ where points share the value.
Classified evaluate_left(const TransferFunction& tf, double value);
Classified evaluate_right(const TransferFunction& tf, double value);

/// Least transmittance of one unit distance: opacities above 1 - 2^-24 count as that.
inline constexpr double least_transmittance = 0x1p-24;

/// The extinction of a material that absorbs `opacity` in one `unit_distance`: -ln(max(1-a, 2^-24)) / unit.
double extinction(double opacity, double unit_distance);

/// The same TF in the units of a volume: domain `data`, unit `world`. A range of no width counts as one of 1.
TransferFunction resolve(const TransferFunction& tf, ValueRange volume_range, double smallest_spacing);

/// The TF with its values mapped linearly from `from` to `to` (widths in the value's units too).
TransferFunction remap_values(const TransferFunction& tf, ValueRange from, ValueRange to);

/// A first TF that shows something of any volume: normalized, a ramp from clear to half opaque, unit in
/// voxels.
TransferFunction default_transfer_function();

}  // namespace crest
