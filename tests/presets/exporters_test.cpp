#include "presets/exporters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "presets/error.h"
#include "tests/json.h"
#include "tests/presets/random_preset.h"

namespace crest {
namespace {

TransferFunction spike() {
  TransferFunction tf;
  tf.unit_distance = 4;
  tf.points.resize(5);
  for (std::size_t i = 0; i < 5; ++i) tf.points[i].value = i == 0 ? 0 : i == 4 ? 1 : 0.5;
  tf.points[2].opacity = 0.9;
  tf.points[2].color = {1, 0, 0};
  return tf;
}

TEST(Exporters, AreFoundByName) {
  for (const Exporter& exporter : exporters()) {
    EXPECT_EQ(find_exporter(exporter.name).name, exporter.name);
    EXPECT_EQ(exporter.extension[0], '.');
  }
  try {
    find_exporter("word");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "word: no such export format; there are: paraview, csv");
  }
}

TEST(ParaView, HoldsEveryPointExactly) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const TransferFunction tf = random_preset(random).transfer_function;
    const auto root = test::parse_json(find_exporter("paraview").write("Name", tf, {}));
    ASSERT_TRUE(root.is_array() && root.size() == 1);
    const auto& map = root[0];
    EXPECT_EQ(map["Name"], "Name");
    EXPECT_EQ(map["ColorSpace"], "RGB");
    const std::vector<double> colors = map["RGBPoints"], opacities = map["Points"];
    ASSERT_EQ(colors.size(), 4 * tf.points.size());
    ASSERT_EQ(opacities.size(), 4 * tf.points.size());
    for (std::size_t i = 0; i < tf.points.size(); ++i) {
      const ControlPoint& point = tf.points[i];
      const double* color = &colors[4 * i];
      const double* opacity = &opacities[4 * i];
      EXPECT_EQ(color[0], opacity[0]);
      EXPECT_EQ(glm::dvec3(color[1], color[2], color[3]), point.color);
      EXPECT_EQ(opacity[1], point.opacity);
      EXPECT_EQ(opacity[2], 0.5);
      EXPECT_EQ(opacity[3], 0);
      const bool shared = i + 1 < tf.points.size() && tf.points[i + 1].value == point.value;
      EXPECT_TRUE(shared || opacity[0] == point.value);
      EXPECT_LE(std::abs(opacity[0] - point.value), 1e-14 * std::abs(point.value) + 1e-300);
      EXPECT_TRUE(i == 0 || opacities[4 * i - 4] < opacity[0]) << "strictly increasing";
    }
  }
}

TEST(ParaView, TellsTheUnitDistance) {
  EXPECT_EQ(
      find_exporter("paraview").losses(spike(), {}),
      "the unit distance is not in the file: set ScalarOpacityUnitDistance of the representation to 4 world "
      "units\npoints that share a value are written one representable number apart\n");
  TransferFunction tf = default_transfer_function();
  tf.points[0].surface.mode = SurfaceMode::on;
  EXPECT_EQ(find_exporter("paraview").losses(tf, {}),
            "the unit distance is not in the file: set ScalarOpacityUnitDistance of the representation to 8 "
            "times the smallest spacing\nsurface settings are not in the file (points that have them: 1)\n");
}

TEST(Csv, HasTheTFAtEquidistantValues) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    TransferFunction tf = random_preset(random).transfer_function;
    const int samples = 2 + int(random() % 500);
    std::istringstream text(find_exporter("csv").write("", tf, {samples}));
    std::string line;
    std::getline(text, line);
    EXPECT_EQ(line, "value,red,green,blue,opacity,extinction");
    const double width = tf.range().width() > 0 ? tf.range().width() : 1;
    int rows = 0;
    for (double previous = -INFINITY; std::getline(text, line); ++rows) {
      std::istringstream fields(line);
      double numbers[6];
      for (double& number : numbers) {
        std::string field;
        ASSERT_TRUE(std::getline(fields, field, ','));
        number = std::stod(field);
      }
      EXPECT_NEAR(numbers[0], tf.range().min + width * rows / (samples - 1), 1e-14 * width);
      EXPECT_GE(numbers[0], previous);
      previous = numbers[0];
      const Classified expected = evaluate(tf, numbers[0]);
      EXPECT_EQ(glm::dvec3(numbers[1], numbers[2], numbers[3]), expected.color);
      EXPECT_EQ(numbers[4], expected.opacity);
      EXPECT_EQ(numbers[5], extinction(expected.opacity, tf.unit_distance));
    }
    EXPECT_EQ(rows, samples);
  }
}

TEST(Csv, TellsTheOpacityThatIsLost) {
  EXPECT_EQ(find_exporter("csv").losses(spike(), {11}),
            "11 rows are 0.1 apart: the opacity is off by up to 0.9 at the control points (at 0.5)\n"
            "peaks narrower than the distance of two rows: 1\n");
  EXPECT_EQ(find_exporter("csv").losses(default_transfer_function(), {2}), "");
}

TEST(Csv, RefusesTooFewAndTooManyRows) {
  for (const int samples : {-1, 0, 1, (1 << 20) + 1})
    EXPECT_THROW(find_exporter("csv").write("", spike(), {samples}), Error);
}

}  // namespace
}  // namespace crest
