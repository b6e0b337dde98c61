#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "presets/preset.h"
#include "render/volume/filter.h"

namespace crest {

/// The exact answers: what a picture would be without any error of sampling.
enum class Answer {
  integral,                ///< the volume rendering integral of the TF
  crossings,               ///< the peaks at their crossings, nothing else
  integral_and_crossings,  ///< both
  base_and_crossings,      ///< the integral of the base TF, and the peaks at their crossings
};

/// "integral", "crossings", "integral+crossings", "base+crossings": as they are called in every report.
std::string_view name_of(Answer answer);

/// Of the scene's filters, those of which an answer depends: of what is integrated, and of the field in which
/// surfaces lie. Where it shows one of both, that one; the texture unit's linear filter is the exact one.
struct AnswerFilters {
  FieldFilter dvr, root;
  auto operator<=>(const AnswerFilters&) const = default;
};
AnswerFilters filters_of(Answer answer, const Rendering& rendering);

/// What the error of such a picture is measured against: DVR_ONLY the first, PEAK_ONLY the second, both the
/// third, PEAK_XOR_DVR in the split form the fourth, and in the paper's form the last two. The first of the
/// list is the one that `--engine reference` renders.
std::vector<Answer> answers_of(const Rendering& rendering);

/// Why a setting's pictures have none, as a clause; empty where they have.
std::string why_without_answer(const Rendering& rendering);

/// An exact answer, of the fields that these filters make: what errors are measured against.
struct ExactAnswer {
  ExactAnswer(Answer a, const AnswerFilters& f = {}) : answer(a), filters(f) {}  // the texture unit's field
  Answer answer;
  AnswerFilters filters;
  auto operator<=>(const ExactAnswer&) const = default;
};

/// "integral"; "integral (bspline)" where the field is not the trilinear one; "base+crossings (linear,
/// bspline)" where DVR has one field and surfaces another.
std::string name_of(const ExactAnswer& exact);

/// answers_of(), with the setting's own filters.
std::vector<ExactAnswer> exact_answers_of(const Rendering& rendering);

/// The setting with the filters of an exact answer.
Rendering with_filters(Rendering rendering, const AnswerFilters& filters);

}  // namespace crest
