#include "app/view_difference.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/measure/image_error.h"

namespace crest {

void ViewDifference::clear() {
  forget();
  display_.reset();
}

void ViewDifference::forget() {
  picture_ = {};
  shown_ = {};
  asked_.reset();
  measuring_.reset();
}

DifferencePicture ViewDifference::picture() const {
  DifferencePicture picture = picture_;
  const bool is_asked = asked_ && asked_->is_same_pair(shown_);
  picture.is_measured = is_asked && has_numbers_;
  picture.has_failed = is_asked && !has_numbers_ && !measuring_;
  return picture;
}

void ViewDifference::take_numbers() {
  if (!measuring_ || !measuring_->sums.is_over()) return;
  const Measuring done = *std::exchange(measuring_, {});
  double most = 0, squares = 0, off = 0;
  for (const glm::vec4& block : done.sums.color()) {
    most = std::max(most, double(block.x));
    squares += double(block.y);
    off += double(block.z);
  }
  picture_.max = most;
  picture_.rmse = std::sqrt(squares / (3 * done.pixels));
  picture_.share = off / done.pixels;
  has_numbers_ = true;
}

void ViewDifference::update(const ViewRenderer& views, const Comparison& comparison, bool measures) {
  const gl::RenderTarget *own = views.colors(comparison.view), *other = views.colors(compared_picture);
  if (!own || !other || own->size() != other->size()) return forget();
  take_numbers();
  const auto versions = views.wanted_versions();
  const Subject subject{versions[std::size_t(comparison.view)], versions[compared_picture], comparison.view,
                        comparison.amplification, comparison.kind == ComparisonKind::signed_difference};
  const bool asks = measures && !(asked_ && subject.is_same_pair(*asked_));
  if (subject == shown_ && !asks) return;
  shown_ = subject;
  picture_.texture = 0;
  if (asks) {  // what fails from here on is not asked for again
    asked_ = subject;
    has_numbers_ = false;
    measuring_.reset();
  }
  const gl::Presenter::Side a{*own, glm::vec3(views.background(comparison.view))},
      b{*other, glm::vec3(views.background(compared_picture))};
  if (!presenter_) presenter_.emplace();
  if (!display_ || display_->size() != own->size())
    display_ = std::make_unique<gl::DisplayTexture>(own->size());
  presenter_->present_difference(a, b, *display_, subject.amplification, subject.with_sign);
  picture_.texture = display_->texture();
  if (!asks) return;
  measuring_.emplace(
      Measuring{double(own->size().x) * own->size().y,
                {presenter_->sum_difference(a, b, one_step_of_8_bits), gl::PendingRead::What::color}});
}

}  // namespace crest
