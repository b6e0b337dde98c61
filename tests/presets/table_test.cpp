#include "presets/exchange/table.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "tests/presets/export_inputs.h"
#include "tests/presets/random_tf.h"

namespace crest {
namespace {

TEST(Table, KeepsEachPeakInItsHeight) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 100; ++trial) {
    TransferFunction tf;
    const int peaks = 1 + int(random() % 5);
    std::uniform_real_distribution<double> unit(0, 1);
    tf.points.push_back(point(0, 0));
    for (int i = 0; i < peaks; ++i) {
      const double value = (i + 0.2 + 0.6 * unit(random)) / peaks, opacity = 0.2 + 0.8 * unit(random);
      for (const double o : {0.0, opacity, 0.0})
        tf.points.push_back(point(value + (tf.points.size() % 3 == 1   ? -1e-6
                                           : tf.points.size() % 3 == 0 ? 1e-6
                                                                       : 0),
                                  o));
    }
    tf.points.push_back(point(1, 0));
    std::ranges::stable_sort(tf.points, {}, &ControlPoint::value);
    for (const int count : {64, 256, 1001}) {
      const TfTable1d table = make_table(tf, {0, 1}, count);
      ASSERT_EQ(int(table.rows.size()), count);
      EXPECT_EQ(table.lost, 0);
      for (const ControlPoint& p : tf.points) {
        if (p.opacity == 0) continue;
        const auto row = std::size_t(std::lround(p.value * (count - 1)));
        EXPECT_EQ(table.rows[row].a, p.opacity) << "one entry, in full height";
        EXPECT_EQ(table.rows[row - 1].a, 0);
        EXPECT_EQ(table.rows[row + 1].a, 0);
      }
    }
  }
}

TEST(Table, SaysWhatIsLostInOneRow) {
  TransferFunction tf;
  for (const auto& [value, opacity] :
       {std::pair(0.0, 0.0), {0.5, 0.4}, {0.501, 0.0}, {0.502, 0.9}, {0.51, 0.0}, {1.0, 0.0}})
    tf.points.push_back(point(value, opacity));
  const TfTable1d table = make_table(tf, {0, 1}, 101);
  EXPECT_EQ(table.lost, 1);
  EXPECT_EQ(table.rows[50].a, 0.9) << "the higher one";
  ExportInput input = input_of(tf);
  input.rows = 101;
  EXPECT_TRUE(any_says(exported("1dt", input).losses, "1 peak is lost in the row of a higher one"));
}

TEST(Table, AutomaticRowsAreTheFewestThatHoldAllPoints) {
  TransferFunction tf;
  for (const auto& [value, opacity] : {std::pair(0.0, 0.0), {0.25, 0.8}, {0.75, 0.1}, {1.0, 0.3}})
    tf.points.push_back(point(value, opacity));
  EXPECT_EQ(fewest_rows(tf, {0, 1}), 5) << "its points lie on fourths";
  tf.points[1].value = 0.26;
  const int rows = fewest_rows(tf, {0, 1});
  EXPECT_LE(make_table(tf, {0, 1}, rows).largest_error, 1.0 / 255);
  EXPECT_GT(make_table(tf, {0, 1}, rows - 1).largest_error, 1.0 / 255);
  // What no table can hold - a step, a spike - is held by the row beside it
  EXPECT_LT(fewest_rows(spike(), {0, 1}), 100);
}

TEST(Csv, HoldsTheFunctionAtItsRows) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const TransferFunction tf = random_tf(random, 30);
    const double width = tf.range().width() > 0 ? tf.range().width() : 1;
    ExportInput input = input_of(tf);
    input.rows = 2 + int(random() % 50);
    std::istringstream lines(text_of("csv", input));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "value,red,green,blue,opacity,extinction");
    int rows = 0;
    for (; std::getline(lines, line); ++rows) {
      for (char& c : line)
        if (c == ',') c = ' ';
      std::istringstream text(line);
      double numbers[6];
      for (double& number : numbers) text >> number;
      const double value = tf.range().min + width * rows / (input.rows - 1);
      EXPECT_NEAR(numbers[0], value, 1e-14 * (std::abs(value) + width));
      EXPECT_NEAR(numbers[5], extinction(numbers[4], tf.unit_distance), 1e-12 * std::abs(numbers[5]));
      const bool has_peak = std::ranges::any_of(tf.points, [&](const ControlPoint& p) {
        return p.opacity == numbers[4] && std::abs(p.value - value) <= width / (input.rows - 1);
      });
      if (!has_peak) {
        EXPECT_NEAR(numbers[4], evaluate(tf, numbers[0]).opacity, 1e-9);
      }
    }
    EXPECT_EQ(rows, input.rows);
  }
}

