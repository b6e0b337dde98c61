#include "render/measure/choose_setting.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "presets/choices.h"
#include "presets/error.h"
#include "presets/names.h"
#include "render/measure/choice_why.h"
#include "render/measure/plan.h"

namespace crest {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Of the first sparse picture, those that show something: with none wrong, they tell that share=0.001 is
/// met. Each further picture has four times as many.
constexpr double first_rays = 4500;
/// Of the picture that tells how many rays show something.
constexpr double trial_rays = 1024;
/// A sparse picture's time tells that of a full one to within about this factor.
constexpr double time_trust = 1.25;
/// So many settings are timed in the full picture, those within this factor of the fastest.
constexpr std::size_t most_timed = 3;
constexpr double close_in_time = 1.6;
/// Methods that are tried however long it takes: one of each classification.
constexpr std::size_t always_tried = 4;

/// A sparse picture, or the full one.
struct Level {
  glm::ivec2 size{0};
  std::optional<Reference> exact;
};

/// The full picture's shape with about so many pixels, or the full one where they are not much fewer.
glm::ivec2 sparse_size(glm::ivec2 full, double rays) {
  const double pixels = double(full.x) * full.y;
  if (rays > pixels / 2) return full;
  const double scale = std::sqrt(rays / pixels);
  const auto side = [&](int pixels_of_side) { return std::max(1, int(std::lround(pixels_of_side * scale))); };
  return {side(full.x), side(full.y)};
}

/// The full picture is the last one.
std::vector<Level> levels_of(glm::ivec2 full, double rays) {
  std::vector<Level> levels;
  for (glm::ivec2 size; (size = sparse_size(full, rays)) != full; rays *= 4) levels.push_back({size, {}});
  levels.push_back({full, {}});
  return levels;
}

/// Of all pixels, those that show something; at least one.
double shown_share(const Reference& exact) {
  const auto shown = std::ranges::count_if(exact.pixels, [](const glm::dvec4& p) { return p.a > 0; });
  return double(std::max<std::ptrdiff_t>(shown, 1)) / double(exact.pixels.size());
}

bool is_before(const TriedSetting& a, const TriedSetting& b, bool by_error) {
  const auto key = [&](const TriedSetting& t) {
    const double error = std::isnan(t.error.value) ? infinity : t.error.value;
    return by_error ? std::pair(error, t.frame_ms) : std::pair(t.frame_ms, error);
  };
  return key(a) < key(b);
}

/// 0 is what is exact, which others have to beat; 1 are equal steps, with one classification each; then what
/// differs from these in where samples lie, how long steps are or how steps are joined.
int promise_of(const Rendering& r, const Rendering& scene) {
  if (is_analytic(r.classification)) return 0;
  const Placement usual = holds_one_length(r.classification) ? Placement::entry : Rendering{}.placement;
  const bool is_plain = r.engine == Engine::raycaster && r.filter == scene.filter && !r.adaptive &&
                        has_equal_steps(r.sampling) && r.placement == usual && is_divided(r);
  return is_plain ? 1 : 2;
}

class Search {
 public:
  Search(const Scene& scene, glm::ivec2 size, const SceneProbe& probe, const ChoiceSettings& settings,
         std::stop_token stop)
      : scene_(scene),
        probe_(probe),
        settings_(settings),
        stop_(std::move(stop)),
        answer_(chosen_answer(scene.rendering)),
        full_(size),
        began_(probe.seconds()) {}

  Choice choose() {
    const auto methods = candidates();
    prepare_levels();
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (is_perfect()) break;
      if (i >= always_tried && seconds() > settings_.probe_seconds)
        choice_.untried.emplace_back(methods[i]->id);
      else
        search_method(*methods[i]);
    }
    settle();
    choice_.seconds = seconds();
    choice_.why = why_chosen(choice_, settings_);
    return std::move(choice_);
  }

 private:
  double seconds() const { return probe_.seconds() - began_; }
  static double pixels(const Level& level) { return double(level.size.x) * level.size.y; }
  bool has_budget() const { return settings_.budget_ms.has_value(); }
  bool counts_crossings() const {
    return settings_.target.measure->id == "missed" || settings_.target.measure->id == "invented";
  }

  /// The most promising first.
  std::vector<const Method*> candidates() const {
    std::vector<const Method*> found;
    std::string why = "no method has this scene's exact answer";
    for (const Method& method : methods()) {
      const Rendering r = measured_rendering(method, scene_.rendering.step, scene_.rendering);
      if (r.mode != scene_.rendering.mode) continue;
      const auto answers = exact_answers_of(method, scene_.rendering);
      if (std::ranges::find(answers, answer_) == answers.end()) continue;
      if (const std::string why_not = why_left_out(method, scene_); why_not.empty())
        found.push_back(&method);
      else if (found.empty())
        why = why_not;
    }
    if (found.empty()) throw Error(fmt::format("there is no setting to choose from: {}", why));
    std::ranges::stable_sort(found, {}, [&](const Method* m) {
      return promise_of(measured_rendering(*m, scene_.rendering.step, scene_.rendering), scene_.rendering);
    });
    return found;
  }

