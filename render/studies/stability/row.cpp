#include "render/studies/stability/row.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest::stability {
namespace {

bool is_finite(const glm::vec4& p) {
  return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b) && std::isfinite(p.a);
}

Verdict verdict_of(const Row& row) {
  const bool drawn_rightly = row.claim.empty == (row.covered == 0);
  const bool most_compared = row.left_out <= most_left_out * row.covered;
  if (row.not_finite > 0 || !drawn_rightly || !most_compared) return Verdict::fail;
  if (row.measured <= row.claim.bound) return Verdict::pass;
  const bool within_limit = row.claim.limit && row.measured <= row.claim.limit->bound;
  return within_limit ? Verdict::limited : Verdict::fail;
}

}  // namespace

std::string_view name_of(Truth truth) {
  switch (truth) {
    case Truth::closed_form:
      return "closed form";
    case Truth::reference:
      return "exact reference";
    case Truth::invariance:
      return "invariance";
  }
  return "";
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::limited:
      return "limited";
    case Verdict::fail:
      return "FAIL";
  }
  return "";
}

void Worst::take(double measured, std::string_view where) {
  if (std::isnan(measured)) measured = std::numeric_limits<double>::infinity();
  if (!(measured > value)) return;
  value = measured;
  at = where;
}

Row judge(Claim claim, Worst measured, std::span<const Image> pictures, int left_out) {
  Row row;
  row.left_out = left_out;
  row.claim = std::move(claim);
  row.measured = measured.value;
  row.at = std::move(measured.at);
  row.picture = pictures.back();
  row.covered = row.claim.empty ? 0 : std::numeric_limits<int>::max();
  for (const Image& image : pictures) {
    const auto filled = int(std::ranges::count_if(image.pixels, [](const auto& p) { return p.a > 0; }));
    row.covered = row.claim.empty ? std::max(row.covered, filled) : std::min(row.covered, filled);
    row.not_finite += int(std::ranges::count_if(image.pixels, [](const auto& p) { return !is_finite(p); }));
  }
  row.verdict = verdict_of(row);
  return row;
}

}  // namespace crest::stability
