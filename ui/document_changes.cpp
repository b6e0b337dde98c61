#include "ui/document_changes.h"

#include <fmt/core.h>

#include "presets/preset_changes.h"
#include "render/measure/methods.h"
#include "ui/accuracy_shown.h"

namespace crest {
namespace {

/// Of a preset that came in whole.
std::string describe_opening(const Document& after) {
  if (!after.preset_path.empty() || !after.library_name.empty())
    return fmt::format("Open {}", preset_label(after));
  if (!after.preset.name.empty()) return fmt::format("Import {}", after.preset.name);
  return "New preset";
}

/// The method's step of a rendering.
double step_of(const Method& method, const Rendering& rendering) {
  return method.s_k_per_step > 0 ? rendering.s_k / method.s_k_per_step : rendering.step;
}

/// Where several settings changed and are a method's now: as one takes a measured or a chosen one. Filters
/// that a method leaves open may be those before, or have been taken with it.
std::string describe_method(const Rendering& before, const Rendering& after) {
  for (const Rendering& scene : {before, after})
    for (const Method& method : methods()) {
      const double step = step_of(method, after);
      if (with_method(scene, method, step) != after) continue;
      const std::string at = method.has_step ? " at step " + step_text(step) : "";
      return fmt::format("Take setting {}{}", method.name, at);
    }
  return "";
}

std::string joined(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "Change the file's other keys";
  if (sentences.size() == 1) return sentences.front();
  const std::size_t more = sentences.size() - 1;
  return fmt::format("{} and {} more change{}", sentences.front(), more, more == 1 ? "" : "s");
}

}  // namespace

std::string describe_step(const Document& before, const Document& after) {
  if (before.volume_source != after.volume_source)
    return after.volume_source.empty() ? "Close the volume"
                                       : fmt::format("Open {}", file_name(after.volume_source));
  if (!is_same_preset_file(before, after)) return describe_opening(after);
  const std::vector<std::string> sentences = preset_changes(before.preset, after.preset);
  const Rendering& now = after.preset.rendering;
  Preset with_rendering = before.preset;
  with_rendering.rendering = now;
  if (sentences.size() > 1 && with_rendering == after.preset)
    if (std::string taken = describe_method(before.preset.rendering, now); !taken.empty()) return taken;
  return joined(sentences);
}

std::vector<std::string> changes_since(const Preset& saved, const Preset& now) {
  Preset then = saved;
  then.camera = now.camera;
  return preset_changes(then, now);
}

}  // namespace crest
