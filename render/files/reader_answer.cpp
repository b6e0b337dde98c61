#include "render/files/reader_answer.h"

#include <cmath>
#include <utility>

#include "presets/error.h"
#include "presets/printable.h"
#include "render/volume/voxel_store.h"

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

glm::u64vec3 counts_from(const Json& json) {
  glm::u64vec3 counts;
  for (int axis = 0; axis < 3; ++axis) {
    const int count = integer(json.at(std::size_t(axis)));
    if (count < 0) throw Error("a count that is none");
    counts[axis] = std::uint64_t(count);
  }
  return counts;
}

Json part_to_json(const GridPart& part) {
  return {{"full", triple(part.full)},
          {"first", triple(part.first)},
          {"end", triple(part.end)},
          {"stride", triple(part.stride)}};
}

GridPart part_from_json(const Json& json) {
  const GridPart part{counts_from(json.at("full")), counts_from(json.at("first")),
                      counts_from(json.at("end")), counts_from(json.at("stride"))};
  for (int axis = 0; axis < 3; ++axis) {
    if (part.stride[axis] < 1 || part.first[axis] >= part.end[axis] || part.end[axis] > part.full[axis])
      throw Error("a part that is none");
  }
  const glm::u64vec3 dims = part.dims();
  if (dims.x < 2 || dims.y < 2 || dims.z < 2) throw Error("a part that is no volume");
  return part;
}

ScalarType type_from(const Json& json) {
  const int type = integer(json);
  if (type < 0 || type > int(ScalarType::float16)) throw Error("a type that is none");
  return ScalarType(type);
}

}  // namespace

Json volume_to_json(const Volume& volume) {
  Json json{{"dims", triple(volume.grid.dims)},     {"spacing", triple(volume.grid.spacing)},
            {"origin", triple(volume.grid.origin)}, {"type", int(volume.file_type)},
            {"in_patient", volume.is_in_patient},   {"note", volume.note}};
  if (volume.frames > 1) json["frame"] = {volume.frame, volume.frames};
  for (int column = 0; column < 3; ++column) json["direction"].push_back(triple(volume.direction[column]));
  if (volume.part) json["part"] = part_to_json(*volume.part);
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
  volume.is_in_patient = json.at("in_patient").get<bool>();
  volume.file_type = type_from(json.at("type"));
  if (const auto part = json.find("part"); part != json.end()) volume.part = part_from_json(*part);
  if (volume.part && volume.part->dims() != glm::u64vec3(volume.grid.dims))
    throw Error("a part that is another one");
  if (const auto frame = json.find("frame"); frame != json.end()) {
    volume.frame = integer(frame->at(0));
    volume.frames = integer(frame->at(1));
    if (volume.frame < 0 || volume.frame >= volume.frames) throw Error("a frame that is none");
  }
  constexpr std::size_t longest_note = 4000;  // the reader has made it shorter
  volume.note = printable(json.at("note").get<std::string>(), longest_note);
  return volume;
}

Json stored_to_json(const Voxels& values) {
  constexpr ScalarType types[] = {ScalarType::float32, ScalarType::uint8, ScalarType::int8,
                                  ScalarType::uint16, ScalarType::int16};  // as Voxels::Stored has them
  if (values.are_floats()) return {};
  return {{"type", int(types[values.stored().index()])},
          {"slope", values.map().slope},
          {"intercept", values.map().intercept}};
}

StoredValues stored_from_json(const Json& line) {
  const auto stored = line.find("stored");
  if (stored == line.end() || stored->is_null()) return {};
  const StoredValues values{type_from(stored->at("type")),
                            {finite(stored->at("slope")), finite(stored->at("intercept"))}};
  if (!is_kept_as_stored(values.type)) throw Error("values that are not kept as they are stored");
  return values;
}

Json choice_to_json(const OpenChoice& choice) {
  Json json{{"kind", int(choice.kind)}, {"count", choice.count}, {"options", Json::array()}};
  for (const ChoiceOption& option : choice.options) json["options"].push_back({option.value, option.text});
  if (choice.need) {
    json["part"] = part_to_json(choice.need->part);
    json["bytes_per_point"] = choice.need->bytes_per_point;
    json["besides"] = choice.need->besides;
  }
  return json;
}

OpenChoice choice_from_json(const Json& json) {
  constexpr std::size_t longest_text = 200;  // of an option
  OpenChoice choice;
  const int kind = integer(json.at("kind"));
  if (kind <= int(ChoiceKind::raw_layout) || kind > int(ChoiceKind::part))
    throw Error("a choice that is none");
  choice.kind = ChoiceKind(kind);
  choice.count = json.at("count").get<std::uint64_t>();
  for (const Json& option : json.at("options"))
    choice.options.push_back(
        {option.at(0).get<std::string>(), printable(option.at(1).get<std::string>(), longest_text)});
  if (choice.kind == ChoiceKind::part)
    choice.need = {part_from_json(json.at("part")), json.at("bytes_per_point").get<std::uint64_t>(),
                   json.at("besides").get<std::uint64_t>()};
  if (!choice.options.empty() && choice.options.size() != choice.count) throw Error("a choice that is none");
  return choice;
}

}  // namespace crest
