#include "app/view_difference.h"

#include <algorithm>
#include <cmath>

#include "render/measure/image_error.h"

namespace crest {
namespace {

DifferencePicture measured(const gl::Presenter::Side& a, const gl::Presenter::Side& b) {
  const Image first = over_background(a.picture.read_color(), a.background),
              second = over_background(b.picture.read_color(), b.background);
  DifferencePicture result;
  double squares = 0;
  std::size_t off = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    const glm::dvec3 difference(second.pixels[i] - first.pixels[i]);
    const double most = std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
    squares += difference.x * difference.x + difference.y * difference.y + difference.z * difference.z;
    result.max = std::max(result.max, most);
    if (most > one_step_of_8_bits) ++off;
  }
  const double count = double(std::max<std::size_t>(first.pixels.size(), 1));
  result.rmse = std::sqrt(squares / (3 * count));
  result.share = double(off) / count;
  return result;
}

}  // namespace

void ViewDifference::clear() {
  picture_ = {};
  display_.reset();
  shown_ = measured_ = {};
}

void ViewDifference::update(const ViewRenderer& views, const Comparison& comparison, bool measures) {
  const gl::RenderTarget *own = views.colors(comparison.view), *other = views.colors(compared_picture);
  if (!own || !other || own->size() != other->size()) {
    picture_.texture = 0;
    shown_ = measured_ = {};
    return;
  }
  const auto versions = views.wanted_versions();
  const Subject subject{versions[std::size_t(comparison.view)], versions[compared_picture], comparison.view,
                        comparison.amplification, comparison.kind == ComparisonKind::signed_difference};
  const bool is_measured = !measures || subject.is_same_pair(measured_);
  if (subject == shown_ && is_measured) return;
  const gl::Presenter::Side a{*own, glm::vec3(views.background(comparison.view))},
      b{*other, glm::vec3(views.background(compared_picture))};
  if (!presenter_) presenter_.emplace();
  if (!display_ || display_->size() != own->size())
    display_ = std::make_unique<gl::DisplayTexture>(own->size());
  presenter_->present_difference(a, b, *display_, subject.amplification, subject.with_sign);
  if (!is_measured) {
    picture_ = measured(a, b);
    measured_ = subject;
  }
  picture_.texture = display_->texture();
  shown_ = subject;
}

}  // namespace crest
