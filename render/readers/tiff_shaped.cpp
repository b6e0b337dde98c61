// Python's tifffile: {"axes": "CZYX", "shape": [2, 5, 6, 8]}, in any order, and often without axes.
#include <algorithm>

#include "presets/json.h"
#include "render/readers/tiff_planes.h"
#include "render/readers/voxel_header.h"

namespace crest {
namespace {

/// An axis that pages lie along.
struct PageAxis {
  std::size_t size = 1;
  char letter = '?';  ///< 'C', 'Z', 'T' and others; '?' where none is told
};

/// Those before the page's own, the slowest first; none where their product is not the pages.
std::vector<PageAxis> page_axes(const nlohmann::json& array, std::size_t pages) {
  const auto& shape = array["shape"];
  const auto axes = array.find("axes");
  const std::string letters = axes != array.end() && axes->is_string() ? axes->get<std::string>() : "";
  std::vector<PageAxis> found;
  std::size_t all = 1;
  for (std::size_t i = 0; i < shape.size() && all != pages; ++i) {
    const std::size_t size = shape[i].is_number_unsigned() ? shape[i].get<std::size_t>() : 0;
    if (size < 1 || size > pages / all) return {};
    all *= size;
    if (size > 1) found.push_back({size, letters.size() == shape.size() ? letters[i] : '?'});
  }
  return all == pages ? found : std::vector<PageAxis>();
}

/// Slices where no axis is said to be: the last one that is neither channels nor times.
void find_slices(std::vector<PageAxis>& axes) {
  if (std::ranges::find(axes, 'Z', &PageAxis::letter) != axes.end()) return;
  const auto last = std::find_if(axes.rbegin(), axes.rend(), [](const PageAxis& axis) {
    return axis.letter != 'C' && axis.letter != 'S' && axis.letter != 'T';
  });
  if (last != axes.rend()) last->letter = 'Z';
}

std::size_t& count_along(const PageAxis& axis, PlaneOrder& order) {
  if (axis.letter == 'Z') return order.slices;
  return axis.letter == 'C' || axis.letter == 'S' ? order.components : order.frames;
}

}  // namespace

bool is_shaped(const std::string& text) {
  return text.starts_with('{') && text.find("\"shape\"") != std::string::npos;
}

PlaneOrder order_shaped(const TiffDescription& description, std::size_t pages) {
  PlaneOrder order = order_pages(description, pages);
  const auto array = nlohmann::json::parse(description.text, nullptr, false);
  if (!array.is_object() || !array.contains("shape") || !array["shape"].is_array()) return order;
  std::vector<PageAxis> axes = page_axes(array, order.pages.size());
  if (axes.size() < 2 && (axes.empty() || axes[0].letter == '?')) return order;
  if (axes.back().letter == '?') add_note(order.note, "its axes are taken as frames, z, y, x");
  find_slices(axes);
  const std::vector<std::size_t> stored = order.pages;
  order.slices = 1;
  for (const PageAxis& axis : axes) count_along(axis, order) *= axis.size;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    PlaneOrder at;  // of the page's slice, component and frame
    at.slices = at.components = at.frames = 0;
    std::size_t left = stored.size(), rest = i;
    for (const PageAxis& axis : axes) {
      left /= axis.size;
      std::size_t& place = count_along(axis, at);
      place = place * axis.size + rest / left;
      rest %= left;
    }
    order.pages[place_in(order, at.components, at.slices, at.frames)] = stored[i];
  }
  take_only_axis_as_slices(order);
  return order;
}

}  // namespace crest
