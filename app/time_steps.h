#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/background_task.h"
#include "app/volume_loader.h"

namespace crest {

/// The time steps of the volume that is open: goes from one to another, beside the window. What is shown
/// stays until the step that was asked for last is there. When nobody waits, the next step in the direction
/// of travel is read and held; then the others are read once, one at a time, for their range alone. Each step
/// comes in the range of all that are known, so that what depends on the range does not change from step to
/// step. No call waits.
class TimeSteps {
 public:
  using Clock = std::chrono::steady_clock;
  using SharedVolume = std::shared_ptr<const Volume>;
  /// Playing goes on no earlier than this after a step came up.
  static constexpr std::chrono::milliseconds pause{100};

  TimeSteps();
  explicit TimeSteps(VolumeLoader::Read read);  ///< as VolumeLoader's

  /// What is shown from now on, as it was read from the source; null: nothing.
  void open(const std::string& source, SharedVolume volume);

  int count() const { return int(steps_.size()); }  ///< 0 or 1 where there is nothing to go through
  int shown() const { return shown_ ? shown_->frame : 0; }
  int wanted() const { return wanted_; }  ///< shown() where nothing is waited for
  int known_ranges() const;               ///< of so many steps
  bool has_whole_range() const { return known_ranges() == count(); }
  bool is_playing() const { return is_playing_; }

  void go_to(int step);     ///< the nearest that there is
  void play(bool forward);  ///< step after step, and after the last one the first; or no longer

  struct News {
    SharedVolume volume;  ///< to be shown: the wanted step, or the shown one in a wider range; or null
    std::string error;    ///< why the wanted one cannot be: the shown one stays
  };
  /// Goes on with the work. To be called before each frame.
  std::optional<News> update(Clock::time_point now);

  bool is_waited_for() const { return is_playing_ || wanted_ != shown(); }
  bool is_active() const {
    return loader_.is_loading() || widening_.is_running() || widening_.has_news() || is_waited_for();
  }
  bool has_news(Clock::time_point now) const;               ///< update() is worth a call
  bool has_thread() const { return loader_.has_thread(); }  ///< VolumeLoader::has_thread

 private:
  struct Step {
    std::optional<ValueRange> range;  ///< nothing where it has no finite value, or is not known
    bool is_looked_at = false;        ///< whether it could be read or not
    bool is_known = false;
  };
  struct Widening {
    SharedVolume volume;
    ValueRange range;
  };

  int next() const;  ///< in the direction of travel; -1 where there is none
  bool is_wide(const SharedVolume& volume) const;
  void learn(const SharedVolume& volume);
  void fit_count(int frames);
  std::optional<News> take_read();
  std::optional<News> take_widened();
  std::optional<News> show_wanted(Clock::time_point now);
  void read(int step);
  void read_what_is_needed();

  std::string source_;
  std::vector<Step> steps_;
  SharedVolume shown_, ahead_;  ///< ahead_: the next one, or the wanted one until it may be shown
  int wanted_ = 0, direction_ = 1, reading_ = -1;
  bool is_playing_ = false, gave_up_widening_ = false;
  Clock::time_point shown_at_{};
  std::optional<ValueRange> range_;  ///< of all known steps
  VolumeLoader loader_;
  BackgroundTask<Widening, SharedVolume> widening_;
};

}  // namespace crest
