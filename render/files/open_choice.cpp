#include "render/files/open_choice.h"

#include <fmt/core.h>

namespace crest {

std::string_view key_of(ChoiceKind kind) {
  switch (kind) {
    case ChoiceKind::raw_layout:
      break;
    case ChoiceKind::component:
      return "component";
    case ChoiceKind::frame:
      return "frame";
    case ChoiceKind::array:
      return "array";
    case ChoiceKind::series:
      return "series";
  }
  return "";
}

std::string source_of(const std::string& path, const Query& query) {
  std::string source = path;
  for (const auto& [key, value] : query)
    source += fmt::format("{}{}={}", source.size() == path.size() ? '?' : '&', key, value);
  return source;
}

std::string chosen_source(const OpenChoice& choice, std::uint64_t i) {
  Query query = choice.query;
  query[std::string(key_of(choice.kind))] =
      i < choice.options.size() ? choice.options[std::size_t(i)].value : fmt::format("{}", i);
  return source_of(choice.path, query);
}

}  // namespace crest
