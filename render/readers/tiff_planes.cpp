#include "render/readers/tiff_planes.h"

#include <fmt/core.h>

#include <numeric>

#include "render/readers/voxel_header.h"

namespace crest {
namespace {

/// A file of one page is often one of many, whose order its description tells: lengths and values are its
/// own.
PlaneOrder order_one(const TiffDescription& description) {
  PlaneOrder order;
  order.pages = {0};
  const bool tells_more = is_imagej(description.text) ? take_one_of_imagej(description, order)
                          : is_ome(description.text)  ? take_one_of_ome(description.text, order)
                                                      : false;
  if (tells_more) add_note(order.note, "channels and frames that descriptions tell of are not taken apart");
  return order;
}

}  // namespace

std::size_t place_in(const PlaneOrder& order, std::size_t component, std::size_t slice, std::size_t frame) {
  return (frame * order.components + component) * order.slices + slice;
}

void take_only_axis_as_slices(PlaneOrder& order) {
  if (order.slices > 1 || (order.components > 1) == (order.frames > 1)) return;
  add_note(order.note,
           fmt::format("its {} are taken as slices", order.components > 1 ? "channels" : "frames"));
  order.slices = order.components * order.frames;
  order.components = order.frames = 1;
}

PlaneOrder order_pages(const TiffDescription& description, std::size_t pages) {
  PlaneOrder order;
  order.pages = description.whole_pages;
  if (order.pages.empty()) {
    order.pages.resize(pages);
    std::iota(order.pages.begin(), order.pages.end(), std::size_t(0));
  }
  order.slices = order.pages.size();
  order.left_out = pages - order.slices;
  return order;
}

PlaneOrder order_planes(const std::string& name, const TiffDescription& description, std::size_t pages) {
  if (pages == 1) return order_one(description);
  if (is_imagej(description.text)) return order_imagej(name, description, pages);
  if (is_ome(description.text)) return order_ome(name, description, pages);
  if (is_shaped(description.text)) return order_shaped(description, pages);
  return order_pages(description, pages);
}

}  // namespace crest