  void solve(Level& level) {
    level.exact = probe_.exact(answer_, level.size, [this](double) { return !stop_.stop_requested(); });
  }
  void prepare_levels() {
    Level trial{sparse_size(full_, trial_rays), {}};
    const double begin = seconds();
    solve(trial);
    exact_seconds_per_ray_ = (seconds() - begin) / pixels(trial);
    const double most_rays = settings_.most_seconds / std::max(exact_seconds_per_ray_, 1e-9);
    const double rays = std::min(first_rays / shown_share(*trial.exact), std::max(most_rays, trial_rays));
    levels_ = levels_of(full_, rays);
    solve(levels_.front());
  }
  bool can_refine(std::size_t level) const {
    if (level + 1 >= levels_.size()) return false;
    return levels_[level + 1].exact ||
           seconds() + exact_seconds_per_ray_ * pixels(levels_[level + 1]) <= settings_.most_seconds;
  }

  SampledError error_at(const Rendering& rendering, std::size_t level) {
    if (!levels_[level].exact) solve(levels_[level]);
    const auto picture = probe_.picture(rendering, levels_[level].size, counts_crossings());
    return sampled_error(*settings_.target.measure, *levels_[level].exact, picture.image, picture.crossings,
                         scene_.rendering.background, level + 1 == levels_.size());
  }

  const TriedSetting& look_at(const Method& method, double step) {
    if (stop_.stop_requested()) throw Cancelled{};
    const Rendering rendering = measured_rendering(method, step, scene_.rendering);
    TriedSetting tried{.method = &method, .step = step, .error = error_at(rendering, 0)};
    tried.frame_ms =
        probe_.sparse_ms(rendering, levels_[0].size) * pixels(levels_.back()) / pixels(levels_.front());
    tried.verdict = judge(tried.error, settings_.target);
    const bool is_worth_rays = method.has_step && !has_budget() && tried.frame_ms < least_ms() * time_trust;
    for (std::size_t level = 0; is_worth_rays && tried.verdict == Verdict::unclear && can_refine(level);
         ++level) {
      tried.error = error_at(rendering, level + 1);
      tried.verdict = judge(tried.error, settings_.target);
    }
    // Exact by construction: rays only have to contradict
    if (!method.has_step && tried.verdict == Verdict::unclear) tried.verdict = Verdict::met;
    choice_.tried.push_back(tried);
    return choice_.tried.back();
  }

  /// Of those that are surely within the target.
  double least_ms() const {
    double least = infinity;
    for (const TriedSetting& t : choice_.tried)
      if (t.verdict == Verdict::met) least = std::min(least, t.frame_ms);
    return least;
  }

  /// Within the budget nothing can be better.
  bool is_perfect() const {
    return has_budget() && std::ranges::any_of(choice_.tried, [&](const TriedSetting& t) {
             return t.frame_ms * time_trust <= *settings_.budget_ms && t.error.value == 0 &&
                    !t.method->has_step;
           });
  }

  /// From the nearest step that was tried; time is taken to be in proportion to samples.
  double expected_ms(const Method& method, double step) const {
    const TriedSetting* nearest = nullptr;
    const auto distance = [&](const TriedSetting& t) { return std::abs(std::log(t.step / step)); };
    for (const TriedSetting& t : choice_.tried)
      if (t.method == &method && (!nearest || distance(t) < distance(*nearest))) nearest = &t;
    return nearest ? nearest->frame_ms * nearest->step / step : 0;
  }

  /// The finest step that is worth its time; -1 where none is.
  int finest_affordable(const Method& method) const {
    const auto steps = sweep_steps();
    const double most_ms = has_budget() ? *settings_.budget_ms : least_ms() * time_trust;
    for (int i = int(steps.size()) - 1; i >= 0; --i)
      if (expected_ms(method, steps[std::size_t(i)]) <= most_ms) return i;
    return -1;
  }

  void search_method(const Method& method) {
    if (!method.has_step)
      look_at(method, 0);
    else if (has_budget())
      search_within_budget(method);
    else
      search_target(method);
  }

