#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/thumbnail.h"
#include "presets/preset.h"
#include "render/volume/volume.h"

namespace crest {

/// A picture that is wanted: of a preset on a volume, as a whole.
struct ThumbnailJob {
  std::string key;
  std::shared_ptr<const Volume> volume;  ///< without one, `source` is read
  std::string source;
  std::function<Preset()> read_preset;  ///< called in the thread
};

/// Makes thumbnails beside the window, and keeps them in files, in a thread of its own; a context is there
/// while there is something to draw. No call waits for it.
class ThumbnailMaker {
 public:
  using Draw = std::function<Thumbnail(const ThumbnailJob&)>;
  using Keep = std::function<void(const std::string& key, const Thumbnail&)>;
  /// In an off-screen context of its own, with volumes thinned to some 100 points an axis. Throws Error.
  static Draw draw_offscreen();

  /// All are called in the thread, and what `make_draw` gives dies there. `keep` writes what was drawn, or
  /// was given to be kept.
  explicit ThumbnailMaker(Keep keep = nullptr, std::function<Draw()> make_draw = draw_offscreen);
  ~ThumbnailMaker();  ///< waits for the picture that is being drawn, and until all is kept

  /// What is wanted now, most wanted first, in place of what was and is not begun. What failed once, or is
  /// being drawn, is not begun again.
  void want(std::vector<ThumbnailJob> jobs);
  /// Writes one that was made elsewhere.
  void keep(std::string key, Thumbnail thumbnail);
  bool is_busy() const;   ///< draws, or has something to take
  bool has_news() const;  ///< take() has something to take

  struct Made {
    std::string key;
    Thumbnail thumbnail;
  };
  std::vector<Made> take();

 private:
  void start();
  std::optional<ThumbnailJob> next_job(const std::stop_token& stop);
  std::optional<Made> next_to_keep();
  void work(const std::stop_token& stop);  ///< of the thread
  void work_off(const std::stop_token& stop);
  void draw(const Draw& draw, const ThumbnailJob& job);

  Keep keep_;
  std::function<Draw()> make_draw_;
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<ThumbnailJob> waiting_;
  std::deque<Made> to_keep_;
  std::string drawing_;  ///< its key; empty between two
  std::vector<std::string> failed_;
  std::vector<Made> made_;
  std::jthread thread_;  ///< begins with the first work
};

/// The volume with some of its points, evenly spread, so that no axis has more than `most`; its box stays.
Volume with_at_most(const Volume& volume, int most);

}  // namespace crest
