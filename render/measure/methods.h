#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "presets/preset.h"
#include "render/reference/answer.h"
#include "render/scene/scene.h"

namespace crest {

/// A way in which Crest renders, as the report, the studies and the studio offer it.
struct Method {
  std::string_view id;        ///< "dvr-eye": in files and on the command line
  std::string_view name;      ///< for people
  std::string_view settings;  ///< fields of "rendering", as in "mode=DVR_ONLY placement=eye"
  std::string_view limits;    ///< what it cannot do, in a sentence or two for people
  bool has_step = true;       ///< whether rendering.step refines it
  /// Where this is not 0, s_k refines it in the step's stead, and is the step times this: 8 makes the
  /// defaults of both, 0.5 and 4, meet.
  double s_k_per_step = 0;
};

/// All methods. One that is added to this table is in the report, the studies, the studio's diagram and
/// `crest list methods`.
std::span<const Method> methods();

/// Null where there is none of this id.
const Method* find_method(std::string_view id);

/// The settings with which a method is measured in a scene: the method's own; of the scene's, the filters
/// that it does not set, clip box, background, max_peaks, the tables' bins and how vdls works; everything
/// else as it is by default. So shading, which has no exact answer, and early termination, which adds an
/// error of its own, are off. Filters that a method cannot take are `linear`.
Rendering measured_rendering(const Method& method, double step, const Rendering& scene);

/// The setting with another one's filters for DVR and surfaces.
Rendering with_filters_of(Rendering rendering, const Rendering& other);

/// The scene's settings changed to a method, which leaves its shading and its early termination as they are.
Rendering with_method(const Rendering& scene, const Method& method, double step);

/// The exact answers that a method is measured against in a scene: each field has its own.
std::vector<ExactAnswer> exact_answers_of(const Method& method, const Rendering& scene = {});

/// Why it would show nothing, or the same as a simpler one, in a scene; empty where it makes sense.
std::string why_left_out(const Method& method, const Scene& scene);

}  // namespace crest
