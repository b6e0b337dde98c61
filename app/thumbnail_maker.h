#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
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

/// Makes thumbnails beside the window, in a thread that is there while there is work. No call waits for it.
class ThumbnailMaker {
 public:
  using Draw = std::function<Thumbnail(const ThumbnailJob&)>;
  /// In an off-screen context of its own, with volumes thinned to some 100 points an axis. Throws Error.
  static Draw draw_offscreen();

  /// `make_draw` is called, and what it gives dies, in the thread.
  explicit ThumbnailMaker(std::function<Draw()> make_draw = draw_offscreen);
  ~ThumbnailMaker();  ///< waits for the picture that is being drawn

  /// What is wanted now, most wanted first, in place of what was and is not begun. What failed once, or is
  /// being drawn, is not begun again.
  void want(std::vector<ThumbnailJob> jobs);
  bool is_busy() const;
  bool has_news() const;  ///< take() has something to take

  struct Made {
    std::string key;
    Thumbnail thumbnail;
  };
  std::vector<Made> take();

 private:
  std::optional<ThumbnailJob> next_job(const std::stop_token& stop);
  void work(const std::stop_token& stop);  ///< of the thread

  std::function<Draw()> make_draw_;
  mutable std::mutex mutex_;
  std::deque<ThumbnailJob> waiting_;
  std::string drawing_;  ///< its key; empty between two
  std::vector<std::string> failed_;
  std::vector<Made> made_;
  bool is_working_ = false;
  std::jthread thread_;
};

/// The volume with some of its points, evenly spread, so that no axis has more than `most`; its box stays.
Volume thinned(const Volume& volume, int most);

}  // namespace crest