  /// The coarsest step that meets the target, where that is faster than what is known. Indices ascend from
  /// coarse to fine.
  void search_target(const Method& method) {
    const auto steps = sweep_steps();
    const int none = int(steps.size());
    int missed = -1, met = none;
    for (int next = first_index(); next > missed && next < met;) {
      const bool is_met = look_at(method, steps[std::size_t(next)]).verdict == Verdict::met;
      (is_met ? met : missed) = next;
      const int finest = finest_affordable(method);
      if (met < none)
        next = std::min((met + missed + 1) / 2, finest);
      else
        next = std::min(least_ms() < infinity ? finest : missed + 2, none - 1);
    }
  }

  void search_within_budget(const Method& method) {
    const auto steps = sweep_steps();
    std::set<int> seen;
    for (int next = first_index(); seen.insert(next).second; next = std::max(finest_affordable(method), 0))
      look_at(method, steps[std::size_t(next)]);
  }

  static int first_index() { return int(std::ranges::find(sweep_steps(), 1.0) - sweep_steps().begin()); }

  void settle();
  std::vector<std::size_t> finalists() const;
  void time(const std::vector<std::size_t>& indices);  ///< throws Cancelled

  const Scene& scene_;
  const SceneProbe& probe_;
  const ChoiceSettings& settings_;
  std::stop_token stop_;
  ExactAnswer answer_;
  glm::ivec2 full_;
  std::vector<Level> levels_;  ///< the full picture last
  double began_ = 0, exact_seconds_per_ray_ = 0;
  Choice choice_;
};

/// What is worth an exact time, the most promising first: of each method one setting.
std::vector<std::size_t> Search::finalists() const {
  const auto& tried = choice_.tried;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (has_budget() ? tried[i].frame_ms <= *settings_.budget_ms * time_trust
                     : tried[i].verdict == Verdict::met)
      indices.push_back(i);
  }
  const auto before = [&](bool by_error) {
    return
        [&tried, by_error](std::size_t a, std::size_t b) { return is_before(tried[a], tried[b], by_error); };
  };
  std::ranges::sort(indices, before(has_budget()));
  std::set<const Method*> seen;
  std::erase_if(indices, [&](std::size_t i) { return !seen.insert(tried[i].method).second; });
  if (!has_budget() && !indices.empty()) {
    const double slowest = close_in_time * tried[indices.front()].frame_ms;
    std::erase_if(indices, [&](std::size_t i) { return tried[i].frame_ms > slowest; });
  }
  if (indices.empty()) {  // nothing fits: the fastest within a budget, else the closest
    for (std::size_t i = 0; i < tried.size(); ++i) indices.push_back(i);
    std::ranges::sort(indices, before(!has_budget()));
    indices.resize(1);
  }
  indices.resize(std::min(indices.size(), most_timed));
  return indices;
}

/// In the scene's own settings: shading takes its time, too.
void Search::time(const std::vector<std::size_t>& indices) {
  if (stop_.stop_requested()) throw Cancelled{};
  std::vector<Rendering> renderings;
  for (const std::size_t i : indices)
    renderings.push_back(with_method(scene_.rendering, *choice_.tried[i].method, choice_.tried[i].step));
  const auto times = probe_.frame_ms(renderings);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    choice_.tried[indices[k]].frame_ms = times[k];
    choice_.tried[indices[k]].is_timed = true;
  }
}

void Search::settle() {
  const auto timed = finalists();
  time(timed);
  std::vector<TriedSetting> fitting;
  for (const std::size_t i : timed)
    if (!has_budget() || choice_.tried[i].frame_ms <= *settings_.budget_ms)
      fitting.push_back(choice_.tried[i]);
  choice_.fits_budget = !fitting.empty();
  if (fitting.empty())
    for (const std::size_t i : timed) fitting.push_back(choice_.tried[i]);
  const bool by_error = has_budget() && choice_.fits_budget;
  choice_.setting = *std::ranges::min_element(
      fitting, [&](const auto& a, const auto& b) { return is_before(a, b, by_error); });
  choice_.rendering = with_method(scene_.rendering, *choice_.setting.method, choice_.setting.step);
  choice_.meets_target = choice_.setting.verdict == Verdict::met;
}

}  // namespace

std::optional<Choice> choose_setting(const Scene& scene, glm::ivec2 size, const SceneProbe& probe,
                                     const ChoiceSettings& settings, std::stop_token stop) {
  if (const std::string why = why_without_answer(scene.rendering); !why.empty()) throw Error(why);
  if (settings.budget_ms && settings.target.measure->id == "flip")
    throw Error(
        "flip is told of whole pictures alone: within a budget, the error is share, rmse, p999, max, "
        "missed or invented");
  try {
    return Search(scene, size, probe, settings, stop).choose();
  } catch (const Cancelled&) {
    return std::nullopt;
  }
}

ExactAnswer chosen_answer(const Rendering& rendering) { return exact_answers_of(rendering).back(); }

}  // namespace crest
