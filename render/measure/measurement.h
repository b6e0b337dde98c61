#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "render/measure/image_error.h"
#include "render/reference/answer.h"

namespace crest {

/// Why a point of a sweep is measured, the most informative first.
enum class Why {
  coverage,  ///< each method at coarse steps
  target,    ///< between the steps that miss the target error and those that meet it
  front,     ///< beside a point that no other beats in both time and error
  rest,
  dominated,  ///< another method is surely both faster and closer
};
std::string_view name_of(Why why);

struct AnswerError {
  ExactAnswer answer;
  ImageError error;
};

/// One point of a sweep: a method at a step, what it cost, and how far it is from its exact answers.
struct Measurement {
  std::string method;  ///< Method::id
  double step = 0;     ///< in units of the smallest spacing; 0 for a method without one
  Why why = Why::coverage;

  /// Medians, by how much slower the anchor was in this group than in the first one: a busy machine is no
  /// slower method.
  double frame_ms = 0;                              ///< wall clock until the device has finished
  double device_ms = 0;                             ///< the device's own clock (GL_TIME_ELAPSED)
  std::vector<double> frame_ms_all, device_ms_all;  ///< as they were
  int group = 0;         ///< points of one group were timed turn by turn, with the anchor
  double anchor_ms = 0;  ///< what the sweep's first point took meanwhile: the machine's drift

  double samples_per_ray = 0;             ///< field evaluations, over all pixels of the picture
  double dvr_samples_per_ray = 0;         ///< those that DVR classified
  double crossings_per_ray = 0;           ///< composited
  double crossings_left_out_per_ray = 0;  ///< in steps with more than max_peaks

  std::vector<AnswerError> errors;  ///< against each exact answer of the method that is there

  /// Null where it is not measured against that answer.
  const ImageError* error_against(const ExactAnswer& answer) const;
};

/// What a method costs at once, beyond its frames.
struct MethodStart {
  std::string method;
  double step = 0;            ///< at which it was measured
  double first_frame_ms = 0;  ///< the first frame of a new renderer: uploads, tables, shaders, and the draw
  /// What an edit of the TF adds to the frame after it: peaks, tables, their upload. The median of edits of
  /// one point's colour, each drawn at one pixel, less the same without an edit; at least 0.
  double edit_ms = 0;
};

/// What a sweep leaves out, and why.
struct LeftOut {
  std::string what;  ///< a method's id, an answer's name, or "ID at step S"
  std::string why;
};

}  // namespace crest
