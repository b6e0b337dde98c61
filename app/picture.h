#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "render/files/image.h"
#include "render/renderer.h"

namespace crest {

/// A picture with what it cost.
struct MeasuredPicture {
  Image image;
  double first_frame_ms = 0;     ///< with uploads and compilation
  std::vector<double> frame_ms;  ///< the frames after it; the first one where it is the only one
  RenderCounts counts;
  std::vector<float> error_bounds;    ///< PixelCounts::error_bound, where costs are counted
  PictureNeed need;                   ///< what it was made from
  std::vector<std::string> warnings;  ///< scene_warnings()
  std::vector<std::string> notes;     ///< picture_notes()
};

/// Renders each scene `frames` times, turn by turn, so that their times can be compared.
/// `count_costs` adds a frame that counts the samples.
std::vector<MeasuredPicture> measure_pictures(Renderer& renderer, const std::vector<Scene>& scenes,
                                              const Camera& camera, glm::ivec2 size, int frames,
                                              bool count_costs);

/// The statistics of one picture, as `--json` prints them.
nlohmann::ordered_json statistics_json(const MeasuredPicture& picture, Renderer& renderer,
                                       const Scene& scene);

/// Tells them on stderr, each once: when the work is done, so that an error stays a single line.
void print_warnings(const std::vector<std::string>& warnings);
void print_notes(const std::vector<std::string>& notes);

/// Surfaces as statistics list them.
nlohmann::ordered_json peaks_json(const std::vector<Peak>& surfaces);

}  // namespace crest
