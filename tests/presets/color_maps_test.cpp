#include "presets/exchange/color_maps.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include "presets/peaks.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

const ColorMap& named(const std::vector<ColorMap>& maps, std::string_view name) {
  return *std::ranges::find(maps, name, &ColorMap::name);
}

// Numbers that their authors published.
TEST(ColorMaps, HaveTheirPublishedColours) {
  const auto maps = color_maps();
  for (const ColorMap& map : maps) {
    EXPECT_FALSE(map.source.empty()) << map.name;
    EXPECT_TRUE(map.distinct.size() > 4 || map.colors.points.size() >= 2) << map.name;
  }
  const auto expect = [&](const char* name, double place, glm::dvec3 color) {
    const glm::dvec3 found = evaluate(named(maps, name).colors, place).color;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], color[i], 1.0 / 255) << name << ' ' << place;
  };
  expect("viridis", 0, {0.267004, 0.004874, 0.329415});
  expect("viridis", 128 / 255.0, {0.127568, 0.566949, 0.550556});
  expect("inferno", 1, {0.988362, 0.998364, 0.644924});
  expect("cividis", 0, {0, 0.135112, 0.304751});
  expect("cool to warm", 0.5, {0.8654, 0.8654, 0.8654});
  expect("CT bone", 641.385, {0.905882, 0.815686, 0.552941});
  EXPECT_EQ(named(maps, "Set1").distinct.size(), 9u);
}

TEST(ColorMaps, LeaveOpacitiesAlone) {
  for (const LibraryPreset& entry : library()) {
    const TransferFunction tf = parse_preset(entry.text, entry.name).transfer_function;
    for (const ColorMap& map : color_maps()) {
      TransferFunction colored = with_color_map(tf, map, {-1000, 3000});
      ASSERT_EQ(colored.points.size(), tf.points.size());
      for (std::size_t i = 0; i < tf.points.size(); ++i) {
        const double value = tf.points[i].value;
        const double place =
            map.in_data_values ? -1000 + 4000 * value
                               : (value - tf.range().min) / (tf.range().width() > 0 ? tf.range().width() : 1);
        const glm::dvec3 off = glm::abs(colored.points[i].color - evaluate(map.colors, place).color);
        if (map.distinct.empty()) {
          EXPECT_LT(std::max({off.r, off.g, off.b}), 1e-9) << entry.name << ' ' << map.name;
        }
        colored.points[i].color = tf.points[i].color;
      }
      EXPECT_EQ(colored, tf) << entry.name << ' ' << map.name;
    }
  }
}

TEST(ColorMaps, QualitativeOnesGiveEachPeakItsOwn) {
  const auto maps = color_maps();
  const TransferFunction tf = load_preset("four-peaks").transfer_function;
  const auto peaks = find_peaks(with_color_map(tf, named(maps, "Set1"), {}));
  ASSERT_EQ(peaks.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(peaks[i].color, named(maps, "Set1").distinct[i]);
}

}  // namespace
}  // namespace crest
