#pragma once

#include <cstdint>
#include <filesystem>

#include "render/reference/reference.h"

namespace crest {

struct CachedReference {
  Reference reference;
  bool from_cache = false;
};

inline constexpr std::uintmax_t default_cache_bytes = std::uintmax_t(512) << 20;

/// render_reference, or what it gave earlier for the same content, from a file in `folder`: the field and its
/// grid, its filters, the TF, the clip box, the camera, and the arguments. Throws Error, Cancelled.
///
/// What a cache cannot do is no error: a file that is damaged or of something else counts as none, and where
/// none can be written (or `folder` is empty) the picture is rendered each time. The folder's files keep to
/// `limit_bytes` together; the ones that were used longest ago go first. Programs may share a folder.
CachedReference render_reference_cached(const std::filesystem::path& folder, std::uintmax_t limit_bytes,
                                        const Scene& scene, const Camera& camera, glm::ivec2 size,
                                        Answer answer, double tolerance = default_tolerance,
                                        const Progress& progress = {});

}  // namespace crest
