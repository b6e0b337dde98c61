// ImageJ's files over 4 GB: one directory, and all images behind each other.
#include <fmt/core.h>

#include <fstream>

#include "files.h"
#include "imagej_head.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;

class ImageJ : public FileTest {};

TEST_F(ImageJ, ImagesBehindTheFirstAreRead) {
  const auto value = [](int i) { return 1000 + 7 * i; };
  for (const endian order : {endian::little, endian::big}) {
    std::string file =
        imagej_head(4, 3, order, "ImageJ=1.53t\nimages=10\nchannels=2\nslices=5\nspacing=3\nunit=um\n", 24);
    for (int i = 0; i < 120; ++i) append_value(file, value(i), uint16, order);
    const std::string path = write("s.tif", file);
    const Volume volume = load_volume(path + "?component=1");
    ASSERT_EQ(volume.grid.dims, glm::ivec3(4, 3, 5));
    EXPECT_EQ(volume.grid.spacing.z, 3);
    for (int i = 0; i < 60; ++i)
      EXPECT_EQ(volume.at(i % 4, i / 4 % 3, i / 12), float(value(12 * (2 * (i / 12) + 1) + i % 12)));
    expect_error(write("cut.tif", file.substr(0, file.size() - 30)), {"10 images", "has 8"});
  }
  const std::string one = imagej_head(4, 3, endian::little, "ImageJ=1.53t\nimages=10\nslices=10\n", 24);
  expect_error(write("one.tif", one + std::string(24, 'x')), {"one image"});
}

TEST_F(ImageJ, BeyondFourGigabytes) {
  constexpr int side = 1024, images = 2100;
  constexpr std::uint64_t image_bytes = 2ull * side * side;
  const std::string start =
      imagej_head(side, side, endian::big, fmt::format("ImageJ=1.53t\nimages={0}\nslices={0}\n", images),
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
