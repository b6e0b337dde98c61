#include "render/measure/choice_why.h"

#include <fmt/core.h>

#include "presets/names.h"

namespace crest {

std::string name_of(const TriedSetting& setting) {
  const Method& method = *setting.method;
  const std::string name = fmt::format("{} ({})", method.id, method.name);
  return method.has_step ? fmt::format("{} at step {}", name, setting.step) : name;
}

std::string why_chosen(const Choice& choice, const ChoiceSettings& settings) {
  const std::string target = to_string(settings.target);
  if (!settings.budget_ms) {
    if (!choice.meets_target)
      return fmt::format("no setting tried surely keeps {}; this is the closest", target);
    if (choice.setting.method->has_step)
      return fmt::format("the fastest of {} settings tried that surely keeps {}", choice.tried.size(),
                         target);
    return fmt::format("exact, and no sampled setting of {} tried surely keeps {} in less time",
                       choice.tried.size() - 1, target);
  }
  const double budget = *settings.budget_ms;
  if (!choice.fits_budget)
    return fmt::format("no setting tried draws a frame in {} ms; this is the fastest{}", budget,
                       choice.meets_target ? "" : fmt::format(", and does not surely keep {}", target));
  if (!choice.meets_target)
    return fmt::format("no setting tried surely keeps {} in {} ms a frame; this is the closest", target,
                       budget);
  return fmt::format("the least error in {} ms a frame", budget);
}

}  // namespace crest
