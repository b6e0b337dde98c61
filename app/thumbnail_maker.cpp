#include "app/thumbnail_maker.h"

#include <algorithm>
#include <utility>

#include "app/cache_folder.h"
#include "app/offscreen_context.h"
#include "app/thread_priority.h"
#include "render/files/time_steps.h"
#include "render/renderer.h"
#include "render/scene/camera.h"

namespace crest {
namespace {

constexpr int most_points = 96;  // an axis: about half a pixel of a thumbnail

/// A context, and the volume that the last picture was of.
struct Offscreen {
  OffscreenContext context;
  Renderer renderer{std::filesystem::path(), program_folder()};
  std::shared_ptr<const Volume> original, small;
  std::string source;

  void open(const ThumbnailJob& job) {
    if (job.volume ? original == job.volume : original && source == job.source) return;
    original = job.volume ? job.volume : std::make_shared<const Volume>(load_first_step(job.source));
    source = job.volume ? "" : job.source;
    small = std::make_shared<const Volume>(with_at_most(*original, most_points));
    renderer.hold(small);
  }

  Thumbnail draw(const ThumbnailJob& job) {
    open(job);
    const Preset preset = job.read_preset();
    Scene scene = make_scene(original, preset);  // its unit may be the original's voxels
    scene.volume = small;
    const double aspect = double(thumbnail_size.x) / thumbnail_size.y;
    gl::RenderTarget target(thumbnail_size, false);
    renderer.draw(scene, whole_volume_camera(small->grid, aspect), target);
    return thumbnail_of(target.read_color(), glm::vec3(preset.rendering.background));
  }
};

}  // namespace

Volume with_at_most(const Volume& volume, int most) {
  const glm::ivec3 dims = volume.grid.dims;
  Volume small;
  small.name = volume.name;
  small.file_type = volume.file_type;
  small.grid = volume.grid;
  small.grid.dims = glm::min(dims, glm::ivec3(most));
  small.grid.spacing = volume.grid.box_size() / glm::dvec3(small.grid.dims - 1);
  const auto at = [&](int i, int axis) {
    const int last = small.grid.dims[axis] - 1;
    return int((std::int64_t(i) * (dims[axis] - 1) + last / 2) / last);
  };
  std::vector<float>& values = small.values.floats();
  values.reserve(small.grid.point_count());
  for (int k = 0; k < small.grid.dims.z; ++k)
    for (int j = 0; j < small.grid.dims.y; ++j)
      for (int i = 0; i < small.grid.dims.x; ++i) values.push_back(volume.at(at(i, 0), at(j, 1), at(k, 2)));
  small.statistics = compute_statistics(small.grid, small.values);
  return small;
}

ThumbnailMaker::Draw ThumbnailMaker::draw_offscreen() {
  return
      [offscreen = std::make_shared<Offscreen>()](const ThumbnailJob& job) { return offscreen->draw(job); };
}

ThumbnailMaker::ThumbnailMaker(Keep keep, std::function<Draw()> make_draw)
    : keep_(std::move(keep)), make_draw_(std::move(make_draw)) {}
ThumbnailMaker::~ThumbnailMaker() { thread_.request_stop(); }

/// The lock is held.
void ThumbnailMaker::start() {
  if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
  wake_.notify_all();
}

void ThumbnailMaker::want(std::vector<ThumbnailJob> jobs) {
  const std::scoped_lock lock(mutex_);
  waiting_.clear();
  for (ThumbnailJob& job : jobs) {
    const bool is_made = std::ranges::any_of(made_, [&](const Made& made) { return made.key == job.key; });
    if (job.key != drawing_ && !is_made && std::ranges::find(failed_, job.key) == failed_.end())
      waiting_.push_back(std::move(job));
  }
  if (!waiting_.empty()) start();
}

void ThumbnailMaker::keep(std::string key, Thumbnail thumbnail) {
  if (!keep_) return;
  const std::scoped_lock lock(mutex_);
  to_keep_.push_back({std::move(key), std::move(thumbnail)});
  start();
}

bool ThumbnailMaker::is_busy() const {
  const std::scoped_lock lock(mutex_);
  return !waiting_.empty() || !drawing_.empty() || !made_.empty();
}

bool ThumbnailMaker::has_news() const {
  const std::scoped_lock lock(mutex_);
  return !made_.empty();
}

std::vector<ThumbnailMaker::Made> ThumbnailMaker::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(made_, {});
}

std::optional<ThumbnailJob> ThumbnailMaker::next_job(const std::stop_token& stop) {
  const std::scoped_lock lock(mutex_);
  if (stop.stop_requested()) waiting_.clear();
  if (waiting_.empty()) return std::nullopt;
  ThumbnailJob job = std::move(waiting_.front());
  waiting_.pop_front();
  drawing_ = job.key;
  return job;
}

std::optional<ThumbnailMaker::Made> ThumbnailMaker::next_to_keep() {
  const std::scoped_lock lock(mutex_);
  if (to_keep_.empty()) return std::nullopt;
  Made next = std::move(to_keep_.front());
  to_keep_.pop_front();
  return next;
}

void ThumbnailMaker::draw(const Draw& draw, const ThumbnailJob& job) {
  std::optional<Thumbnail> thumbnail;
  try {
    thumbnail = draw(job);
    if (keep_) keep_(job.key, *thumbnail);
  } catch (const std::exception&) {
    // The place for it stays empty
  }
  const std::scoped_lock lock(mutex_);
  drawing_.clear();
  if (thumbnail)
    made_.push_back({job.key, std::move(*thumbnail)});
  else
    failed_.push_back(job.key);
}

/// What there is to do; the context goes when nothing is left to draw.
void ThumbnailMaker::work_off(const std::stop_token& stop) {
  Draw draw_one;
  for (;;) {
    while (const auto kept = next_to_keep()) keep_(kept->key, kept->thumbnail);
    const auto job = next_job(stop);
    if (!job) return;
    draw(
        [&](const ThumbnailJob& wanted) {
          if (!draw_one) draw_one = make_draw_();
          return draw_one(wanted);
        },
        *job);
  }
}

void ThumbnailMaker::work(const std::stop_token& stop) {
  lower_thread_priority();
  for (bool goes_on = true; goes_on;) {
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, stop, [&] { return !waiting_.empty() || !to_keep_.empty(); });
      goes_on = !stop.stop_requested();
    }
    work_off(stop);
  }
}

}  // namespace crest