TEST(Npy, HasAHeaderThatNumPyReads) {
  ExportInput input = input_of(spike());
  input.rows = 101;
  const std::string bytes = text_of("npy", input);
  ASSERT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length =
      std::size_t(static_cast<unsigned char>(bytes[8])) + 256 * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + length) % 64, 0u);
  EXPECT_EQ(bytes[10 + length - 1], '\n');
  EXPECT_EQ(bytes.substr(10, 52), "{'descr': '<f8', 'fortran_order': False, 'shape': (1");
  EXPECT_EQ(bytes.size(), 10 + length + 101 * 5 * sizeof(double));
  double middle[5];
  std::memcpy(middle, bytes.data() + 10 + length + 50 * sizeof middle, sizeof middle);
  EXPECT_EQ(middle[0], 0.5);
  EXPECT_EQ(middle[1], 1);
  EXPECT_EQ(middle[4], 0.9);
}

TEST(Png, IsARowOfSixteenBits) {
  ExportInput input = input_of(spike());
  input.rows = 101;
  const std::string file = text_of("png", input);
  ASSERT_EQ(file.substr(0, 8), std::string("\x89PNG\r\n\x1a\n", 8));
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(file[at + i]);
    return value;
  };
  EXPECT_EQ(number(16), 101u);
  EXPECT_EQ(number(20), 1u);
  std::string pixels(1 + 101 * 8, '\0');
  for (std::size_t at = 8; at < file.size(); at += 12 + number(at)) {
    const std::uint32_t size = number(at);
    EXPECT_EQ(number(at + 8 + size), crc32(0, reinterpret_cast<const Bytef*>(&file[at + 4]), size + 4));
    if (file.substr(at + 4, 4) != "IDAT") continue;
    uLongf length = uLongf(pixels.size());
    ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(pixels.data()), &length,
                         reinterpret_cast<const Bytef*>(&file[at + 8]), size),
              Z_OK);
    EXPECT_EQ(length, pixels.size());
  }
  const std::size_t middle = 1 + 50 * 8;
  const auto channel = [&](std::size_t c) {
    return 256 * static_cast<unsigned char>(pixels[middle + 2 * c]) +
           static_cast<unsigned char>(pixels[middle + 2 * c + 1]);
  };
  EXPECT_EQ(channel(0), 65535);
  EXPECT_EQ(channel(1), 0);
  EXPECT_EQ(channel(3), std::lround(0.9 * 65535));
}

TEST(F3d, WritesTwoStripsAndTheCommandLine) {
  ExportInput input = input_of(spike());
  input.volume = ExportVolume{.file = "/data/a b.nrrd", .name = "v", .range = {-1, 1}, .raw = {}};
  const Exported result = exported("f3d", input);
  ASSERT_EQ(result.files.size(), 3u);
  EXPECT_NE(result.files[0].content.find("--coloring-range=-1,1"), std::string::npos);
  EXPECT_NE(result.files[0].content.find("\"$here\"/'file-opacity.png'"), std::string::npos);
  EXPECT_EQ(result.files[1].suffix, "-colors.png");
  EXPECT_TRUE(any_says(result.losses, "1 world unit in place of 4"));
}

// Names and paths hold what they like; none of it is run.
TEST(F3d, NamesAndPathsAreNoCode) {
  ExportInput input = input_of(spike());
  input.name = "x\ntouch /tmp/owned #";
  input.stem = "$(touch stem)'";
  input.volume = ExportVolume{.file = "/data/`touch path`}\"", .name = "v", .range = {0, 1}, .raw = {}};
  const std::string text = text_of("f3d", input);
  EXPECT_EQ(text.find("\ntouch"), text.npos);
  EXPECT_NE(text.find("volume='/data/`touch path`}\"'"), text.npos) << text;
  EXPECT_NE(text.find("'$(touch stem)'\\''-colors.png'"), text.npos) << text;
}

TEST(Table, KeepsAPlateauAndATipThatIsThereTwice) {
  for (const double width : {1e-6, 0.0}) {
    TransferFunction tf;
    for (const auto& [value, opacity] :
         {std::pair(0.0, 0.0), {0.5, 0.0}, {0.5, 0.9}, {0.5 + width, 0.9}, {0.5 + width, 0.0}, {1.0, 0.0}})
      tf.points.push_back(point(value, opacity));
    const TfTable1d table = make_table(tf, {0, 1}, 256);
    EXPECT_EQ(std::ranges::count(table.rows, 0.9, [](const glm::dvec4& row) { return row.a; }), 1) << width;
    EXPECT_EQ(table.widened, 1);
  }
}

}  // namespace
}  // namespace crest
