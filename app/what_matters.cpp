#include "app/what_matters.h"

#include <algorithm>
#include <cmath>

#include "render/scene/exact.h"

namespace crest {
namespace {

constexpr double rays_aside = 80;

/// What of the settings has a part in the exact picture.
Rendering what_shows(const Rendering& rendering) {
  return why_not_exact(rendering).empty() ? exact_rendering(rendering) : rendering;
}

/// A view that grows by some pixels keeps its shape, about: the camera tells the shape.
bool is_same(const VisibilitySubject& a, const VisibilitySubject& b) {
  return a.scene.volume == b.scene.volume && a.scene.tf == b.scene.tf && a.camera == b.camera &&
         a.size == b.size && what_shows(a.scene.rendering) == what_shows(b.scene.rendering);
}

bool is_same(const std::optional<VisibilitySubject>& a, const std::optional<VisibilitySubject>& b) {
  return a && b ? is_same(*a, *b) : !a && !b;
}

}  // namespace

std::optional<VolumeValues> measure_values(const Volume& volume, const std::stop_token& stop) {
  std::optional<ByValue> by_value = measure_by_value(volume, by_value_bins, stop);
  if (!by_value) return std::nullopt;
  std::vector<SuggestedPeak> suggested = suggest_peaks(*by_value);
  return VolumeValues{std::move(*by_value), std::move(suggested), distribution_of(volume)};
}

glm::ivec2 visibility_size(glm::ivec2 view_pixels) {
  const double scale = rays_aside / std::max({view_pixels.x, view_pixels.y, 1});
  const auto side = [&](int pixels) { return std::max(1, int(std::lround(pixels * scale))); };
  return {side(view_pixels.x), side(view_pixels.y)};
}

WhatMatters::WhatMatters(VolumeTask::Work measure_volume, VisibilityTask::Work measure_picture)
    : volume_task_(std::move(measure_volume)), picture_task_(std::move(measure_picture)) {}

void WhatMatters::set_volume(std::shared_ptr<const Volume> volume) {
  values_.reset();
  why_no_values_.clear();
  visibility_.reset();
  shown_.reset();
  volume ? volume_task_.start(std::move(volume)) : volume_task_.stop();
}

void WhatMatters::update(std::optional<VisibilitySubject> picture, bool at_rest, Clock::time_point now) {
  const std::string why_not = picture ? why_without_answer(picture->scene.rendering) : "";
  if (!why_not.empty()) picture.reset();
  if (!is_same(wanted_, picture)) changed_at_ = now;
  if (!is_same(wanted_, picture) || !why_not.empty()) why_no_visibility_ = why_not;
  wanted_ = std::move(picture);
  if (begun_ && !is_same(begun_, wanted_)) {
    picture_task_.stop();
    begun_.reset();
  }
  if (!is_pending() || !at_rest || now < changed_at_ + pause) return;
  begun_ = wanted_;
  picture_task_.start(*wanted_);
}

void WhatMatters::take() {
  if (auto outcome = volume_task_.take()) {
    values_ = std::move(outcome->result);
    why_no_values_ = outcome->error;
  }
  if (auto outcome = picture_task_.take()) {
    why_no_visibility_ = outcome->error;
    if (!outcome->result) return;
    visibility_ = std::move(outcome->result);
    shown_ = begun_;
  }
}

/// Whether the wanted picture is neither measured nor being measured.
bool WhatMatters::is_pending() const {
  return wanted_ && !is_same(begun_, wanted_) && !is_same(shown_, wanted_);
}

bool WhatMatters::is_active() const {
  return volume_task_.is_running() || picture_task_.is_running() || is_pending();
}

bool WhatMatters::has_news(Clock::time_point now) const {
  return volume_task_.has_news() || picture_task_.has_news() || (is_pending() && now >= changed_at_ + pause);
}

const Visibility* WhatMatters::visibility() const { return visibility_ ? &*visibility_ : nullptr; }
bool WhatMatters::is_visibility_old() const { return !is_same(shown_, wanted_); }

}  // namespace crest
