#include "render/readers/choose_array.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/files/open_choice.h"
#include "render/readers/voxel_header.h"

namespace crest {

namespace {

/// VTK's marks of points and cells that are hidden, or another piece's.
constexpr const char* ghosts = "vtkGhostType";

}  // namespace

std::size_t choose_array(const FileRequest& request, const std::vector<std::string>& all,
                         const std::string& active, std::string& note) {
  std::vector<std::string> names = all;
  const bool has_ghosts = names.size() > 1 && std::erase(names, ghosts) > 0 && !names.empty();
  if (!has_ghosts || request.query.contains("array")) names = all;
  const auto place_of = [&](const std::string& name) {
    return std::size_t(std::ranges::find(names, name) - names.begin());
  };
  const auto ask = [&](const std::string& text) {
    OpenChoice choice{ChoiceKind::array, request.name(), request.query, names.size(), {}};
    for (const std::string& name : names) choice.options.push_back({name, name});
    throw ChoiceNeeded(text, choice);
  };
  std::size_t chosen = names.size();
  if (const auto asked = request.query.find("array"); asked != request.query.end()) {
    chosen = place_of(asked->second);
    if (chosen == names.size()) {
      ask(fmt::format("{}: it has no array \"{}\"; it has {}", request.name(), asked->second,
                      fmt::join(names, ", ")));
    }
  } else {
    chosen = names.size() == 1 ? 0 : place_of(active);
  }
  if (chosen == names.size()) {
    ask(fmt::format("{}: it has {} arrays ({}), and a volume is one: take the first with ?array={}",
                    request.name(), names.size(), fmt::join(names, ", "), names.front()));
  }
  if (names.size() > 1)
    add_note(note, fmt::format("array {}, one of {}", names[chosen], fmt::join(names, ", ")));
  if (has_ghosts && names[chosen] != ghosts) add_note(note, fmt::format("what {} hides is shown", ghosts));
  return std::size_t(std::ranges::find(all, names[chosen]) - all.begin());
}

}  // namespace crest
