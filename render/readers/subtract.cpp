#include "render/readers/subtract.h"

#include <fmt/core.h>

#include "render/readers/voxel_header.h"

namespace crest {

LinearMap subtracted(const FileRequest& request, LinearMap map, std::string& note) {
  constexpr double most = 1e300;
  const double amount = number_in(request.name(), request.query, "subtract", 0, -most, most);
  if (amount != 0) add_note(note, fmt::format("{} is subtracted from all values", amount));
  map.intercept -= amount;
  return map;
}

}  // namespace crest
