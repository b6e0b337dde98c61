#include "presets/point_changes.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/names.h"
#include "presets/peaks.h"

namespace crest {
namespace {

constexpr std::size_t most_compared = 500'000;  // pairs of points

using Points = std::vector<ControlPoint>;

std::string number(double value) { return fmt::format("{:.6g}", value == 0 ? 0.0 : value); }

std::string count_of(std::size_t count) { return count == 1 ? "a point" : fmt::format("{} points", count); }

/// length(i, j): of the longest common subsequence of what is left from i and from j.
class CommonLengths {
 public:
  CommonLengths(const Points& a, std::size_t a_end, const Points& b, std::size_t b_end, std::size_t first)
      : first_(first), columns_(b_end - first + 1), lengths_((a_end - first + 1) * columns_) {
    for (std::size_t i = a_end; i-- > first;)
      for (std::size_t j = b_end; j-- > first;)
        at(i, j) = a[i] == b[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
  }
  int& at(std::size_t i, std::size_t j) { return lengths_[(i - first_) * columns_ + j - first_]; }

 private:
  std::size_t first_, columns_;
  std::vector<int> lengths_;
};

/// The one peak of which a point is among `which`; null where there are more, or none.
const Peak* only_peak(const std::vector<Peak>& peaks, const std::vector<std::size_t>& which) {
  const auto is_of = [&](const Peak& peak) {
    return std::ranges::find(which, peak.first_point) != which.end();
  };
  const auto found = std::ranges::find_if(peaks, is_of);
  return found == peaks.end() || std::any_of(found + 1, peaks.end(), is_of) ? nullptr : &*found;
}

/// "Move the peak at 50 to 55", "Move 3 points"; empty where none moves.
std::string sentence_of_moved(const PointAlignment& alignment, const TransferFunction& before,
                              const TransferFunction& after) {
  std::vector<std::size_t> from, to;
  for (const auto& [i, j] : alignment.changed)
    if (before.points[i].value != after.points[j].value) from.push_back(i), to.push_back(j);
  if (from.empty()) return "";
  const auto at = [](const char* what, double old_value, double value) {
    return fmt::format("Move the {} at {} to {}", what, number(old_value), number(value));
  };
  if (from.size() == 1) return at("point", before.points[from.front()].value, after.points[to.front()].value);
  const std::vector<Peak> old_peaks = find_peaks(before), new_peaks = find_peaks(after);
  const Peak *old_peak = only_peak(old_peaks, from), *new_peak = only_peak(new_peaks, to);
  if (old_peak && new_peak) return at(new_peak->spike ? "spike" : "peak", old_peak->value, new_peak->value);
  return fmt::format("Move {} points", from.size());
}

/// Of a member of the points, `text_of` its value; an empty text is not worth reading.
template <class T, class TextOf>
void add_sentence(std::vector<std::string>& sentences, const PointAlignment& alignment, const Points& before,
                  const Points& after, const char* what, T ControlPoint::*member, TextOf text_of) {
  std::vector<std::pair<std::size_t, std::size_t>> changed;
  for (const auto& [i, j] : alignment.changed)
    if (before[i].*member != after[j].*member) changed.emplace_back(i, j);
  if (changed.empty()) return;
  if (changed.size() > 1) {
    sentences.push_back(fmt::format("Change the {} of {} points", what, changed.size()));
    return;
  }
  const auto [i, j] = changed.front();
  const std::string from = text_of(before[i].*member), to = text_of(after[j].*member);
  const std::string values = to.empty() ? "" : fmt::format(" from {} to {}", from, to);
  sentences.push_back(fmt::format("Change the {} at {}{}", what, number(after[j].value), values));
}

std::string surface_text(const Surface& surface) {
  return fmt::format("{}{}", name_of(surface.mode),
                     surface.opacity ? ", opacity " + number(*surface.opacity) : std::string());
}

/// "Add a peak at 50" where that is what the points do.
std::string sentence_of_count(const char* verb, const std::vector<std::size_t>& which, const Points& points,
                              const std::vector<Peak>& peaks, std::size_t other_peaks) {
  if (peaks.size() == other_peaks + 1)
    for (const Peak& peak : peaks)
      if (std::ranges::find(which, peak.first_point) != which.end())
        return fmt::format("{} {} at {}", verb, peak.spike ? "a spike" : "a peak", number(peak.value));
  if (which.size() == 1) return fmt::format("{} the point at {}", verb, number(points[which.front()].value));
  return fmt::format("{} {}", verb, count_of(which.size()));
}

}  // namespace

PointAlignment align_points(const Points& before, const Points& after) {
  std::size_t first = 0, before_end = before.size(), after_end = after.size();
  while (first < before_end && first < after_end && before[first] == after[first]) ++first;
  while (before_end > first && after_end > first && before[before_end - 1] == after[after_end - 1])
    --before_end, --after_end;

  PointAlignment alignment;
  auto& [changed, removed, added] = alignment;
  std::size_t i = first, j = first;
  if ((before_end - first) * (after_end - first) <= most_compared) {
    CommonLengths common(before, before_end, after, after_end, first);
    while (i < before_end && j < after_end) {
      if (before[i] == after[j])
        ++i, ++j;
      else if (common.at(i + 1, j) >= common.at(i, j + 1))
        removed.push_back(i++);
      else
        added.push_back(j++);
    }
  }
  while (i < before_end) removed.push_back(i++);
  while (j < after_end) added.push_back(j++);
  if (removed.size() != added.size()) return alignment;
  for (std::size_t k = 0; k < removed.size(); ++k) changed.emplace_back(removed[k], added[k]);
  removed.clear();
  added.clear();
  return alignment;
}

std::vector<std::string> point_changes(const TransferFunction& before, const TransferFunction& after) {
  const Points &from = before.points, &to = after.points;
  const PointAlignment alignment = align_points(from, to);
  std::vector<std::string> sentences;
  if (!alignment.removed.empty() && !alignment.added.empty()) {
    sentences.push_back(
        fmt::format("Replace {} by {}", count_of(alignment.removed.size()),
                    alignment.added.size() == 1 ? "one" : fmt::format("{}", alignment.added.size())));
    return sentences;
  }
  const std::vector<Peak> old_peaks = find_peaks(before), new_peaks = find_peaks(after);
  if (!alignment.added.empty())
    sentences.push_back(sentence_of_count("Add", alignment.added, to, new_peaks, old_peaks.size()));
  if (!alignment.removed.empty())
    sentences.push_back(sentence_of_count("Delete", alignment.removed, from, old_peaks, new_peaks.size()));
  std::vector<std::string> opacities;
  add_sentence(opacities, alignment, from, to, "opacity", &ControlPoint::opacity, number);
  // A drag does both at once
  std::string moved = sentence_of_moved(alignment, before, after);
  if (!moved.empty())
    sentences.push_back(moved + (opacities.empty() ? "" : ", with its opacity"));
  else
    sentences.insert(sentences.end(), opacities.begin(), opacities.end());
  add_sentence(sentences, alignment, from, to, "colour", &ControlPoint::color,
               [](const glm::dvec3&) { return std::string(); });
  add_sentence(sentences, alignment, from, to, "surface", &ControlPoint::surface, surface_text);
  return sentences;
}

}  // namespace crest
