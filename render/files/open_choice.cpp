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
    case ChoiceKind::part:
      break;
  }
  return "";
}

ChoiceNeeded part_needed(const TooLarge& fault, const std::string& path, const Query& query) {
  OpenChoice choice{ChoiceKind::part, path, query, 0, {}};
  choice.need = fault.need;
  choice.memory = fault.memory;
  std::string text = fault.what();
  if (const auto part = part_that_fits(fault.need, fault.memory)) {
    MemoryNeed smaller = fault.need;
    smaller.part = *part;
    text += fmt::format("; ?stride={} would need {}", with_part({}, *part).at("stride"),
                        byte_text(*bytes_of(smaller)));
  } else if (fault.need.besides > fault.memory) {
    text += "; its file can only be read whole, so that no part of it needs less than that";
  } else {
    text += "; no stride makes it small enough, a box may (?crop=x0:x1,y0:y1,z0:z1)";
  }
  return {text, std::move(choice)};
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
