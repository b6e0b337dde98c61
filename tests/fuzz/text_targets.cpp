// What people type, and what the reader's program answers.
#include <fmt/core.h>

#include <cmath>

#include "presets/json_text.h"
#include "presets/number_text.h"
#include "presets/printable.h"
#include "render/files/raw_layout.h"
#include "render/files/reader_answer.h"
#include "render/volume/builtin.h"
#include "render/volume/query.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/target_list.h"

namespace crest::fuzz {

void read_typed_number(std::string_view input) {
  const TypedNumber typed = read_number(input);
  require(typed.number.has_value() == typed.wrong.empty(),
          "a text is a number, or something is wrong with it");
  if (typed.number) {
    require(std::isfinite(*typed.number), "a number is finite");
    require(read_number(exact_text(*typed.number)).number == typed.number, "an exact text reads back");
    require(std::isfinite(without_noise(*typed.number, *typed.number)), "a number without its noise is one");
  }
  const TypedEdit edit = read_edit(input);
  require(edit.edit.has_value() == edit.wrong.empty(), "a text is an edit, or something is wrong with it");
  if (edit.edit) (*edit.edit)(2.5);
}

std::vector<std::string> number_seeds() {
  return {"0.5", ".5", "1e-4", "1/2", "0,5", "+=2", "-=0.1", "*=1e3", "/=3", "-12345.678", "1 / 3"};
}

void read_printable(std::string_view input) {
  const std::string text = printable(input, 100);
  require(text.size() <= 100, "a text is cut");
  for (const char c : text)
    require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "no character controls a terminal");
  require(printable(text, 100) == text, "what is printable stays as it is");
}

std::vector<std::string> printable_seeds() {
  return {"plain",
          "\x1b]0;title\x07\x1b[31m",
          "lines\nand\ttabs\r\n",
          "\u00e4\u2603\U0001f600",
          "\u0085\u202e\u2066",
          "\xff\xc0\x80\xed\xa0\x80\xf4\x90\x80\x80",
          std::string(200, 'x')};
}

void read_query(std::string_view input) {
  likely_layouts(std::string(input), 64 * 64 * 64);
  query_from_name(std::string(input));
  const Query query = parse_query("file", input);
  const RawLayout layout = layout_of(query);
  require(layout_of(query_of(layout, query)) == layout, "the query of a layout says that layout");
  for (const RawLayout& mend : fit_of(layout, 123456).mends)
    require(fit_of(mend, 123456).fits, "what is offered fits");
  number_in("file", query, "subtract", 0, -1e9, 1e9);
  integer_in("file", query, "frame", 0, 0, 100);
  require_known_keys("file", query, "size,type,spacing,origin,endian,offset,subtract,frame,component,array");
}

std::vector<std::string> query_seeds() {
  return {"size=64x64x93&type=int16&spacing=3.2,3.2,1.5&endian=little",
          "size=256x256x128&type=uint8&origin=0,-1,2e3&offset=352", "component=0&frame=3",
          "array=T&subtract=1.7e8", "size=5x4x3&type=float64&endian=big"};
}

void read_builtin(std::string_view input) {
  constexpr std::uint64_t memory = 1 << 17;
  const Volume volume = make_builtin(input, memory);
  require(volume.values.size() == volume.grid.point_count(), "there is a value for each point");
  require(volume.values.size() * sizeof(float) <= memory, "no more memory is taken than is given");
}

std::vector<std::string> builtin_seeds() {
  std::vector<std::string> seeds;
  for (const Builtin& builtin : builtins()) {
    std::string query;  // "n=128 seed=1"
    for (std::size_t at = 0; at < builtin.parameters.size();) {
      const std::size_t end = std::min(builtin.parameters.find(' ', at), builtin.parameters.size());
      if (!builtin.parameters.substr(at).starts_with("n="))
        query += fmt::format("&{}", builtin.parameters.substr(at, end - at));
      at = end + 1;
    }
    seeds.push_back(fmt::format("{}?n=8{}", builtin.name, query));
  }
  return seeds;
}

void read_answer(std::string_view input) {
  const Json line = parse_json(input);
  try {  // what files/read_beside.h catches, too
    if (line.contains("choice")) {
      const OpenChoice choice = choice_from_json(line.at("choice"));
      require(choice_from_json(choice_to_json(choice)) == choice, "a choice is told as it is");
    }
    const Volume volume = volume_from_json(line.at("volume"));
    const Volume again = volume_from_json(volume_to_json(volume));
    require(again.grid == volume.grid && again.direction == volume.direction, "a grid is told as it is");
    require(again.file_type == volume.file_type && again.note == volume.note, "a note is told as it is");
  } catch (const Json::exception&) {
  }
}

std::vector<std::string> answer_seeds() {
  Volume volume;
  volume.grid = {{5, 4, 3}, {1, 2.5, 3}, {-10, 1e-3, 30}};
  volume.note = "first of 3 components";
  const OpenChoice choice{ChoiceKind::array, "", {}, 2, {{"a", "a, 3 components"}, {"b", "b"}}};
  return {Json{{"volume", volume_to_json(volume)}, {"values", 60}}.dump(),
          Json{{"error", "several"}, {"choice", choice_to_json(choice)}, {"volume", volume_to_json(volume)}}
              .dump()};
}

}  // namespace crest::fuzz
