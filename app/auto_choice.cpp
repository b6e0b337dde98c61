#include "app/auto_choice.h"

#include <fmt/core.h>

#include <cmath>

#include "presets/error.h"
#include "presets/json.h"
#include "presets/number_text.h"
#include "presets/preset_file.h"
#include "presets/preset_json.h"

namespace crest {
namespace {

/// "40", "40ms", "2.5".
double budget_option(const std::string& text) {
  const TypedNumber typed = read_number(text.ends_with("ms") ? text.substr(0, text.size() - 2) : text);
  if (!typed.number || *typed.number <= 0 || *typed.number >= 1e9)
    throw UsageError("--budget", fmt::format("'{}' is not a frame's time in milliseconds, as in 40", text));
  return *typed.number;
}

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const TriedSetting& setting) {
  constexpr const char* verdicts[] = {"met", "unclear", "missed"};
  return {{"method", setting.method->id},
          {"step", setting.method->has_step ? Json(setting.step) : Json()},
          {"error", finite_or_null(setting.error.value)},
          {"error_at_least", setting.error.low},
          {"error_at_most", finite_or_null(setting.error.high)},
          {"rays", setting.error.rays},
          {"target", verdicts[int(setting.verdict)]},
          {"frame_ms", setting.frame_ms},
          {"timed_in_full", setting.is_timed}};
}

}  // namespace

TargetError target_option(const std::string& text) {
  try {
    return parse_target(text);
  } catch (const Error& error) {
    throw UsageError("--target-error", error.what());
  }
}

void AutoOptions::add_to(Options options) {
  options.add_flag("--auto", is_on,
                   "Choose engine, classification, placement and step for this scene and view: the fastest "
                   "setting of the same exact answer that keeps --target-error");
  options
      .add("--target-error", target,
           "With --auto: the error to keep, " + to_string(default_target()) +
               " by default: share, rmse, max, p999, flip, missed or invented")
      .type_name("LIMIT");
  options.add("--budget", budget, "With --auto: a frame's time in ms, in which the error is to be the least")
      .type_name("MS");
}

void AutoOptions::check(const SceneOptions& scene) const {
  if (!is_on) {
    if (!target.empty()) throw UsageError("--target-error", "goes with --auto, which is not given");
    if (!budget.empty()) throw UsageError("--budget", "goes with --auto, which is not given");
    return;
  }
  if (!scene.step.empty()) throw UsageError("--auto", "it chooses the step: without --step");
  if (!scene.engine.empty()) throw UsageError("--auto", "it chooses the engine: without --engine");
  settings();
}

ChoiceSettings AutoOptions::settings() const {
  ChoiceSettings settings;
  if (!target.empty()) settings.target = target_option(target);
  if (!budget.empty()) settings.budget_ms = budget_option(budget);
  return settings;
}

std::string choice_line(const Choice& choice, const TargetError& target, double measured_ms) {
  const SampledError& error = choice.setting.error;
  const std::string bound = std::isfinite(error.high) && error.high > error.value
                                ? fmt::format(" (at most {:.2g})", error.high)
                                : "";
  return fmt::format("auto: {}: predicted {} {:.3g}{}, {:.3g} ms a frame; drawn in {:.3g} ms; probe {:.2g} s",
                     name_of(choice.setting), target.measure->id, error.value, bound, choice.setting.frame_ms,
                     measured_ms, choice.seconds);
}

nlohmann::ordered_json choice_json(const Choice& choice, const ChoiceSettings& settings) {
  Json json = to_json(choice.setting);
  json["name"] = choice.setting.method->name;
  json["target_error"] = to_string(settings.target);
  json["budget_ms"] = settings.budget_ms ? Json(*settings.budget_ms) : Json();
  json["meets_target"] = choice.meets_target;
  json["fits_budget"] = choice.fits_budget;
  json["why"] = choice.why;
  json["probe_seconds"] = choice.seconds;
  json["settings"] = assignments_between({}, choice.rendering);
  json["tried"] = Json::array();
  for (const TriedSetting& setting : choice.tried) json["tried"].push_back(to_json(setting));
  json["untried"] = choice.untried;
  return json;
}

}  // namespace crest
