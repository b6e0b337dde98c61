// Tables of equidistant values: ImageVis3D's and VisRTX's .1dt, and CSV.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "presets/error.h"
#include "presets/exchange/curves.h"
#include "presets/exchange/import_formats.h"
#include "presets/exchange/numbers_text.h"
#include "presets/exchange/table.h"

namespace crest {
namespace {

/// Rows are kept where they bend by more than what 32-bit text rounds to.
constexpr double kept = 1e-6;

struct Row {
  double value;
  std::array<double, 4> rgba;
};

Imported from_rows(const std::vector<Row>& rows, Domain domain) {
  if (rows.size() < 2) throw Error(fmt::format("has {} rows, where two are the least", rows.size()));
  TransferFunction tf;
  tf.domain = domain;
  for (const Row& row : rows) {
    if (!tf.points.empty() && row.value < tf.points.back().value)
      throw Error(
          fmt::format("its values are not ascending: {} comes after {}", row.value, tf.points.back().value));
    tf.points.push_back({.value = row.value,
                         .color = {row.rgba[0], row.rgba[1], row.rgba[2]},
                         .opacity = row.rgba[3],
                         .surface = {},
                         .unknown = {}});
  }
  Imported result;
  result.preset.transfer_function = simplified(tf, kept);
  return result;
}

std::array<double, 4> rgba_of(std::span<const double> numbers, std::size_t line) {
  std::array<double, 4> rgba;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(numbers[i] >= 0 && numbers[i] <= 1))
      throw Error(fmt::format("line {}: {} is not in [0, 1]", line, numbers[i]));
    rgba[i] = numbers[i];
  }
  return rgba;
}

/// Whether a line holds names and no number.
bool is_heading(std::string_view line) {
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(",; \t"), line.size());
    if (end > 0 && to_numbers(line.substr(0, end))) return false;
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return true;
}

}  // namespace

bool is_1dt(std::string_view, std::string_view extension) { return extension == ".1dt"; }

std::vector<Imported> read_1dt(std::string_view content) {
  std::vector<std::array<double, 4>> entries;
  double promised = -1;
  const std::vector<std::string_view> lines = lines_of(content);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto numbers = to_numbers(lines[i]);
    if (!numbers)
      throw Error(fmt::format("line {}: not numbers: {}", i + 1, std::string(lines[i].substr(0, 40))));
    if (numbers->empty()) continue;
    if (numbers->size() == 1 && promised < 0 && entries.empty()) {
      promised = numbers->front();
      continue;
    }
    if (numbers->size() != 4)
      throw Error(fmt::format("line {}: {} numbers, not red, green, blue, opacity", i + 1, numbers->size()));
    entries.push_back(rgba_of(*numbers, i + 1));
    if (entries.size() > most_table_rows) throw Error(fmt::format("has more than {} rows", most_table_rows));
  }
  if (promised >= 0 && promised != double(entries.size()))
    throw Error(fmt::format("says that it has {} rows, and has {}", promised, entries.size()));
  std::vector<Row> rows;
  for (std::size_t i = 0; i < entries.size(); ++i)
    rows.push_back({double(i) / double(std::max<std::size_t>(entries.size() - 1, 1)), entries[i]});
  Imported result = from_rows(rows, Domain::normalized);
  result.notes.emplace_back("the file says nothing of its values: its rows are laid over the volume's range");
  result.notes.emplace_back("no unit distance is in the file: one world unit is taken");
  if (promised < 0) result.notes.emplace_back("the count of rows is missing, as VisRTX writes it");
  return {std::move(result)};
}

bool is_csv(std::string_view, std::string_view extension) { return extension == ".csv"; }

// value, red, green, blue, opacity [, extinction]; or without the value
std::vector<Imported> read_csv(std::string_view content) {
  std::vector<Row> rows;
  bool has_value = true;
  double opacity = 0, extinction = 0;  // of the row from which the unit distance follows best
  if (content.starts_with("\xef\xbb\xbf")) content.remove_prefix(3);
  const std::vector<std::string_view> lines = lines_of(content);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto numbers = to_numbers(lines[i]);
    if (!numbers && i == 0 && is_heading(lines[i])) continue;
    if (!numbers)
      throw Error(fmt::format("line {}: not numbers: {}", i + 1, std::string(lines[i].substr(0, 40))));
    if (numbers->empty()) continue;
    if (numbers->size() < 4 || numbers->size() > 6)
      throw Error(
          fmt::format("line {}: {} numbers, not value, red, green, blue, opacity", i + 1, numbers->size()));
    const bool here = numbers->size() >= 5;
    if (!rows.empty() && here != has_value)
      throw Error(fmt::format("line {}: another number of columns", i + 1));
    has_value = here;
    const std::span<const double> all(*numbers);
    const double value = has_value ? all[0] : double(rows.size());
    rows.push_back({value, rgba_of(all.subspan(has_value ? 1 : 0, 4), i + 1)});
    if (rows.size() > most_table_rows) throw Error(fmt::format("has more than {} rows", most_table_rows));
    if (all.size() == 6 && all[4] < 0.999999 && all[4] > opacity && all[5] > 0) {
      opacity = all[4];
      extinction = all[5];
    }
  }
  if (!has_value)
    for (Row& row : rows) row.value /= double(std::max<std::size_t>(rows.size() - 1, 1));
  Imported result = from_rows(rows, has_value ? Domain::data : Domain::normalized);
  if (extinction > 0)
    result.preset.transfer_function.unit_distance = crest::extinction(opacity, 1) / extinction;
  else
    result.notes.emplace_back("no unit distance is in the file: one world unit is taken");
  if (!has_value)
    result.notes.emplace_back(
        "the file says nothing of its values: its rows are laid over the volume's range");
  return {std::move(result)};
}

}  // namespace crest
