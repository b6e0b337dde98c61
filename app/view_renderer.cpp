#include "app/view_renderer.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "app/next_slice.h"
#include "presets/choices.h"
#include "render/measure/timing.h"
#include "render/notes.h"
#include "render/scene/exact.h"
#include "render/scene/float_precision.h"

namespace crest {
namespace {

/// A coarse picture of one view should take about this long.
constexpr double coarse_ms = 5;
/// A slice that is drawn at once: the window cannot react meanwhile.
constexpr double slice_ms = 8;
/// So many slices of a view may wait for the device: one that it draws, and one to go on with.
constexpr std::size_t most_queued = 2;
constexpr int coarsest = 16;

glm::ivec2 coarse_size(glm::ivec2 size, int coarseness) { return (size + coarseness - 1) / coarseness; }

/// An exact picture that takes no longer needs no preview.
constexpr double quick_ms = 60;

/// By samples that keep the surfaces: pre-integration where spikes are shown by DVR alone.
Rendering sampled(Rendering rendering, const Classification& classification) {
  const bool by_dvr = shows_dvr(rendering.mode) && !is_exclusive(rendering.mode);
  rendering.classification = by_dvr && std::ranges::any_of(classification.peaks, &Peak::spike)
                                 ? ClassificationMethod::preintegrated
                                 : ClassificationMethod::post;
  rendering.step = 1;
  return rendering;
}

std::vector<std::string> warnings_of(const ViewRequest& request) {
  if (request.size.x <= 0 || !request.scene.volume) return {};
  std::vector<std::string> warnings = scene_notes(request.scene);
  for (std::string& warning : scene_warnings(request.scene, request.camera, request.size))
    warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace

bool ViewRequest::operator==(const ViewRequest& other) const {
  return scene.volume == other.scene.volume && scene.tf == other.scene.tf &&
         scene.rendering == other.scene.rendering && camera == other.camera && size == other.size &&
         error_bound == other.error_bound;
}

bool ViewRenderer::is_same_but_for_bound(ViewRequest a, const ViewRequest& b) {
  a.error_bound = b.error_bound;
  return a == b;
}

/// Of another kind of picture: a first guess is that an exact one takes five times as long as samples.
void ViewRenderer::forget_costs(View& view) {
  const double sampled_ms = view.ms_per_pixel[coarse];
  view.ms_per_pixel[full] = is_exact(view.wanted.scene.rendering) ? 5 * sampled_ms : sampled_ms;
  view.counts = {};
  view.frame_ms = 0;
}

ViewRenderer::ViewRenderer(std::filesystem::path shader_folder, std::filesystem::path program_folder)
    : renderer_(std::move(shader_folder), std::move(program_folder)) {}

void ViewRenderer::work(const std::array<ViewRequest, picture_count>& requests, double budget_ms,
                        bool interactive) {
  for (std::size_t i = 0; i < picture_count; ++i) {
    View& view = views_[i];
    if (requests[i] == view.wanted) continue;
    const bool was_exact = is_exact(view.wanted.scene.rendering),
               shows = view.shown_version == view.wanted_version;
    const bool is_same_picture = shows && is_same_but_for_bound(requests[i], view.wanted);
    view.wanted = requests[i];
    if (is_exact(view.wanted.scene.rendering) != was_exact) forget_costs(view);
    view.warnings = warnings_of(view.wanted);
    view.nothing_visible.clear();
    view.error.clear();
    ++view.wanted_version;
    if (is_same_picture) view.shown_version = view.wanted_version;
    if (is_same_picture && view.shown_stage == full) view.shown_stage = preview;
    view.is_counted = view.is_counted && is_same_picture;
    view.full.reset();
    view.counting.reset();
    const bool keep = view.pass && view.pass->coarseness > 1 && view.pass->request.size == view.wanted.size &&
                      view.pass->request.scene.volume == view.wanted.scene.volume;
    if (!keep) view.pass.reset();
  }
  for (View& view : views_) {
    view.last.clear();
    if (is_closed_) let_go(view);
    if (keeps_colors_ && is_done(view) && !view.full && view.error.empty()) view.shown_stage = preview;
    if (!keeps_colors_ && view.is_counted) view.full.reset();
  }
  is_closed_ = false;
  const auto begin = std::chrono::steady_clock::now();
  const auto spent_ms = [&] {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  };
  take_counts();
  for (take_times(); spent_ms() + queued_ms() < budget_ms; take_times()) {
    View* view = next_view();
    if (!view) break;
    try {
      if (!view->pass && is_done(*view)) {
        begin_counting(*view);
        continue;
      }
      if (!view->pass) {
        view->need = renderer_.need(view->wanted.scene, view->wanted.camera, view->wanted.size);
        begin_pass(*view, interactive);
      }
      draw_slice(*view, interactive ? slice_ms : std::max(slice_ms, budget_ms / 2), interactive);
    } catch (const std::exception& error) {
      give_up(*view, error.what());
    }
  }
}

/// Of all but its number and what is known of its speed.
void ViewRenderer::let_go(View& view) {
  View empty;
  empty.wanted_version = view.wanted_version;
  empty.ms_per_pixel = view.ms_per_pixel;
  for (auto* display : {&view.small, &view.display})
    if (*display) empty.last.push_back(std::move(*display));
  view = std::move(empty);
}

void ViewRenderer::close() {
  is_closed_ = true;
  renderer_.clear();
}

std::string ViewRenderer::error() const {
  for (const View& view : views_)
    if (!view.error.empty()) return view.error;
  return "";
}

bool ViewRenderer::shows_what_is_wanted(int index) const {
  const View& view = views_[std::size_t(index)];
  return view.shown() && view.error.empty() && view.shown_version == view.wanted_version &&
         view.shown_coarseness == 1;
}

void ViewRenderer::give_up(View& view, std::string why) {
  view.error = std::move(why);
  view.pass.reset();
  view.shown_version = view.wanted_version;
  view.shown_stage = full;
  view.shown_coarseness = 1;
  view.is_counted = true;
  view.counting.reset();
  view.full.reset();
}

bool ViewRenderer::is_done(const View& view) {
  return view.shown_version == view.wanted_version && view.shown_stage == full && view.shown_coarseness > 0;
}

bool ViewRenderer::is_busy() const {
  return std::ranges::any_of(views_, [](const View& view) {
    return view.wanted.size.x > 0 && view.wanted.scene.volume &&
           (view.pass || !view.queued.empty() || !is_done(view) || !view.is_counted);
  });
}

bool ViewRenderer::only_counts() const {
  return is_busy() && std::ranges::all_of(views_, [](const View& view) {
           const bool is_shown = view.wanted.size.x > 0 && view.wanted.scene.volume;
           return !is_shown ||
                  (!view.pass && view.queued.empty() && is_done(view) && (view.is_counted || view.counting));
         });
}

void ViewRenderer::take_times() {
  for (View& view : views_)
    for (; !view.queued.empty() && gl::is_over(view.queued.front().time); view.queued.pop_front()) {
      const Slice& slice = view.queued.front();
      const double ms = gl::measured_ms(slice.time);
      double& ms_per_pixel = view.ms_per_pixel[slice.stage];
      ms_per_pixel = std::max(1e-7, 0.5 * ms_per_pixel + 0.5 * ms / slice.pixels);
      view.pass_ms = (slice.is_first ? 0 : view.pass_ms) + ms;
      if (slice.stage == full && slice.is_last) view.frame_ms = view.pass_ms;
    }
}

double ViewRenderer::queued_ms() const {
  double ms = 0;
  for (const View& view : views_)
    for (const Slice& slice : view.queued) ms += slice.expected_ms;
  return ms;
}

/// In turn: first the views that show an old picture, then those that show a coarse one, then previews, then
/// those not counted.
ViewRenderer::View* ViewRenderer::next_view() {
  View* best = nullptr;
  int best_rank = 4;
  for (std::size_t i = 1; i <= picture_count; ++i) {
    View& view = views_[(last_view_ + i) % picture_count];
    if (view.wanted.size.x <= 0 || !view.wanted.scene.volume || view.queued.size() >= most_queued) continue;
    if (view.pass && view.pass->waits()) continue;
    const int rank = view.shown_version != view.wanted_version ? 0
                     : view.shown_stage == coarse              ? 1
                     : view.shown_stage == preview             ? 2
                     : !view.is_counted && !view.counting      ? 3
                                                               : 4;
    if (rank < best_rank) {
      best = &view;
      best_rank = rank;
    }
  }
  return best;
}

/// Of a picture at full resolution.
ViewRenderer::Stage ViewRenderer::next_stage(const View& view) const {
  const bool has_preview = view.shown_version == view.wanted_version && view.shown_stage == preview;
  const double pixels = double(view.wanted.size.x) * view.wanted.size.y;
  const bool is_quick = view.ms_per_pixel[full] * pixels <= quick_ms;
  return is_exact(view.wanted.scene.rendering) && !has_preview && !is_quick ? preview : full;
}

// A coarse picture also steps further, within what still isolates most crossings; not where a table would
// have to be made for that step.
Scene ViewRenderer::scene_of(const ViewRequest& request, Stage stage, int coarseness) {
  Scene scene = request.scene;
  if (stage == full) return scene;
  Rendering& rendering = scene.rendering;
  if (is_exact(rendering)) rendering = sampled(rendering, renderer_.classification(scene));
  if (stage == coarse && !holds_one_length(rendering.classification))
    rendering.step = std::max(rendering.step, coarseness > 4 ? 2.0 : 1.0);
  return scene;
}

void ViewRenderer::begin_pass(View& view, bool interactive) {
  Pass pass;
  pass.request = view.wanted;
  pass.version = view.wanted_version;
  const glm::ivec2 size = view.wanted.size;
  if (view.shown_version != view.wanted_version) {
    const double full_ms = view.ms_per_pixel[coarse] * size.x * size.y;
    while (pass.coarseness < coarsest && full_ms / (pass.coarseness * pass.coarseness) > coarse_ms)
      pass.coarseness *= 2;
  }
  if (!interactive && view.shown_coarseness == 0) pass.coarseness = std::max(pass.coarseness, 4);
  pass.stage = pass.coarseness > 1 ? coarse : next_stage(view);
  pass.scene = scene_of(pass.request, pass.stage, pass.coarseness);
  const bool counts = pass.stage == full && pass.request.error_bound;
  pass.target = std::make_unique<gl::RenderTarget>(coarse_size(size, pass.coarseness), counts);
  view.pass = std::move(pass);
}

void ViewRenderer::draw_slice(View& view, double wanted_ms, bool interactive) {
  Pass& pass = *view.pass;
  const glm::ivec2 size = pass.target->size();
  const double ms_per_pixel = view.ms_per_pixel[pass.stage];
  const Tile next = next_slice(size, pass.next, wanted_ms / ms_per_pixel);
  if (!pass.begun) {
    if (auto known = renderer_.begin(pass.scene, pass.request.camera, *pass.target, next)) {
      pass.begun.emplace(Pass::Begun{next, *std::move(known)});
      return;
    }
  }
  const Tile tile = pass.begun ? pass.begun->tile : next;
  const double pixels = double(tile.end.x - tile.begin.x) * (tile.end.y - tile.begin.y);
  gl::QueryHandle time = gl::time_on_device([&] {
    renderer_.draw(pass.scene, pass.request.camera, *pass.target, tile,
                   pass.begun ? &pass.begun->known : nullptr);
  });
  pass.begun.reset();
  pass.next = after(tile, size);
  const bool is_last = pass.next.y == size.y;
  view.queued.push_back(
      {std::move(time), ms_per_pixel * pixels, pixels, pass.stage, tile.begin == glm::ivec2(0), is_last});
  // Enlarging a coarse picture takes long in a large view: not while the next one is to come
  const bool stays_small = view.shows_small && interactive;
  if (pass.coarseness == 1 && view.shown() && !stays_small) show_slice(view, tile);
  last_view_ = std::size_t(&view - views_.data());
  if (is_last) finish_pass(view);
  glFlush();  // the device begins
}

gl::DisplayTexture& ViewRenderer::make_display(View& view, std::unique_ptr<gl::DisplayTexture>& display,
                                               glm::ivec2 size) {
  if (display && display->size() == size) return *display;
  if (display) view.last.push_back(std::move(display));
  display = std::make_unique<gl::DisplayTexture>(size);
  return *display;
}

/// A picture at full resolution appears as it grows, over what was shown before.
void ViewRenderer::show_slice(View& view, const Tile& slice) {
  const Pass& pass = *view.pass;
  const glm::ivec2 size = pass.target->size();
  if (view.shows_small) {
    make_display(view, view.display, size).enlarge(*view.small);
    view.shows_small = false;
    if (slice.begin.y > 0) show_rows(pass, *view.display, 0, slice.begin.y);
  }
  if (slice.end.x == size.x && view.display->size() == size)
    show_rows(pass, *view.display, slice.begin.y, slice.end.y);
}

void ViewRenderer::show_rows(const Pass& pass, gl::DisplayTexture& display, int first_row, int last_row) {
  if (pass.target->has_counts())
    presenter_.present_error_bounds(*pass.target, display, first_row, last_row);
  else
    presenter_.present(*pass.target, display, glm::vec3(pass.scene.rendering.background), first_row,
                       last_row);
}

void ViewRenderer::finish_pass(View& view) {
  Pass pass = std::move(*view.pass);
  view.pass.reset();
  const glm::ivec2 size = pass.target->size();
  view.shows_small = pass.coarseness > 1;
  show_rows(pass, make_display(view, view.shows_small ? view.small : view.display, size), 0, size.y);
  view.shown_version = pass.version;
  view.shown_stage = pass.stage;
  view.shown_coarseness = pass.coarseness;
  if (pass.stage == full) view.full = std::move(pass.target);
}

const gl::RenderTarget* ViewRenderer::colors(int index) const {
  const View& view = views_[std::size_t(index)];
  return keeps_colors_ && is_done(view) && view.wanted.size.x > 0 ? view.full.get() : nullptr;
}

ViewPicture ViewRenderer::picture(int index) const {
  const View& view = views_[std::size_t(index)];
  ViewPicture picture;
  picture.need = view.need;
  picture.warnings = view.warnings;
  if (!view.nothing_visible.empty()) picture.warnings.push_back(view.nothing_visible);
  if (!view.shown()) return picture;
  const bool done = is_done(view);
  picture.texture = view.shown()->texture();
  picture.coarseness = std::max(view.shown_coarseness, 1);
  picture.progress = done ? 1
                     : view.pass && view.pass->stage == full
                         ? double(view.pass->next.y) / view.pass->target->size().y
                         : 0;
  picture.frame_ms = view.frame_ms;
  picture.is_exact = is_exact(view.wanted.scene.rendering);
  if (view.counts.pixels > 0) {
    picture.samples_per_ray = view.counts.samples / view.counts.pixels;
    picture.dvr_samples_per_ray = view.counts.dvr_samples / view.counts.pixels;
    if (view.is_counted && view.counts.bounded_pixels > 0)
      picture.share_within = view.counts.pixels_within_bound / view.counts.bounded_pixels;
  }
  return picture;
}

std::array<std::uint64_t, picture_count> ViewRenderer::wanted_versions() const {
  std::array<std::uint64_t, picture_count> versions;
  std::ranges::transform(views_, versions.begin(), &View::wanted_version);
  return versions;
}

std::array<std::uint64_t, picture_count> ViewRenderer::shown_versions() const {
  std::array<std::uint64_t, picture_count> versions;
  std::ranges::transform(views_, versions.begin(), &View::shown_version);
  return versions;
}

void ViewRenderer::invalidate() {
  for (View& view : views_) {
    view.pass.reset();
    view.error.clear();
    view.nothing_visible.clear();
    view.is_counted = false;
    view.counting.reset();
    view.full.reset();
    ++view.wanted_version;
  }
}

}  // namespace crest
