#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "render/gl/program_cache.h"
#include "render/resources/keyed_cache.h"

namespace crest {

/// Beyond what the last pictures take, so much is kept of what was drawn before them.
inline constexpr std::size_t held_bytes = std::size_t(1) << 30;

/// All that the engines of one GL context hold on the graphics device, and what is derived from a volume and
/// a TF on the way there. The other files of this folder say what there is, and what each depends on. The
/// context must be current whenever it is used, and when it dies.
struct Resources {
  /// Shaders are read from `shader_folder`, or, when it is empty, from the program itself. Linked programs
  /// are kept in `program_folder` for the next start, unless it is empty.
  explicit Resources(std::filesystem::path shader_folder = {}, std::filesystem::path program_folder = {},
                     std::size_t limit_bytes = held_bytes)
      : programs(std::move(shader_folder), std::move(program_folder)), held(limit_bytes) {}

  gl::ProgramCache programs;
  KeyedCache held;
  /// Volumes whose texture would be larger are drawn from bricks, of which so many bytes are held.
  std::size_t whole_volume_bytes = std::size_t(1) << 31, atlas_bytes = std::size_t(1) << 33;
  std::optional<double> weight_error;  ///< of the texture unit (gl/filter_weights.h), once somebody asked
};

}  // namespace crest
