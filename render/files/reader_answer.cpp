#include "render/files/reader_answer.h"

#include <cmath>
#include <utility>

#include "presets/error.h"
#include "presets/printable.h"

namespace crest {
namespace {

Json triple(const auto& v) { return {v.x, v.y, v.z}; }

int integer(const Json& json) {
  if (!json.is_number_integer()) throw Error("a number that is not whole");
  const bool fits = json.is_number_unsigned() ? std::in_range<int>(json.get<std::uint64_t>())
                                              : std::in_range<int>(json.get<std::int64_t>());
  if (!fits) throw Error("a number that is too large");
  return json.get<int>();
}

double finite(const Json& json) {
  const double number = json.get<double>();
  if (!std::isfinite(number)) throw Error("a number that is none");
  return number;
}

glm::dvec3 vector_from(const Json& json) {
  return {finite(json.at(0)), finite(json.at(1)), finite(json.at(2))};
}

}  // namespace

Json volume_to_json(const Volume& volume) {
  Json json{{"dims", triple(volume.grid.dims)},
            {"spacing", triple(volume.grid.spacing)},
            {"origin", triple(volume.grid.origin)},
            {"type", int(volume.file_type)},
            {"note", volume.note}};
  if (volume.frames > 1) json["frame"] = {volume.frame, volume.frames};
  for (int column = 0; column < 3; ++column) json["direction"].push_back(triple(volume.direction[column]));
  return json;
}

Volume volume_from_json(const Json& json) {
  Volume volume;
  volume.grid.spacing = vector_from(json.at("spacing"));
  volume.grid.origin = vector_from(json.at("origin"));
  for (int axis = 0; axis < 3; ++axis) {
    volume.grid.dims[axis] = integer(json.at("dims").at(std::size_t(axis)));
    volume.direction[axis] = vector_from(json.at("direction").at(std::size_t(axis)));
    if (volume.grid.dims[axis] < 2 || volume.grid.spacing[axis] <= 0) throw Error("a grid that is none");
  }
  const int type = integer(json.at("type"));
  if (type < 0 || type > int(ScalarType::float16)) throw Error("a type that is none");
  volume.file_type = ScalarType(type);
  if (const auto frame = json.find("frame"); frame != json.end()) {
    volume.frame = integer(frame->at(0));
    volume.frames = integer(frame->at(1));
    if (volume.frame < 0 || volume.frame >= volume.frames) throw Error("a frame that is none");
  }
  constexpr std::size_t longest_note = 4000;  // the reader has made it shorter
  volume.note = printable(json.at("note").get<std::string>(), longest_note);
  return volume;
}

Json choice_to_json(const OpenChoice& choice) {
  Json json{{"kind", int(choice.kind)}, {"count", choice.count}, {"options", Json::array()}};
  for (const ChoiceOption& option : choice.options) json["options"].push_back({option.value, option.text});
  return json;
}

OpenChoice choice_from_json(const Json& json) {
  constexpr std::size_t longest_text = 200;  // of an option
  OpenChoice choice;
  const int kind = integer(json.at("kind"));
  if (kind <= int(ChoiceKind::raw_layout) || kind > int(ChoiceKind::series))
    throw Error("a choice that is none");
  choice.kind = ChoiceKind(kind);
  choice.count = json.at("count").get<std::uint64_t>();
  for (const Json& option : json.at("options"))
    choice.options.push_back(
        {option.at(0).get<std::string>(), printable(option.at(1).get<std::string>(), longest_text)});
  if (!choice.options.empty() && choice.options.size() != choice.count) throw Error("a choice that is none");
  return choice;
}

}  // namespace crest
