#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/files/image.h"

namespace crest::stability {

/// What a measurement is held against.
enum class Truth {
  closed_form,  ///< worked out by hand, in double
  reference,    ///< the exact picture of render/reference
  invariance,   ///< another picture of the ray caster that must be the same
};
std::string_view name_of(Truth truth);  ///< "closed form", "exact reference", "invariance"

enum class Verdict { pass, limited, fail };
std::string_view name_of(Verdict verdict);  ///< "pass", "limited", "FAIL"

/// Where a bound cannot be kept: the larger one that is kept instead, why, and what the studio tells the
/// person who has such a scene.
struct Limit {
  double bound = 0;
  std::string why;
  std::vector<std::string> warnings;
};

/// What a row says before it is measured.
struct Claim {
  std::string name;      ///< the case, with its mode or other parameter
  std::string quantity;  ///< what is compared, with its unit
  double bound = 0;      ///< the largest that `measured` may be
  Truth truth = Truth::closed_form;
  std::optional<Limit> limit = {};
  bool empty = false;  ///< the true picture is empty
};

/// One row of the table.
struct Row {
  std::string group;
  Claim claim;
  double measured = 0;
  std::string at;      ///< the parameter at which it was measured, where it is the worst of several; or empty
  int not_finite = 0;  ///< pixels with a NaN or an Inf, in all of its pictures
  /// Pixels with alpha > 0 in the emptiest of its pictures; in the fullest, if they must be empty.
  int covered = 0;
  int left_out = 0;  ///< pixels that were not compared, since their rays nearly graze a surface
  Image picture;     ///< one of them, for the eye
  Verdict verdict = Verdict::fail;
};

/// The largest of several measurements, and where it was met. A NaN counts as infinite.
struct Worst {
  double value = 0;
  std::string at;
  void take(double measured, std::string_view where);
};

/// Of the pixels that show something, so many may be left out: a row that compares next to nothing fails.
inline constexpr double most_left_out = 0.05;

/// The verdict: `measured` keeps the bound (or the limit), no pixel of `pictures` is NaN or Inf, none of them
/// is empty unless the truth is, and few pixels were left out. At least one picture.
Row judge(Claim claim, Worst measured, std::span<const Image> pictures, int left_out = 0);

}  // namespace crest::stability
