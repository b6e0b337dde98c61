#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "app/background_sweep.h"
#include "ui/choice_results.h"

namespace crest {

/// choose_setting() in an off-screen context of its own, in pictures of the subject's size. Nothing when it
/// was stopped. Throws Error.
std::optional<Choice> choose_offscreen(const SweepSubject& subject, const ChoiceSettings& settings,
                                       std::stop_token stop);

/// The choice of a setting in a thread of its own, beside the window. No call waits for it.
class BackgroundChoice {
 public:
  using Choose =
      std::function<std::optional<Choice>(const SweepSubject&, const ChoiceSettings&, std::stop_token)>;

  explicit BackgroundChoice(Choose choose = choose_offscreen);
  ~BackgroundChoice();  ///< waits for the picture that is being drawn

  /// Begins, unless one is under way.
  void start(const SweepSubject& subject, const ChoiceSettings& settings);
  void stop();
  /// What is in the window now: a choice for something else is stopped.
  void update(const SweepSubject& now);
  bool is_running() const { return results_.is_running; }  ///< until take() has taken its end
  bool has_news() const;                                   ///< take() has something to take

  /// Once, when it is done: the settings that were chosen. Nothing, and results() says why, where what is in
  /// the window `now` is not what they were chosen for.
  std::optional<Rendering> take(const SweepSubject& now);
  const ChoiceResults& results() const { return results_; }

 private:
  struct Outcome {
    std::optional<Choice> choice;  ///< nothing with an empty error: stopped
    std::string error;
  };
  void work(const SweepSubject& subject, const ChoiceSettings& settings, const std::stop_token& stop);

  Choose choose_;
  SweepSubject subject_;   ///< of the one under way
  ChoiceResults results_;  ///< of the window's thread
  mutable std::mutex mutex_;
  std::optional<Outcome> outcome_;  ///< of both threads
  std::jthread thread_;
};

}  // namespace crest
