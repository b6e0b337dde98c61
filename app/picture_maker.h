#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/background_task.h"
#include "render/scene/scene.h"

namespace crest {

/// A picture that is saved: of one scene, or of several side by side with what they show; or one turn about
/// them, in files that are numbered.
struct PictureJob {
  struct View {
    Scene scene;
    std::string label;
  };
  std::vector<View> views;
  Camera camera;
  glm::ivec2 size{0};  ///< of each view
  int pictures = 1;    ///< of the turn
  std::filesystem::path path;
  Preset preset;  ///< kept in each file, with the camera in force
};

/// The name of one of the files: turn.png, or turn-001.png to turn-036.png.
std::filesystem::path numbered(const std::filesystem::path& path, int index, int count);

/// The same with any number, as many digits as `largest` has, at least three.
std::filesystem::path with_number(const std::filesystem::path& path, int number, int largest);

/// The camera after a part of a turn about what it looks at.
Camera turned(const Camera& camera, int index, int count);

/// Saves pictures beside the window, in a thread with a context of its own.
class PictureMaker {
 public:
  PictureMaker();
  void start(PictureJob job);
  void stop() { task_.stop(); }
  bool is_busy() const { return task_.is_running(); }
  bool has_news() const { return task_.has_news(); }
  /// "Saving turn.png: 3 of 36"; empty while nothing is saved.
  std::string progress() const;
  using Task = BackgroundTask<PictureJob, std::string>;
  /// What to tell when it is done.
  std::optional<Task::Outcome> take() { return task_.take(); }

 private:
  std::string name_;
  int count_ = 0;
  std::shared_ptr<std::atomic<int>> done_ = std::make_shared<std::atomic<int>>(0);
  Task task_;
};

}  // namespace crest
