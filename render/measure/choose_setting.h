#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "render/measure/methods.h"
#include "render/measure/sampled_error.h"

namespace crest {

/// What a choice asks of a renderer: probe_scene() has the real one. Pictures of any size have the same
/// camera.
struct SceneProbe {
  struct Picture {
    Image image;
    std::vector<std::uint32_t> crossings;  ///< composited, by pixel; empty where not asked for
  };
  std::function<Reference(const ExactAnswer&, glm::ivec2 size, const Progress&)> exact;  ///< throws Cancelled
  std::function<Picture(const Rendering&, glm::ivec2 size, bool with_crossings)> picture;
  /// Of a picture that was drawn before, so that all is made that it needs.
  std::function<double(const Rendering&, glm::ivec2 size)> sparse_ms;
  /// Of the full picture, foretold from parts of it that are drawn turn by turn.
  std::function<std::vector<double>(std::span<const Rendering>)> frame_ms;
  std::function<double()> seconds;  ///< a clock that only goes forward
};

struct ChoiceSettings {
  TargetError target = default_target();
  /// Of a frame. With it the least error within that time is looked for, else the least time within the
  /// target.
  std::optional<double> budget_ms = {};
  /// After so long no further method is tried but the first ones.
  double probe_seconds = 1;
  /// More exact rays are solved where that ends before.
  double most_seconds = 6;
};

/// A setting that was looked at.
struct TriedSetting {
  const Method* method = nullptr;
  double step = 0;  ///< in units of the smallest spacing; 0 for a method without one
  SampledError error;
  Verdict verdict = Verdict::unclear;
  double frame_ms = 0;    ///< of the full picture
  bool is_timed = false;  ///< in parts of the full picture; else from the sparse one
};

struct Choice {
  TriedSetting setting;
  Rendering rendering;  ///< with_method() of it
  bool meets_target = false, fits_budget = true;
  std::string why;                   ///< a sentence for people
  std::vector<TriedSetting> tried;   ///< in the order in which they were
  std::vector<std::string> untried;  ///< ids of methods for which no time was left
  double seconds = 0;                ///< that it took
};

/// The setting for a scene and view, of those that have the scene's own exact answer, so that mode and field
/// stay: methods() at sweep_steps(). Each method is tried where it would beat the best one so far: at a
/// spacing, then at the finest step that is still faster, then by bisection. A sampled one is taken only
/// where the error in a sparse picture says surely enough that the target is met; rays are added where it is
/// unclear. The cell-by-cell march is exact by construction, and is taken where nothing faster is sure.
///
/// Nothing when `stop` was asked for. Throws Error where there is nothing to choose from.
std::optional<Choice> choose_setting(const Scene& scene, glm::ivec2 size, const SceneProbe& probe,
                                     const ChoiceSettings& settings = {}, std::stop_token stop = {});

/// The answer that a scene's settings are judged against: of PEAK_XOR_DVR base+crossings in either form.
ExactAnswer chosen_answer(const Rendering& rendering);

/// "xor-analytic (PEAK_XOR_DVR, cell by cell)", "dvr-pre (...) at step 0.5".
std::string name_of(const TriedSetting& setting);

}  // namespace crest
