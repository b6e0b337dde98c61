#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/background_task.h"
#include "app/volume_loader.h"
#include "render/volume/fit_values.h"

namespace crest {

/// Compares the volume that was open last with the present one place by place, beside the window: it is read
/// again, since no more than one is held.
class PlaceMatch {
 public:
  PlaceMatch();
  void start(const std::string& last, std::shared_ptr<const Volume> present);
  void cancel();

  struct Outcome {
    std::optional<ValueFit> fit;
    std::string error;  ///< why there is none
  };
  /// What came of it, once.
  std::optional<Outcome> take();
  bool is_busy() const { return loader_.is_loading() || task_.is_running(); }
  /// take() is worth a call: as long as the last volume is read, too.
  bool has_news() const { return loader_.is_loading() || task_.has_news(); }
  bool has_thread() const { return loader_.has_thread(); }  ///< VolumeLoader::has_thread

 private:
  struct Pair {
    std::shared_ptr<const Volume> from, to;
  };
  VolumeLoader loader_;
  std::shared_ptr<const Volume> present_;  ///< until the last one is read
  BackgroundTask<Pair, ValueFit> task_;
};

}  // namespace crest
