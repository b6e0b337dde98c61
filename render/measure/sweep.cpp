#include "render/measure/sweep.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "presets/choices.h"
#include "render/measure/timing.h"

namespace crest {
namespace {

/// Draws of a point besides its timed frames: the picture, and its counts.
constexpr double other_draws = 2;
/// An exact answer may take this share of the time that is left.
constexpr double reference_share = 0.5;
/// A frame that takes longer is timed three times only,
constexpr double long_frame_ms = 1000;
/// and short ones as often as it takes to come to this time, up to so many times `frames`.
constexpr double least_timed_ms = 100;
constexpr int most_repeats = 5;

bool is_of_own_field(const ExactAnswer& exact, const Rendering& own) {
  return exact.filters == filters_of(exact.answer, own);
}

/// Answers in the order in which they are rendered: the scene's own first, since it is what a person looks
/// at, then `integral`, with which all are compared; and last those of other fields.
std::vector<ExactAnswer> order_of_answers(const std::vector<const Method*>& methods, const Rendering& own) {
  std::vector<ExactAnswer> order;
  const auto add = [&](const std::vector<ExactAnswer>& answers) {
    for (const ExactAnswer& answer : answers)
      if (std::ranges::find(order, answer) == order.end()) order.push_back(answer);
  };
  add(exact_answers_of(own));
  add({{Answer::integral, filters_of(Answer::integral, own)}});
  for (const Method* method : methods) add(exact_answers_of(*method, own));
  std::ranges::stable_partition(order, [&](const ExactAnswer& a) { return is_of_own_field(a, own); });
  return order;
}

/// The methods, those of the scene's own mode and form first.
void put_own_first(std::vector<const Method*>& methods, const Rendering& own) {
  std::ranges::stable_sort(methods, {}, [&](const Method* method) {
    const Rendering r = measured_rendering(*method, own.step, own);
    return !(r.mode == own.mode && (!shows_surfaces(r.mode) || r.peak_form == own.peak_form));
  });
}

std::string describe(const PlannedPoint& point) {
  return point.method->has_step ? fmt::format("{} at step {}", point.method->id, point.step)
                                : std::string(point.method->id);
}

}  // namespace

Sweep::Sweep(Scene scene, Measurer measurer, SweepSettings settings, std::span<const Method> methods)
    : scene_(std::move(scene)), measurer_(std::move(measurer)), settings_(settings) {
  for (const Method& method : methods) {
    const std::string why = why_left_out(method, scene_);
    if (why.empty())
      methods_.push_back(&method);
    else
      left_out_.push_back({std::string(method.id), why});
  }
  put_own_first(methods_, scene_.rendering);
  if (!methods_.empty()) awaited_ = order_of_answers(methods_, scene_.rendering);
  began_ = measurer_.seconds();
}

double Sweep::seconds() const { return measurer_.seconds() - began_; }

double Sweep::seconds_left() const {
  return settings_.budget_seconds ? *settings_.budget_seconds - seconds()
                                  : std::numeric_limits<double>::infinity();
}

Rendering Sweep::rendering_of(const PlannedPoint& point) const {
  return measured_rendering(*point.method, point.step, scene_.rendering);
}

std::vector<ExactAnswer> Sweep::answers_of(const Method& method) const {
  return exact_answers_of(method, scene_.rendering);
}

/// All its answers are rendered or given up, and there is one.
bool Sweep::is_ready(const Method& method) const {
  const auto answers = answers_of(method);
  const auto is_there = [&](const ExactAnswer& a) { return references_.contains(a); };
  const auto is_awaited = [&](const ExactAnswer& a) {
    return std::ranges::find(awaited_, a) != awaited_.end();
  };
  return std::ranges::any_of(answers, is_there) && std::ranges::none_of(answers, is_awaited);
}

/// The methods that can be measured are covered, and others wait for their answer.
bool Sweep::needs_reference(const std::vector<PlannedPoint>& plan) const {
  if (awaited_.empty()) return false;
  const Why first_below = is_of_own_field(awaited_.front(), scene_.rendering) ? Why::target : Why::rest;
  return plan.empty() || plan.front().why >= first_below;
}

std::optional<Sweep::Point> Sweep::next(std::stop_token stop, const SweepStatus& status) {
  while (ready_.empty() && !ended_ && !stop.stop_requested()) {
    std::vector<const Method*> methods;
    for (const Method* method : methods_)
      if (is_ready(*method)) methods.push_back(method);
    const auto plan = plan_points(methods, measured_, settings_.target);
    if (needs_reference(plan)) {
      render_next_reference(stop, status);
      continue;
    }
    const auto group = next_group(plan);
    if (group.empty()) {
      tell_skipped(plan);
      ended_ = true;
    } else {
      measure(group, stop, status);
    }
  }
  if (ready_.empty()) return std::nullopt;
  Point point = std::move(ready_.back());
  ready_.pop_back();
  return point;
}

void Sweep::render_next_reference(std::stop_token stop, const SweepStatus& status) {
  const ExactAnswer answer = awaited_.front();
  if (!is_of_own_field(answer, scene_.rendering) && references_.empty()) {
    for (const ExactAnswer& a : awaited_)
      left_out_.push_back(
          {fmt::format("exact answer '{}'", name_of(a)), "those of the scene's own field took too long"});
    awaited_.clear();
    return;
  }
  const double begin = seconds(), allowed = reference_share * seconds_left();
  double expected = 0;
  const auto progress = [&](double done) {
    if (status) status(fmt::format("exact answer '{}'", name_of(answer)), done);
    const double taken = seconds() - begin;
    // Its speed is known well enough once some of it is done
    expected = done > 0 && taken > 0.05 * allowed ? taken / done : taken;
    return !stop.stop_requested() && expected <= allowed;
  };
  try {
    if (allowed <= 0) throw Cancelled{};
    references_.emplace(answer, measurer_.reference(answer, progress));
  } catch (const Cancelled&) {
    if (stop.stop_requested()) return;
    left_out_.push_back({fmt::format("exact answer '{}'", name_of(answer)),
                         fmt::format("it would take {:.0f} s, more than half of the {:.0f} s that were left",
                                     expected, allowed / reference_share)});
  }
  reference_seconds_ += seconds() - begin;
  awaited_.erase(awaited_.begin());
}

/// The first points of the plan that fit into the budget: of one kind and, for coverage, of one step, as many
/// as a group's time allows. A point whose time cannot be foretold goes alone.
std::vector<PlannedPoint> Sweep::next_group(const std::vector<PlannedPoint>& plan) const {
  std::vector<PlannedPoint> group;
  double seconds = 0;
  for (const PlannedPoint& point : plan) {
    if (!point.expected_ms) {
      if (group.empty() && seconds_left() > 0) group.push_back(point);
      return group;
    }
    if (!group.empty() &&
        (point.why != group.front().why || (point.why == Why::coverage && point.step != group.front().step)))
      break;
    const double frames = *point.expected_ms > long_frame_ms ? 3 : settings_.frames;
    const double cost = 1e-3 * *point.expected_ms * (frames + other_draws);
    if (seconds + cost > seconds_left() || *point.expected_ms > settings_.longest_frame_ms) continue;
    if (!group.empty() && seconds + cost > settings_.group_seconds) break;
    group.push_back(point);
    seconds += cost;
  }
  return group;
}

void Sweep::measure(const std::vector<PlannedPoint>& group, std::stop_token stop, const SweepStatus& status) {
  const std::size_t started = starts_.size();
  for (const PlannedPoint& point : group)
    if (std::ranges::find(starts_, point.method->id, &MethodStart::method) == starts_.end())
      start_method(point);
  std::vector<Point> points;
  for (const PlannedPoint& point : group) {
    if (stop.stop_requested()) return;
    if (status) status(describe(point), double(points.size()) / double(group.size()));
    points.push_back(look_at(point));
  }
  if (!anchor_) anchor_ = rendering_of(group.front());
  if (starts_.size() > started) measurer_.frame(*anchor_);  // starting a method made its next frame slow
  time_frames(group, points, stop);
  if (points.front().measurement.frame_ms_all.empty()) return;
  ++groups_;
  for (const Point& point : points) measured_.push_back(point.measurement);
  std::ranges::reverse(points);
  ready_ = std::move(points);
}

void Sweep::start_method(const PlannedPoint& point) {
  const Measurer::Start start = measurer_.start(rendering_of(point));
  starts_.push_back({std::string(point.method->id), point.step, start.first_frame_ms, start.edit_ms});
}

Sweep::Point Sweep::look_at(const PlannedPoint& planned) {
  const Rendering rendering = rendering_of(planned);
  Measurer::Picture picture = measurer_.picture(rendering);
  Point point;
  Measurement& m = point.measurement;
  m.method = planned.method->id;
  m.step = planned.step;
  m.why = planned.why;
  m.group = groups_;
  m.samples_per_ray = picture.samples_per_ray;
  m.dvr_samples_per_ray = picture.dvr_samples_per_ray;
  m.crossings_per_ray = picture.crossings_per_ray;
  m.crossings_left_out_per_ray = picture.crossings_left_out_per_ray;
  if (!shows_surfaces(rendering.mode)) picture.crossings.clear();
  for (const ExactAnswer& answer : answers_of(*planned.method))
    if (const auto exact = references_.find(answer); exact != references_.end())
      m.errors.push_back(
          {answer, image_error(exact->second, picture.image, picture.crossings, rendering.background)});
  point.image = std::move(picture.image);
  return point;
}

/// Turn by turn, the anchor among them; at least once, then for as long as the budget lasts.
void Sweep::time_frames(const std::vector<PlannedPoint>& group, std::vector<Point>& points,
                        std::stop_token stop) {
  std::vector<double> anchor_ms;
  double slowest = 0;
  const auto is_enough = [&](int rounds) {
    if (rounds == 0) return false;
    const bool is_long = slowest * rounds >= least_timed_ms || rounds >= most_repeats * settings_.frames;
    return (rounds >= (slowest > long_frame_ms ? 3 : settings_.frames) && is_long) || seconds_left() <= 0;
  };
  for (int round = 0; !is_enough(round); ++round) {
    anchor_ms.push_back(measurer_.frame(*anchor_).wall_ms);
    std::vector<Measurer::FrameTime> times;
    for (const PlannedPoint& point : group) {
      if (stop.stop_requested()) break;
      times.push_back(measurer_.frame(rendering_of(point)));
      slowest = std::max(slowest, times.back().wall_ms);
    }
    if (times.size() < group.size()) break;
    for (std::size_t i = 0; i < group.size(); ++i) {
      points[i].measurement.frame_ms_all.push_back(times[i].wall_ms);
      points[i].measurement.device_ms_all.push_back(times[i].device_ms);
    }
  }
  if (first_anchor_ms_ == 0) first_anchor_ms_ = median(anchor_ms);
  for (Point& point : points) {
    Measurement& m = point.measurement;
    m.anchor_ms = median(anchor_ms);
    const double drift = m.anchor_ms / first_anchor_ms_;
    m.frame_ms = median(m.frame_ms_all) / drift;
    m.device_ms = median(m.device_ms_all) / drift;
  }
}

void Sweep::tell_skipped(const std::vector<PlannedPoint>& plan) {
  for (const Method* method : methods_)
    if (!is_ready(*method)) left_out_.push_back({std::string(method->id), "it has no exact answer here"});
  for (const PlannedPoint& point : plan) {
    const std::string frame =
        point.expected_ms ? fmt::format("; a frame would take about {:.3g} ms", *point.expected_ms) : "";
    left_out_.push_back({describe(point), "no time was left for it" + frame});
  }
}

}  // namespace crest
