#include <OpenImageIO/imageio.h>
#include <fmt/core.h>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

class StackTest : public FileTest {
 protected:
  /// Pages of 4x3 pixels whose value at (x, y) is 100 page + 10 y + x + channel / 4, in one file.
  std::string write_image(const std::string& name, OIIO::TypeDesc type, int first_page, int pages,
                          int channels = 1, int width = 4) const {
    const std::string file = write(name, "");
    const auto out = OIIO::ImageOutput::create(file);
    const OIIO::ImageSpec spec(width, 3, channels, type);
    const double unit = type == OIIO::TypeUInt8 ? 255 : type == OIIO::TypeUInt16 ? 65535 : 1;
    for (int page = 0; page < pages; ++page) {
      EXPECT_TRUE(
          out->open(file, spec, page == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage));
      std::vector<double> pixels;
      for (int i = 0; i < width * 3; ++i) {
        for (int c = 0; c < channels; ++c) {
          pixels.push_back((100 * (first_page + page) + 10 * (i / width) + i % width + 0.25 * c) / unit);
        }
      }
      EXPECT_TRUE(out->write_image(OIIO::TypeDesc::DOUBLE, pixels.data()));
    }
    out->close();
    return file;
  }
};

TEST_F(StackTest, FolderIsSortedAsAPersonCounts) {
  for (const int page : {0, 1, 2, 9, 10, 11}) {
    write_image(fmt::format("stack/slice{}.png", page), OIIO::TypeUInt16, page, 1);
  }
  write("stack/notes.txt", "not an image");
  const Volume volume = load_volume(path("stack") + "?spacing=0.5,0.5,2&origin=1,2,3");
  EXPECT_EQ(volume.grid, (Grid{{4, 3, 6}, {0.5, 0.5, 2}, {1, 2, 3}}));
  EXPECT_EQ(volume.file_type, ScalarType::uint16);
  const int pages[] = {0, 1, 2, 9, 10, 11};
  for (int k = 0; k < 6; ++k) EXPECT_EQ(volume.at(3, 2, k), float(100 * pages[k] + 23));
  EXPECT_EQ(volume.name, "stack");
  EXPECT_EQ(load_volume(path("stack") + "/").name, "stack");
}

TEST_F(StackTest, ANumbersLeadingZerosDoNotCount) {
  const char* names[] = {"1", "02", "003", "10", "0011"};
  for (int page = 0; page < 5; ++page)
    write_image(fmt::format("zeros/slice{}.png", names[page]), OIIO::TypeUInt16, page, 1);
  const Volume volume = load_volume(path("zeros"));
  ASSERT_EQ(volume.grid.dims.z, 5);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(volume.at(3, 2, k), float(100 * k + 23)) << "slice" << names[k];
}

TEST_F(StackTest, MultiPageTiffKeepsItsNumbers) {
  for (const OIIO::TypeDesc& type :
       {OIIO::TypeUInt16, OIIO::TypeFloat, OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE)}) {
    const Volume volume = load_volume(write_image("pages.tif", type, 1, 5));
    EXPECT_EQ(volume.grid.dims, glm::ivec3(4, 3, 5));
    for (int k = 0; k < 5; ++k) EXPECT_EQ(volume.at(2, 1, k), float(100 * (k + 1) + 12)) << type.c_str();
  }
  const Volume bytes = load_volume(write_image("BYTES.TIFF", OIIO::TypeUInt8, 0, 3));
  EXPECT_EQ(bytes.file_type, ScalarType::uint8);
  EXPECT_EQ(bytes.at(3, 2, 2), 223);
}

TEST_F(StackTest, ColourIsTakenByComponent) {
  const std::string file = write_image("rgb.tif", OIIO::TypeFloat, 1, 2, 3);
  expect_error(file, {"3 components (red, green, blue)", "?component=0"});
  const Volume volume = load_volume(file + "?component=2");
  EXPECT_EQ(volume.at(1, 1, 1), 211.5f);
  EXPECT_NE(volume.note.find("component 2 of 3"), std::string::npos);
}

TEST_F(StackTest, WhatIsNoStackIsSaid) {
  expect_error(write_image("one.tif", OIIO::TypeUInt8, 0, 1), {"one image", "multi-page"});
  expect_error(write("bad.tif", "II*\0 nonsense"), {path("bad.tif")});
  write_image("odd/a.png", OIIO::TypeUInt8, 0, 1);
  expect_error(path("odd"), {"axis 3 has 1 points"});
  write_image("odd/b.png", OIIO::TypeUInt8, 0, 1, 1, 5);
  expect_error(path("odd"), {"b.png", "5x3", "4x3"});
  std::filesystem::create_directory(path("empty"));
  expect_error(path("empty"), {"neither a DICOM series nor images"});
  expect_error(path("odd") + "?colour=1", {"colour"});
}

TEST_F(StackTest, AnImageInTwoFormatsIsRefused) {
  for (int page = 0; page < 2; ++page)
    for (const char* format : {"png", "tif"})
      write_image(fmt::format("twice/s{}.{}", page, format), OIIO::TypeUInt16, page, 1);
  expect_error(path("twice"), {"s0.tif", "has s0.png too"});
}

TEST_F(StackTest, TheImageThatOthersDifferFromIsNamed) {
  write_image("f/overview.png", OIIO::TypeUInt16, 0, 1, 1, 5);
  for (int page = 0; page < 2; ++page) write_image(fmt::format("f/s{}.png", page), OIIO::TypeUInt16, page, 1);
  expect_error(path("f"), {"s0.png", "4x3", "the first, overview.png, is 5x3"});
}

TEST_F(StackTest, TruncatedImagesAreErrors) {
  for (const char* name : {"t.tif", "s/1.tif"}) {
    const std::string file = write_image(name, OIIO::TypeUInt16, 0, name[0] == 't' ? 2 : 1, 1, 100);
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  }
  expect_error(path("t.tif"), {path("t.tif")});
  write_image("s/2.tif", OIIO::TypeUInt16, 0, 1, 1, 100);
  expect_error(path("s"), {"1.tif"});
}

TEST_F(StackTest, TooLittleMemoryIsRefused) {
  const std::string file = write_image("pages.tif", OIIO::TypeUInt16, 1, 5);
  EXPECT_THROW(load_volume(file, {.memory = 4 * 3 * 5 * 2}), std::exception);
  EXPECT_NO_THROW(load_volume(file, {.memory = 4 * 3 * 5 * 8}));
}

}  // namespace
}  // namespace crest::test
