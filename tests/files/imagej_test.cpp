// ImageJ's files over 4 GB: one directory, and all images behind each other.
#include <fmt/core.h>

#include <array>
#include <fstream>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;

/// Before the pixels: the directory of one image of 16 bits, whose strip is said to be `strip_bytes` long.
std::string head(int width, int height, endian order, const std::string& description, double strip_bytes) {
  const bool big = order == endian::big;
  std::string out = big ? std::string("MM\0*", 4) : std::string("II*\0", 4);
  const auto put = [&](double value, ScalarType type) { append_value(out, value, type, order); };
  constexpr std::size_t entries = 10, directory = 8, text_at = directory + 2 + 12 * entries + 4;
  const double pixels_at = double((text_at + description.size() + 2) / 2 * 2);
  put(directory, uint32);
  put(entries, uint16);
  for (const auto& [tag, type, count, value] :
       std::initializer_list<std::array<double, 4>>{{256, 4, 1, double(width)},
                                                    {257, 4, 1, double(height)},
                                                    {258, 3, 1, 16},
                                                    {259, 3, 1, 1},
                                                    {262, 3, 1, 1},
                                                    {270, 2, double(description.size() + 1), double(text_at)},
                                                    {273, 4, 1, pixels_at},
                                                    {277, 3, 1, 1},
                                                    {278, 4, 1, double(height)},
                                                    {279, 4, 1, strip_bytes}}) {
    put(tag, uint16);
    put(type, uint16);
    put(count, uint32);
    put(value, type == 3 ? uint16 : uint32);
    if (type == 3) put(0, uint16);
  }
  put(0, uint32);
  out += description;
  out.resize(std::size_t(pixels_at), '\0');
  return out;
}

class ImageJ : public FileTest {};

TEST_F(ImageJ, ImagesBehindTheFirstAreRead) {
  const auto value = [](int i) { return 1000 + 7 * i; };
  for (const endian order : {endian::little, endian::big}) {
    std::string file =
        head(4, 3, order, "ImageJ=1.53t\nimages=10\nchannels=2\nslices=5\nspacing=3\nunit=um\n", 24);
    for (int i = 0; i < 120; ++i) append_value(file, value(i), uint16, order);
    const std::string path = write("s.tif", file);
    const Volume volume = load_volume(path + "?component=1");
    ASSERT_EQ(volume.grid.dims, glm::ivec3(4, 3, 5));
    EXPECT_EQ(volume.grid.spacing.z, 3);
    for (int i = 0; i < 60; ++i)
      EXPECT_EQ(volume.at(i % 4, i / 4 % 3, i / 12), float(value(12 * (2 * (i / 12) + 1) + i % 12)));
    expect_error(write("cut.tif", file.substr(0, file.size() - 30)), {"10 images", "has 8"});
  }
  const std::string one = head(4, 3, endian::little, "ImageJ=1.53t\nimages=10\nslices=10\n", 24);
  expect_error(write("one.tif", one + std::string(24, 'x')), {"one image"});
}

TEST_F(ImageJ, BeyondFourGigabytes) {
  constexpr int side = 1024, images = 2100;
  constexpr std::uint64_t image_bytes = 2ull * side * side;
  const std::string start =
      head(side, side, endian::big, fmt::format("ImageJ=1.53t\nimages={0}\nslices={0}\n", images),
           double(images * image_bytes % (1ull << 32)));
  const std::string path = write("large.tif", start);
  std::filesystem::resize_file(path, start.size() + images * image_bytes);  // of which little is on the disk
  {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    for (int k = images - 3; k < images; ++k) {
      std::string row;
      for (int i = 0; i < side; ++i) append_value(row, 10 * k + i, uint16, endian::big);
      file.seekp(std::streamoff(start.size() + std::uint64_t(k) * image_bytes));
      file.write(row.data(), std::streamsize(row.size()));
    }
  }
  const Volume volume = load_volume(path + fmt::format("?crop=0:5,0:2,{}:", images - 3));
  ASSERT_EQ(volume.grid.dims, glm::ivec3(5, 2, 3));
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(volume.at(4, 0, k), float(10 * (images - 3 + k) + 4));
    EXPECT_EQ(volume.at(4, 1, k), 0.f);
  }
}

}  // namespace
}  // namespace crest::test
