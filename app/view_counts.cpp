#include <exception>

#include "app/view_renderer.h"
#include "render/notes.h"

// What the pictures of the views cost, and whether they show anything: nobody waits for that.

namespace crest {
namespace {

/// Costs are counted on a picture this much smaller than the view, of no more rays than these.
constexpr int least_coarseness = 8;
constexpr double most_counted_rays = 10000;

glm::ivec2 counted_size(glm::ivec2 size) {
  int coarseness = least_coarseness;
  while (double(size.x) * size.y / (coarseness * coarseness) > most_counted_rays) coarseness *= 2;
  return (size + coarseness - 1) / coarseness;
}

}  // namespace

// What a picture costs may stay unknown: the picture is there.
void ViewRenderer::begin_counting(View& view) try {
  gl::RenderTarget target(counted_size(view.wanted.size), true);
  PendingCounts counts = renderer_.begin_counts(view.wanted.scene, view.wanted.camera, target);
  view.counting.emplace(
      Counting{std::move(counts), gl::PendingRead(target, gl::PendingRead::What::color), {}});
} catch (const std::exception&) {
  view.counts = {};
  end_counting(view);
}

void ViewRenderer::take_counts() {
  for (View& view : views_) try {
      if (view.counting) take_counts(view);
    } catch (const std::exception&) {
      view.counts = {};
      end_counting(view);
    }
}

// The small picture may miss what is as small as its pixels: where it shows nothing, the one in full is read.
void ViewRenderer::take_counts(View& view) {
  Counting& counting = *view.counting;
  if (!counting.counts.is_over() || !counting.small.is_over()) return;
  const Scene& scene = view.wanted.scene;
  const glm::vec3 background(scene.rendering.background);
  if (!counting.full) {
    view.counts = sum_of(counting.counts.take());
    const Image small{counting.small.size(), counting.small.color()};
    if (!has_visible_pixel(small, background) && view.full)
      counting.full.emplace(*view.full, gl::PendingRead::What::color);
  }
  if (counting.full) {
    if (!counting.full->is_over()) return;
    if (!has_visible_pixel({counting.full->size(), counting.full->color()}, background))
      view.nothing_visible = why_nothing_is_visible(scene, view.wanted.camera, view.wanted.size);
  }
  end_counting(view);
}

void ViewRenderer::end_counting(View& view) {
  if (!keeps_colors_) view.full.reset();
  view.is_counted = true;
  view.counting.reset();
}

}  // namespace crest
