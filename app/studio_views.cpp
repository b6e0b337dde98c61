#include <algorithm>
#include <utility>

#include "app/studio.h"
#include "render/scene/camera.h"
#include "render/scene/exact.h"

// What the studio's views are to show, and what a person finds out in them.

namespace crest {
namespace {

/// The preset with the surface of these points in a colour that stands out.
Preset with_lit_points(Preset preset, std::pair<std::size_t, std::size_t> points) {
  constexpr double least_opacity = 0.9;
  const glm::dvec3 light{1, 0.15, 0.85};
  auto& all = preset.transfer_function.points;
  for (std::size_t i = points.first; i <= points.second && i < all.size(); ++i) {
    all[i].color = light;
    all[i].surface.opacity = std::max(all[i].surface.opacity.value_or(all[i].opacity), least_opacity);
  }
  return preset;
}

}  // namespace

/// What a view shows, where `own` is the document's scene.
Scene Studio::scene_of(const ViewContent& content, const Scene& own) const {
  Scene scene = content.other ? make_scene(loaded_.volume, content.other->preset) : own;
  scene.rendering = rendering_of(content, document_.preset);
  return scene;
}

/// Its picture; by the exact march where that is wanted, and there is one for the settings.
ViewRequest Studio::view_request(const ViewContent& content, const Scene& own,
                                 ShownPicture shown_by_all_views, glm::ivec2 size) const {
  const Camera camera = camera_of(document_.preset, loaded_.volume->grid, aspect_of(size));
  ViewRequest request{scene_of(content, own), camera, size};
  const ShownPicture shown = content.picture.value_or(shown_by_all_views);
  Rendering& rendering = request.scene.rendering;
  if (shown == ShownPicture::as_set || !why_not_exact(rendering).empty()) return request;
  rendering = exact_rendering(rendering);
  request.error_bound = shown == ShownPicture::error_bound;
  return request;
}

std::array<ViewRequest, picture_count> Studio::view_requests(const StudioRequests& requests) const {
  std::array<ViewRequest, picture_count> wanted;
  if (!loaded_.volume) return wanted;
  const auto& lit = requests.lit_points;
  const Scene own =
      make_scene(loaded_.volume, lit ? with_lit_points(document_.preset, *lit) : document_.preset);
  for (std::size_t i = 0; i < view_count; ++i)
    if (const glm::ivec2 size = requests.view_pixels[i]; size.x > 0)
      wanted[i] = view_request(requests.contents[i], own, requests.shown_picture, size);
  if (requests.comparison)
    wanted[compared_picture] = view_request(requests.comparison->with, own, requests.shown_picture,
                                            requests.view_pixels[std::size_t(requests.comparison->view)]);
  return wanted;
}

void Studio::update_difference(const StudioRequests& requests, bool interactive) {
  const bool is_wanted = requests.comparison && requests.comparison->takes_difference();
  if (!is_wanted) return difference_.clear();
  try {
    difference_.update(views_, *requests.comparison, !interactive);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Studio::update_slices(const StudioRequests& requests) {
  if (!requests.slices) return slices_.clear();
  if (!loaded_.volume) return;
  try {
    slices_.update(views_.renderer().resources(), make_scene(loaded_.volume, document_.preset),
                   *requests.slices);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

/// The inspected ray is brought up to date when nothing moves; what is under the mouse is solved at once.
void Studio::update_rays(const StudioRequests& requests, bool interactive) {
  if (!requests.inspect || !loaded_.volume) rays_.clear();
  picked_.reset();
  if (!loaded_.volume || (!requests.inspect && !requests.hovered)) return;
  try {
    const auto camera = [&](const RayAsk& ask) {
      return camera_of(document_.preset, loaded_.volume->grid, aspect_of(ask.size));
    };
    const Scene own = make_scene(loaded_.volume, document_.preset);
    if (requests.inspect) rays_.want(own, camera(*requests.inspect), *requests.inspect);
    if (!interactive) rays_.work(views_.renderer());
    if (const auto& ask = requests.hovered; ask && !requests.document_changed)
      picked_ = rays_.pick(scene_of(requests.contents[std::size_t(ask->view)], own), camera(*ask), *ask);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

/// The size of the view of the preset's own mode, or of another where that is not to be seen.
glm::ivec2 Studio::own_view(const StudioRequests& requests) const {
  glm::ivec2 size{0};
  for (std::size_t i = 0; i < view_count; ++i)
    if (const glm::ivec2 view = requests.view_pixels[i];
        view.x > 0 && (size.x == 0 || requests.contents[i].mode == document_.preset.rendering.mode))
      size = view;
  return size;
}

}  // namespace crest
