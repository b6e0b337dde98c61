#include "render/reference/answer.h"

#include <fmt/core.h>

#include "presets/choices.h"
#include "presets/names.h"

namespace crest {

std::string_view name_of(Answer answer) {
  switch (answer) {
    case Answer::integral:
      return "integral";
    case Answer::crossings:
      return "crossings";
    case Answer::integral_and_crossings:
      return "integral+crossings";
    case Answer::base_and_crossings:
      return "base+crossings";
  }
  return "";
}

AnswerFilters filters_of(Answer answer, const Rendering& rendering) {
  AnswerFilters filters{dvr_filter(rendering), root_filter(rendering)};
  if (answer == Answer::integral) filters.root = filters.dvr;
  if (answer == Answer::crossings) filters.dvr = filters.root;
  for (FieldFilter* filter : {&filters.dvr, &filters.root})
    if (filter->kind == Filter::linear_exact) filter->kind = Filter::linear;
  return filters;
}

std::vector<Answer> answers_of(const Rendering& rendering) {
  switch (rendering.mode) {
    case Mode::dvr_only:
      return {Answer::integral};
    case Mode::peak_only:
      return {Answer::crossings};
    case Mode::both:
      return {Answer::integral_and_crossings};
    case Mode::peak_xor_dvr:
      break;
  }
  if (is_divided(rendering)) return {Answer::base_and_crossings};
  return {Answer::integral_and_crossings, Answer::base_and_crossings};
}

std::string why_without_answer(const Rendering& rendering) {
  if (rendering.blend_mode == BlendMode::semi_transparent) return "";
  return fmt::format(
      "rendering.illumination is {}, which has no exact answer to measure against: only semi_transparent has "
      "one",
      name_of(rendering.blend_mode));
}

std::string name_of(const ExactAnswer& exact) {
  const std::string_view answer = name_of(exact.answer), dvr = name_of(exact.filters.dvr.kind),
                         root = name_of(exact.filters.root.kind);
  if (exact.filters == AnswerFilters{}) return std::string(answer);
  return dvr == root ? fmt::format("{} ({})", answer, dvr) : fmt::format("{} ({}, {})", answer, dvr, root);
}

std::vector<ExactAnswer> exact_answers_of(const Rendering& rendering) {
  std::vector<ExactAnswer> exact;
  for (const Answer answer : answers_of(rendering)) exact.emplace_back(answer, filters_of(answer, rendering));
  return exact;
}

Rendering with_filters(Rendering rendering, const AnswerFilters& filters) {
  rendering.filter = filters.dvr.kind;
  rendering.root_filter = filters.root.kind;
  for (const FieldFilter& filter : {filters.dvr, filters.root})
    if (filter.kind == Filter::bc) {
      rendering.bc_b = filter.b;
      rendering.bc_c = filter.c;
    }
  return rendering;
}

}  // namespace crest
