#include "render/readers/select_one.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "render/readers/voxel_header.h"

namespace crest {
namespace {

/// "component 1: green".
std::vector<ChoiceOption> options_of(std::string_view key, const Names& names) {
  std::vector<ChoiceOption> options;
  for (std::size_t i = 0; i < names.size(); ++i)
    options.push_back({fmt::format("{}", i), fmt::format("{} {}: {}", key, i, names[i])});
  return options;
}

}  // namespace

Names colour_names(std::uint64_t components) {
  if (components == 3) return {"red", "green", "blue"};
  if (components == 4) return {"red", "green", "blue", "alpha"};
  return {};
}

Names complex_names() { return {"real part", "imaginary part"}; }

std::uint64_t select_one(const FileRequest& request, ChoiceKind kind, std::uint64_t count, std::string& note,
                         const Names& names) {
  const std::string_view key = key_of(kind);
  const bool named = !names.empty() && names.size() == count;
  if (count > 1 && !request.query.contains(key)) {
    constexpr std::size_t most_listed = 32;
    const std::string list =
        named && count <= most_listed ? fmt::format(" ({})", fmt::join(names, ", ")) : std::string();
    const std::string_view option = kind == ChoiceKind::frame ? " (or --frame 0)" : "";
    throw ChoiceNeeded(fmt::format("{}: it has {} {}s{}, and a volume is one: take the first with ?{}=0{}",
                                   request.name(), count, key, list, key, option),
                       {kind, request.name(), request.query, count,
                        named ? options_of(key, names) : std::vector<ChoiceOption>()});
  }
  const auto index =
      std::uint64_t(integer_in(request.name(), request.query, key, 0, 0, std::int64_t(count) - 1));
  if (count > 1) {
    add_note(note, fmt::format("{} {} of {} (counted from 0{}{})", key, index, count, named ? ": " : "",
                               named ? names[index] : ""));
  }
  return index;
}

std::uint64_t select_frame(const FileRequest& request, std::uint64_t count, Volume& volume,
                           const Names& names) {
  const std::uint64_t index = select_one(request, ChoiceKind::frame, count, volume.note, names);
  constexpr std::uint64_t most = std::numeric_limits<int>::max();
  volume.frames = int(std::clamp<std::uint64_t>(count, 1, most));
  volume.frame = int(std::min(index, most - 1));
  return index;
}

}  // namespace crest
