#include "render/classify/occupancy.h"

#include <gtest/gtest.h>

#include <random>

#include "render/classify/classification.h"
#include "render/classify/tf_table.h"
#include "tests/classify/tf_of.h"

namespace crest {
namespace {

/// Macrocells of these ranges.
Macrocells cells_of(const std::vector<ValueRange>& ranges) {
  Macrocells cells;
  cells.dims = {int(ranges.size()), 1, 1};
  for (const ValueRange& range : ranges) {
    cells.min.push_back(float(range.min));
    cells.max.push_back(float(range.max));
    cells.deviation.push_back(0);
  }
  return cells;
}

// What is called empty shows nothing, by the TF itself and its surfaces.
TEST(Occupancy, NeverLosesWhatShows) {
  std::mt19937 random(11);
  const auto unit = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  const ValueRange field{-3, 5};
  int empty = 0;
  for (int trial = 0; trial < 200; ++trial) {
    TransferFunction tf;
    for (double value = field.min - 1; value < field.max + 1; value += random() % 4 ? unit() : 1e-6) {
      tf.points.emplace_back();
      tf.points.back().value = value;
      tf.points.back().opacity = random() % 2 ? 0 : unit();
    }
    const Classification classification = classify(tf, field);
    std::vector<ValueRange> ranges;
    for (int i = 0; i < 50; ++i) {
      const double min = field.min + 8 * unit();
      ranges.push_back({double(float(min)), double(float(std::min(min + 0.5 * unit() * unit(), field.max)))});
    }
    const Occupancy by_tf = find_occupancy(cells_of(ranges), {.tf = &classification.tf}, field);
    const Occupancy by_peaks =
        find_occupancy(cells_of(ranges), {.surfaces = &classification.surfaces}, field);
    const Occupancy both = find_occupancy(
        cells_of(ranges), {.tf = &classification.tf, .surfaces = &classification.surfaces}, field);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      EXPECT_GE(by_tf.cells[i], largest_opacity(classification.tf, ranges[i]) > 0);
      for (const Peak& peak : classification.surfaces)
        EXPECT_GE(by_peaks.cells[i], peak.value >= ranges[i].min && peak.value <= ranges[i].max);
      EXPECT_EQ(both.cells[i], by_tf.cells[i] | by_peaks.cells[i]);
      empty += both.cells[i] == 0;
    }
  }
  EXPECT_GT(empty, 200) << "nothing was ever called empty";
}

TEST(Occupancy, OfASpikeIsTheCellsAroundItsValue) {
  const TransferFunction tf = tf_of({{0, 0}, {0.5, 0}, {0.5, 1}, {0.5, 0}, {1, 0}});
  const Classification classification = classify(tf, {0, 1});
  const Occupancy found =
      find_occupancy(cells_of({{0, 0.4}, {0.4, 0.6}, {0.6, 1}, {0.499, 0.4999}, {0.2, 0.2}}),
                     {.surfaces = &classification.surfaces}, {0, 1});
  EXPECT_EQ(found.cells, (std::vector<std::uint8_t>{0, 1, 0, 0, 0}));
  EXPECT_DOUBLE_EQ(found.share, 0.2);
}

// A table's entries reach beside what shows, but not beyond the table: there the TF is constant.
TEST(Occupancy, OfATableEndsWithIt) {
  const TransferFunction tf = tf_of({{0.1, 0}, {0.4, 0}, {0.5, 1}, {0.6, 0}, {0.8, 0}, {1, 1}});
  const TableBlur blur = tf_table_blur(tf, {0, 1}, 7);  // from 0.4 to 1
  EXPECT_NEAR(blur.width, 0.1, 1e-6);
  const Occupancy found =
      find_occupancy(cells_of({{0.0, 0.39}, {0.45, 0.46}, {0.62, 0.68}, {0.705, 0.71}, {0.715, 0.79}}),
                     {.tf = &tf, .blur = blur}, {0, 1});
  EXPECT_EQ(found.cells, (std::vector<std::uint8_t>{0, 1, 1, 1, 1}));
  const Occupancy exact = find_occupancy(
      cells_of({{0.0, 0.39}, {0.45, 0.46}, {0.62, 0.68}, {0.705, 0.71}, {0.715, 0.79}}), {.tf = &tf}, {0, 1});
  EXPECT_EQ(exact.cells, (std::vector<std::uint8_t>{0, 1, 0, 0, 0}));
}

TEST(Occupancy, HoldsForConstantFieldsAndCellsWithoutAValue) {
  const TransferFunction shows = tf_of({{0, 0.5}, {1, 0.5}}), clear = tf_of({{0, 0}, {1, 0}});
  const Macrocells cells = cells_of({{2, 2}, {1, -1}});
  EXPECT_EQ(find_occupancy(cells, {.tf = &shows}, {2, 2}).cells, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(find_occupancy(cells, {.tf = &clear}, {2, 2}).cells, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(find_occupancy(cells, {}, {2, 2}).share, 0);
}

// M = 2/m + 1, m being a macrocell's deviation by the volume's (Knoll et al. 2009, section 6.2).
TEST(StepMultiples, AreThePapers) {
  Macrocells cells = cells_of(std::vector<ValueRange>(6));
  cells.deviation = {4, 2, 1, 0.5, 0.25, 0};
  EXPECT_EQ(step_multiples(cells, 1), (std::vector<std::int8_t>{1, 2, 3, 5, 8, 8}));
}

}  // namespace
}  // namespace crest
