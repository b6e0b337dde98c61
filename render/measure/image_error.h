#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/files/image.h"
#include "render/reference/reference.h"

namespace crest {

/// How far apart two pictures are, over some of their pixels: of premultiplied RGBA, each channel in [0, 1].
/// A pixel's difference is that of its most different channel.
struct PixelErrors {
  std::size_t pixels = 0;
  double rmse = 0;   ///< over all four channels
  double max = 0;    ///< largest difference of a pixel
  double p999 = 0;   ///< 99.9th percentile of the pixels' differences
  double share = 0;  ///< of the pixels, those off by more than 1/255
  double flip = 0;   ///< mean of LDR-FLIP over the background (see flip.h)
  bool operator==(const PixelErrors&) const = default;
};

/// How far a picture is from the exact one.
struct ImageError {
  /// Over the compared pixels: those where either picture has alpha > 0, without the grazing ones.
  PixelErrors compared;
  /// Over the grazing pixels alone (Reference::grazing): there a renderer in 32-bit float cannot know.
  PixelErrors grazing;
  /// Crossings of the compared pixels' rays: in the exact picture; those of them that were not found; and
  /// those found beyond. Nothing when the picture's crossings are not known.
  struct Crossings {
    double exact = 0, missed = 0, invented = 0;
    bool operator==(const Crossings&) const = default;
  };
  std::optional<Crossings> crossings;
  bool operator==(const ImageError&) const = default;

  double grazing_share() const;  ///< of all pixels where either picture has alpha > 0
};

/// Compares a picture with the exact one of the same size, for FLIP over `background`; without one FLIP,
/// which takes longer than all the rest, is NaN. `crossings` are those that were composited, by pixel; or
/// empty.
ImageError image_error(const Reference& exact, const Image& image, std::span<const std::uint32_t> crossings,
                       std::optional<glm::vec3> background);

/// One number that tells an error, of which less is better.
struct ErrorMeasure {
  std::string_view id;    ///< "rmse": as --target-error and the files call it
  std::string_view name;  ///< for people
  double (*value)(const ImageError& error);
};

/// share, rmse, max, p999, flip, missed, invented: one table for the command line, the files and the studio.
/// Missed and invented crossings count as a share of the exact picture's; they are NaN where they are not
/// known, as the others are where no pixel is compared.
std::span<const ErrorMeasure> error_measures();

/// How far a pixel is off: its most different channel, and the squares of all four.
struct PixelDifference {
  double most = 0, squares = 0;
};
/// Those of the compared pixels, in the order of the picture.
std::vector<PixelDifference> compared_differences(const Reference& exact, const Image& image);

/// A pixel that differs by more is off, as `share` counts it.
inline constexpr double one_step_of_8_bits = 1.0 / 255;

/// What is asked of a picture: at most so much error, in one measure.
struct TargetError {
  const ErrorMeasure* measure = nullptr;  ///< one of error_measures()
  double most = 0;

  bool is_met(const ImageError& error) const { return measure->value(error) <= most; }
};

/// At most 0.1 % of the compared pixels off by more than 1/255.
TargetError default_target();

/// "share=0.001", "rmse=1e-3", "missed=0.01", ... Throws Error that says what would be right.
TargetError parse_target(std::string_view text);
std::string to_string(const TargetError& target);

/// By pixel the difference that PixelErrors speaks of.
std::vector<float> pixel_differences(const Image& a, const Image& b);

}  // namespace crest
