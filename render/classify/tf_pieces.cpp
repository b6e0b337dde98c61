#include "render/classify/tf_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest {
namespace {

float float_below(double value) {
  const float nearest = float(value);
  return double(nearest) <= value ? nearest
                                  : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

float float_above(double value) { return -float_below(-value); }

}  // namespace

std::vector<TfPiece> pieces_of(const TransferFunction& tf, ValueRange field) {
  std::vector<TfPiece> pieces;
  double from = field.min;
  const auto add_up_to = [&](double to) {
    pieces.push_back({from, to, evaluate_right(tf, from), evaluate_left(tf, to)});
    from = to;
  };
  for (const ControlPoint& point : tf.points)
    if (point.value > from && point.value < field.max) add_up_to(point.value);
  if (field.max > from || pieces.empty()) add_up_to(field.max);
  const Classified at_end = evaluate(tf, field.max);
  if (field.max > field.min && !is_same(pieces.back().end, at_end))
    pieces.push_back({field.max, field.max, at_end, at_end});
  return pieces;
}

bool is_same(const Classified& a, const Classified& b) {
  return a.opacity == b.opacity && (a.color == b.color || a.opacity == 0);
}

bool is_step(const std::vector<TfPiece>& pieces, std::size_t i) {
  return i > 0 && !is_same(pieces[i - 1].end, pieces[i].begin);
}

ValueRange changing_range(const std::vector<TfPiece>& pieces) {
  ValueRange range{pieces.front().from, pieces.front().from};
  bool any = false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool changes = !is_same(pieces[i].begin, pieces[i].end);
    if (!changes && !is_step(pieces, i)) continue;
    if (!any) range.min = pieces[i].from;
    range.max = changes ? pieces[i].to : pieces[i].from;
    any = true;
  }
  return range;
}

ValueRange table_range(const std::vector<TfPiece>& pieces) {
  ValueRange range = changing_range(pieces);
  if (range.width() > 0) {
    // What holds below a first step, and what holds at it, are two entries
    const auto first = std::ranges::find(pieces, range.min, &TfPiece::from);
    if (is_step(pieces, std::size_t(first - pieces.begin())))
      range.min -= std::exp2(std::floor(std::log2(range.width() / 4096)));
    return {float_below(range.min), float_above(range.max)};
  }
  // No change, or a single step: it lies between the floats around it, and the table is exact
  const double size = std::max(std::abs(range.min), pieces.back().to - pieces.front().from);
  const float end = float_above(range.max);
  const double least_width = std::max(1e-7 * size, double(std::numeric_limits<float>::min()));
  return {std::min(std::nextafter(end, -std::numeric_limits<float>::infinity()),
                   float_below(double(end) - least_width)),
          end};
}

}  // namespace crest
