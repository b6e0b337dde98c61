#include "app/view_difference.h"

#include <algorithm>
#include <cmath>

#include "render/measure/image_error.h"

namespace crest {

void ViewDifference::clear() {
  picture_ = {};
  display_.reset();
  measuring_.reset();
  shown_ = measured_ = {};
}

void ViewDifference::take_numbers() {
  if (!measuring_ || !measuring_->sums.is_over()) return;
  double most = 0, squares = 0, off = 0;
  for (const glm::vec4& block : measuring_->sums.color()) {
    most = std::max(most, double(block.x));
    squares += double(block.y);
    off += double(block.z);
  }
  picture_.max = most;
  picture_.rmse = std::sqrt(squares / (3 * measuring_->pixels));
  picture_.share = off / measuring_->pixels;
  measured_ = measuring_->subject;
  measuring_.reset();
}

void ViewDifference::update(const ViewRenderer& views, const Comparison& comparison, bool measures) {
  const gl::RenderTarget *own = views.colors(comparison.view), *other = views.colors(compared_picture);
  if (!own || !other || own->size() != other->size()) {
    picture_.texture = 0;
    measuring_.reset();
    shown_ = measured_ = {};
    return;
  }
  take_numbers();
  const auto versions = views.wanted_versions();
  const Subject subject{versions[std::size_t(comparison.view)], versions[compared_picture], comparison.view,
                        comparison.amplification, comparison.kind == ComparisonKind::signed_difference};
  const bool is_measured = !measures || subject.is_same_pair(measured_) ||
                           (measuring_ && subject.is_same_pair(measuring_->subject));
  if (subject == shown_ && is_measured) return;
  const gl::Presenter::Side a{*own, glm::vec3(views.background(comparison.view))},
      b{*other, glm::vec3(views.background(compared_picture))};
  if (!presenter_) presenter_.emplace();
  if (!display_ || display_->size() != own->size())
    display_ = std::make_unique<gl::DisplayTexture>(own->size());
  presenter_->present_difference(a, b, *display_, subject.amplification, subject.with_sign);
  if (!is_measured)
    measuring_.emplace(
        Measuring{subject,
                  double(own->size().x) * own->size().y,
                  {presenter_->sum_difference(a, b, one_step_of_8_bits), gl::PendingRead::What::color}});
  picture_.texture = display_->texture();
  shown_ = subject;
}

}  // namespace crest
