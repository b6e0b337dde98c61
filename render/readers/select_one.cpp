#include "render/readers/select_one.h"

#include <fmt/format.h>

#include "presets/error.h"
#include "render/readers/voxel_header.h"

namespace crest {

std::uint64_t select_one(const FileRequest& request, std::string_view key, std::uint64_t count,
                         std::string& note, const std::vector<std::string>& names) {
  if (count > 1 && !request.query.contains(key)) {
    constexpr std::size_t most_names = 32;
    const bool listed = !names.empty() && names.size() <= most_names;
    throw Error(fmt::format("{}: it has {} {}s{}, and a volume is one: take the first with ?{}=0",
                            request.name(), count, key,
                            listed ? fmt::format(" ({})", fmt::join(names, ", ")) : "", key));
  }
  const auto index =
      std::uint64_t(integer_in(request.name(), request.query, key, 0, 0, std::int64_t(count) - 1));
  if (count > 1) {
    add_note(note, fmt::format("{} {} of {} (counted from 0{}{})", key, index, count,
                               names.size() == count ? ": " : "", names.size() == count ? names[index] : ""));
  }
  return index;
}

}  // namespace crest
