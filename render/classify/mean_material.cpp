#include "render/classify/mean_material.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/classify/tf_pieces.h"

namespace crest {
namespace {

/// The mean of a function of u in [0, 1], and its first moment, the integral of u times it.
struct Moments {
  double mean = 0, first = 0;
};

/// Of -ln(1 - p u), for p in [0, 1). The closed forms cancel at p = 0, about which the series are exact.
Moments moments_of_log(double p) {
  if (p > 0.1) {
    const double log = std::log1p(-p), q = 1 / p;
    return {1 + (q - 1) * log, 0.25 + 0.5 * q + 0.5 * (q * q - 1) * log};
  }
  Moments sum;
  double power = p;
  for (int k = 1; k <= 15; ++k, power *= p) {
    sum.mean += power / (k * (k + 1));
    sum.first += power / (k * (k + 2));
  }
  return sum;
}

/// Of the extinction where the opacity goes linearly from `low` to `high`, no less.
Moments moments_of_extinction(double low, double high) {
  const double largest = -std::log(least_transmittance), transmittance = 1 - low;
  if (transmittance <= least_transmittance) return {largest, largest / 2};
  // Up to where the cap begins
  const double uncapped =
      high > low ? std::min(1.0, (transmittance - least_transmittance) / (high - low)) : 1.0;
  const Moments log = moments_of_log((high - low) * uncapped / transmittance);
  const double at_low = -std::log1p(-low);
  return {uncapped * (log.mean + at_low) + (1 - uncapped) * largest,
          uncapped * uncapped * (log.first + at_low / 2) + (1 - uncapped * uncapped) * largest / 2};
}

/// The part of a piece between two values.
MeanMaterial mean_between(const TfPiece& piece, double from, double to) {
  const auto at = [&](double value) -> Classified {
    const double place = (value - piece.from) / piece.width();
    return {glm::mix(piece.begin.color, piece.end.color, place),
            std::lerp(piece.begin.opacity, piece.end.opacity, place)};
  };
  return mean_material(from > piece.from ? at(from) : piece.begin, to < piece.to ? at(to) : piece.end);
}

}  // namespace

MeanMaterial mean_material(const Classified& begin, const Classified& end) {
  const bool rises = begin.opacity <= end.opacity;
  const Classified &low = rises ? begin : end, &high = rises ? end : begin;
  const Moments extinction = moments_of_extinction(low.opacity, high.opacity);
  return {low.color * (extinction.mean - extinction.first) + high.color * extinction.first, extinction.mean};
}

std::vector<MeanMaterial> mean_materials(const TransferFunction& tf, ValueRange range, int count) {
  std::vector<MeanMaterial> means(std::size_t(count), MeanMaterial(0));
  const double width = range.width() / count;
  const auto begin_of = [&](std::size_t i) {
    return i == means.size() ? range.max : range.min + double(i) * width;
  };
  std::size_t i = 0;
  for (const TfPiece& piece : pieces_of(tf, range)) {
    for (double from = piece.from; from < piece.to;) {
      const double to = std::min(begin_of(i + 1), piece.to);
      means[i] += mean_between(piece, from, to) * ((to - from) / width);
      if (to == begin_of(i + 1)) ++i;
      from = to;
    }
  }
  return means;
}

}  // namespace crest
