#include "app/background_choice.h"

#include <utility>

#include "app/cache_folder.h"
#include "app/offscreen_context.h"
#include "app/thread_priority.h"
#include "render/measure/probe_scene.h"

namespace crest {
namespace {

/// What is to be seen is the same but for the size: a window that grows by some pixels asks for nothing new.
bool is_same_scene(const SweepSubject& a, const SweepSubject& b) {
  return a.scene.volume == b.scene.volume && a.scene.tf == b.scene.tf &&
         a.scene.rendering == b.scene.rendering && a.camera == b.camera;
}

}  // namespace

std::optional<Choice> choose_offscreen(const SweepSubject& subject, const ChoiceSettings& settings,
                                       std::stop_token stop) {
  const OffscreenContext context;
  const auto renderer = std::make_shared<Renderer>(std::filesystem::path(), program_folder());
  renderer->hold(subject.scene.volume);
  return choose_setting(subject.scene, subject.size,
                        probe_scene(renderer, subject.scene, subject.camera, subject.size), settings,
                        std::move(stop));
}

BackgroundChoice::BackgroundChoice(Choose choose) : choose_(std::move(choose)) {}
BackgroundChoice::~BackgroundChoice() { stop(); }

void BackgroundChoice::start(const SweepSubject& subject, const ChoiceSettings& settings) {
  if (is_running()) return;
  subject_ = subject;
  results_ = {.is_running = true, .error = {}, .chosen = {}, .target = settings.target};
  thread_ = std::jthread([=, this](const std::stop_token& stop) { work(subject, settings, stop); });
}

void BackgroundChoice::stop() { thread_.request_stop(); }

void BackgroundChoice::update(const SweepSubject& now) {
  if (is_running() && !is_same_scene(subject_, now)) stop();
}

bool BackgroundChoice::has_news() const {
  const std::scoped_lock lock(mutex_);
  return outcome_.has_value();
}

void BackgroundChoice::work(const SweepSubject& subject, const ChoiceSettings& settings,
                            const std::stop_token& stop) {
  lower_thread_priority();
  Outcome outcome;
  try {
    outcome.choice = choose_(subject, settings, stop);
  } catch (const std::exception& error) {
    outcome.error = error.what();
  }
  const std::scoped_lock lock(mutex_);
  outcome_ = std::move(outcome);
}

std::optional<Rendering> BackgroundChoice::take(const SweepSubject& now) {
  std::optional<Outcome> outcome;
  {
    const std::scoped_lock lock(mutex_);
    outcome = std::exchange(outcome_, std::nullopt);
  }
  if (!outcome) return std::nullopt;
  results_.is_running = false;
  results_.error = outcome->error;
  if (results_.error.empty() && !is_same_scene(subject_, now))
    results_.error = "the scene or the view changed meanwhile; choose again";
  const bool is_stopped = thread_.get_stop_token().stop_requested();
  if (!outcome->choice || is_stopped || !results_.error.empty()) return std::nullopt;
  results_.chosen = std::move(outcome->choice);
  return results_.chosen->rendering;
}

}  // namespace crest
