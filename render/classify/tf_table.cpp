#include "render/classify/tf_table.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "render/classify/tf_pieces.h"

namespace crest {
namespace {

/// Near one end of a piece: the opacity of one smallest spacing, and how it goes with the TF's value.
struct Local {
  double depth, opacity;  ///< depth = -ln(1 - opacity)
  double slope;           ///< of the opacity
  double bend;            ///< second derivative of the depth
  glm::dvec3 color_slope;
};

/// `spacing` is the smallest one in unit distances.
Local local_at(const TfPiece& piece, const Classified& end, double spacing) {
  const double transmittance = std::max(1 - end.opacity, least_transmittance);
  const double slope = (piece.end.opacity - piece.begin.opacity) / piece.width();
  Local local;
  local.depth = -spacing * std::log(transmittance);
  local.opacity = -std::expm1(-local.depth);
  local.slope = spacing * std::pow(transmittance, spacing - 1) * slope;
  local.bend = spacing * slope * slope / (transmittance * transmittance);
  local.color_slope = (piece.end.color - piece.begin.color) / piece.width();
  return local;
}

double largest_of(glm::dvec3 v) { return std::max({std::abs(v.r), std::abs(v.g), std::abs(v.b)}); }

/// Between two pieces, the change of slope of opacity and premultiplied colour.
struct Corner {
  double value, bend;
};

/// The most that the corners within any range of values add up to.
double most_bend_within(const std::vector<Corner>& corners, double width) {
  double most = 0, sum = 0;
  for (std::size_t first = 0, past = 0; first < corners.size(); sum -= corners[first++].bend) {
    if (past == first) sum = 0;  // no residue of rounding
    for (; past < corners.size() && corners[past].value - corners[first].value <= width; ++past)
      sum += corners[past].bend;
    most = std::max(most, sum);
  }
  return most;
}

/// Between the opacities, and the premultiplied colours, of one smallest spacing of two materials.
double difference(const Classified& a, const Classified& b, double spacing) {
  const auto opacity = [&](const Classified& c) {
    return -std::expm1(spacing * std::log(std::max(1 - c.opacity, least_transmittance)));
  };
  return std::max(std::abs(opacity(a) - opacity(b)), largest_of(opacity(a) * a.color - opacity(b) * b.color));
}

/// What decides a table's size.
struct Demands {
  double entry_width = std::numeric_limits<double>::infinity();  ///< the widest that the smooth parts allow
  double curvature = 0;  ///< greatest second derivative that counts, of the opacity of one smallest spacing
  std::vector<Corner> corners;
  double largest_step = 0, largest_opacity = 0;
  std::optional<ValueRange> narrowest;  ///< that is a feature
};

Demands demands_of(const std::vector<TfPiece>& pieces, double spacing, double longest_ray,
                   const TfTableLimits& limits) {
  Demands demands;
  const auto take = [&](const Local& at) {
    // Depths that are wrong by e(1/L + exp(1) depth) a length change no picture's opacity by more than 1.5 e
    const double allowed = limits.smooth * (1 / longest_ray + std::exp(1.0) * at.depth);
    const double slope = std::abs(at.slope) + at.opacity * largest_of(at.color_slope);
    demands.entry_width =
        std::min({demands.entry_width, std::sqrt(8 * allowed / at.bend), 512 * limits.smooth / slope});
    demands.curvature = std::max(demands.curvature, at.bend * (1 - at.opacity));
    demands.largest_opacity = std::max(demands.largest_opacity, at.opacity);
  };
  const auto take_feature = [&](ValueRange part, double change) {
    if (change > limits.corner && (!demands.narrowest || part.width() < demands.narrowest->width()))
      demands.narrowest = part;
  };
  const ValueRange changing = changing_range(pieces);
  std::optional<Local> before;
  for (std::size_t i = 0; i < pieces.size() && changing.width() > 0; ++i) {
    const TfPiece& piece = pieces[i];
    if (is_step(pieces, i)) {
      const double step = difference(pieces[i - 1].end, piece.begin, spacing);
      demands.largest_step = std::max(demands.largest_step, step);
      take_feature({piece.from, piece.from}, step);
    }
    if (piece.from < changing.min || piece.to > changing.max || !(piece.width() > 0)) continue;
    const Local begin = local_at(piece, piece.begin, spacing), end = local_at(piece, piece.end, spacing);
    take(begin);
    take(end);
    take_feature({piece.from, piece.to}, difference(piece.begin, piece.end, spacing));
    if (before)
      demands.corners.push_back(
          {piece.from, std::abs(begin.slope - before->slope) +
                           begin.opacity * largest_of(begin.color_slope - before->color_slope)});
    before = end;
  }
  return demands;
}

/// So many entries, or somewhat fewer, that each step lies on one, if there is such a number: a region that
/// stays on the step's value, as labels do, then shows what the TF has there, to a thousandth of an entry.
/// Steps a power of two apart from the first, as those at whole numbers are, have one.
int with_steps_on_entries(const std::vector<TfPiece>& pieces, int entries) {
  const ValueRange range = table_range(pieces);
  const auto is_whole = [](double x) { return x == std::floor(x); };
  for (double per_unit = std::exp2(std::floor(std::log2((entries - 1) / range.width()))), bins;
       (bins = range.width() * per_unit) > 0.5 * (entries - 1) - 1; per_unit /= 2) {
    bool all = is_whole(bins);
    for (std::size_t i = 0; i < pieces.size() && all; ++i)
      all = !is_step(pieces, i) || is_whole((pieces[i].from - range.min) * per_unit);
    if (all) return int(bins) + 1;
  }
  return entries;
}

}  // namespace

TfTableSize tf_table_size(const TransferFunction& tf, ValueRange field, double smallest_spacing,
                          double longest_ray, const TfTableLimits& limits) {
  const std::vector<TfPiece> pieces = pieces_of(tf, field);
  const Demands demands = demands_of(pieces, smallest_spacing / tf.unit_distance, longest_ray, limits);
  const double width = table_range(pieces).width();
  if (!(changing_range(pieces).width() > 0)) return {};
  double entry = std::min(width, demands.entry_width);
  if (demands.largest_step > 0) entry = 0;
  for (int i = 0; i < 2; ++i)  // first as if each were alone in an entry, then with those that are not
    entry = std::min(entry, 4 * limits.corner / most_bend_within(demands.corners, i == 0 ? 0 : entry));

  TfTableSize size;
  constexpr int most = largest_tf_table;
  size.entries = width < (most - 1) * entry ? std::max(2, 1 + int(std::ceil(width / entry))) : most;
  if (demands.largest_step > 0) size.entries = with_steps_on_entries(pieces, size.entries);
  const bool is_largest = demands.largest_step > 0 || size.entries == most;
  entry = width / (size.entries - 1);
  size.error = std::max({most_bend_within(demands.corners, entry) * entry / 4,
                         demands.curvature * entry * entry / 8, demands.largest_step});
  size.error = std::min(size.error, demands.largest_opacity);
  if (is_largest && demands.narrowest && demands.narrowest->width() < entry) size.blurred = demands.narrowest;
  return size;
}

bool is_constant(const TransferFunction& tf, ValueRange field) {
  const std::vector<TfPiece> pieces = pieces_of(tf, field);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (is_step(pieces, i) || !is_same(pieces[i].begin, pieces[i].end)) return false;
  return true;
}

double largest_opacity(const TransferFunction& tf, ValueRange field) {
  double largest = 0;
  for (const TfPiece& piece : pieces_of(tf, field))
    largest = std::max({largest, piece.begin.opacity, piece.end.opacity});
  return largest;
}

TableBlur tf_table_blur(const TransferFunction& tf, ValueRange field, int entries) {
  const ValueRange range = table_range(pieces_of(tf, field));
  return {range.width() / (entries - 1), range};
}

TfTable build_tf_table(const TransferFunction& tf, ValueRange field, double smallest_spacing, int entries) {
  TfTable table;
  table.range = table_range(pieces_of(tf, field));
  table.entries.resize(std::size_t(entries));
  for (int i = 0; i < entries; ++i) {
    const double value =
        i + 1 == entries ? table.range.max : table.range.min + table.range.width() * i / (entries - 1);
    const bool stands_for_all_below = i == 0 && field.min < table.range.min;
    const Classified material = stands_for_all_below ? evaluate_left(tf, value) : evaluate(tf, value);
    const double per_spacing = extinction(material.opacity, tf.unit_distance) * smallest_spacing;
    table.entries[std::size_t(i)] = glm::vec4(material.color, float(std::min(per_spacing, most_extinction)));
  }
  return table;
}

}  // namespace crest
