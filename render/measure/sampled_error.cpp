#include "render/measure/sampled_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Standard deviations to either end: 97.7 % of a normal distribution lie below the upper one.
constexpr double deviations = 2;
constexpr double p999_share = 0.001;

struct Interval {
  double low = 0, high = infinity;
};

/// Wilson's, for a proportion of which `found` were met among `count`.
Interval proportion(double found, double count) {
  if (count <= 0) return {0, 1};
  const double z2 = deviations * deviations;
  const double middle = found + z2 / 2;
  const double half = deviations * std::sqrt(found * (1 - found / count) + z2 / 4);
  return {std::max(middle - half, 0.0) / (count + z2), (middle + half) / (count + z2)};
}

/// Of the value that a thousandth of all pixels exceed.
Interval quantile(std::vector<PixelDifference> differences) {
  std::ranges::sort(differences, std::greater{}, &PixelDifference::most);
  Interval interval;
  const double count = double(differences.size());
  for (std::size_t i = 0; i < differences.size(); ++i) {  // i differences are greater than this one
    const Interval greater = proportion(double(i), count);
    if (greater.high <= p999_share) interval.high = differences[i].most;
    if (greater.low > p999_share) return {differences[i].most, interval.high};
  }
  return interval;
}

Interval root_mean_square(const std::vector<PixelDifference>& differences) {
  const double count = double(differences.size());
  double mean = 0, variance = 0;
  for (const auto& d : differences) mean += d.squares / 4 / count;
  for (const auto& d : differences) variance += (d.squares / 4 - mean) * (d.squares / 4 - mean) / count;
  const double doubt = deviations * std::sqrt(variance / count);
  // Pixels that are off by 1, too few for one to be among these
  const double unseen = proportion(0, count).high;
  return {std::sqrt(std::max(mean - doubt, 0.0)), std::sqrt(mean + doubt + unseen)};
}

/// Of crossings of which a share is missed, or invented: those of one ray are not independent, so that rays
/// are counted.
Interval crossings_interval(double found, double all, const Reference& exact) {
  if (all <= 0) return {};
  const auto rays = std::ranges::count_if(exact.crossings, [](std::uint32_t n) { return n > 0; });
  return proportion(std::min(found / all, 1.0) * double(rays), double(rays));
}

Interval interval_of(std::string_view measure, const ImageError& error, const Reference& exact,
                     const std::vector<PixelDifference>& differences) {
  const double count = double(differences.size());
  if (measure == "share") {
    const auto off = [](const PixelDifference& d) { return d.most > one_step_of_8_bits; };
    return proportion(double(std::ranges::count_if(differences, off)), count);
  }
  if (measure == "p999") return quantile(differences);
  if (measure == "rmse") return root_mean_square(differences);
  if (measure == "max") return {error.compared.max, infinity};
  if (!error.crossings) return {};
  const auto& crossings = *error.crossings;
  if (measure == "missed") return crossings_interval(crossings.missed, crossings.exact, exact);
  if (measure == "invented") return crossings_interval(crossings.invented, crossings.exact, exact);
  return {};
}

}  // namespace

SampledError sampled_error(const ErrorMeasure& measure, const Reference& exact, const Image& image,
                           std::span<const std::uint32_t> crossings, glm::vec3 background, bool is_whole) {
  const bool needs_flip = is_whole && measure.id == "flip";
  const ImageError error =
      image_error(exact, image, crossings, needs_flip ? std::optional(background) : std::nullopt);
  SampledError sampled{.rays = error.compared.pixels, .value = measure.value(error), .high = infinity};
  if (is_whole) {
    // Where nothing shows nothing is off
    if (sampled.rays == 0) sampled.value = 0;
    sampled.low = sampled.high = sampled.value;
    return sampled;
  }
  if (sampled.rays == 0) return sampled;
  const Interval interval = interval_of(measure.id, error, exact, compared_differences(exact, image));
  sampled.low = interval.low;
  sampled.high = interval.high;
  return sampled;
}

Verdict judge(const SampledError& error, const TargetError& target) {
  if (error.high <= target.most) return Verdict::met;
  return error.low > target.most ? Verdict::missed : Verdict::unclear;
}

}  // namespace crest
