#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "render/reference/cache.h"

namespace crest {

/// What statistics call it.
inline constexpr const char* exact_renderer = "exact reference on the CPU, in double precision";

/// An exact answer's picture, and what it took.
struct ExactPicture {
  Answer answer;
  Reference reference;
  double ms = 0;  ///< in this run: of rendering it, or of reading it from the cache
  bool from_cache = false;
  std::vector<std::string> warnings;  ///< volume_warnings()
  std::vector<std::string> notes;     ///< picture_notes()
};

/// The exact answer of each scene's mode (the first of answers_of), with a progress bar. They are kept in the
/// cache folder. Throws Error, also when it was interrupted; `output` is named in that.
std::vector<ExactPicture> render_exact_pictures(const std::vector<Scene>& scenes, const Camera& camera,
                                                glm::ivec2 size, const std::string& output);

/// The statistics of one picture, as `--json` prints them.
nlohmann::ordered_json statistics_json(const ExactPicture& picture, const Scene& scene);

}  // namespace crest
