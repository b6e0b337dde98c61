#include <fmt/core.h>

#include <cmath>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

class TextVoxels : public FileTest {
 protected:
  /// 2x2x2 voxels in each format that has text.
  std::vector<std::string> files(const std::string& numbers, bool whole) const {
    const std::string vtk = fmt::format(
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nORIGIN 0 0 0\n"
        "SPACING 1 1 1\nPOINT_DATA 8\nSCALARS s {} 1\nLOOKUP_TABLE default\n",
        whole ? "unsigned_char" : "float");
    const std::string mha = fmt::format(
        "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = {}\nBinaryData = False\n"
        "ElementDataFile = LOCAL\n",
        whole ? "MET_UCHAR" : "MET_FLOAT");
    const std::string nrrd = fmt::format(
        "NRRD0004\ntype: {}\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n", whole ? "uint8" : "float");
    return {write("a.vtk", vtk + numbers), write("a.mha", mha + numbers), write("a.nrrd", nrrd + numbers)};
  }
};

TEST_F(TextVoxels, NanAndInfAndWhatIsBeyondFloatAreCounted) {
  for (const std::string& file : files("0 nan 1 inf\n-Infinity 1e300 -0.1 1e-320\n", false)) {
    const Volume volume = load_volume(file);
    EXPECT_EQ(volume.statistics.nan_count, 1u) << file;
    EXPECT_EQ(volume.statistics.inf_count, 3u) << file;
    EXPECT_EQ(volume.values[2], 1.f);
    EXPECT_EQ(volume.values[5], INFINITY);
    EXPECT_EQ(volume.values[6], -0.1f);
    EXPECT_EQ(volume.values[7], 0.f);
  }
}

TEST_F(TextVoxels, WhatIsNoNumberIsRefusedWithItsPlace) {
  for (const char* word : {"0,5", "1D3", "abc", "1.5.2", "--1", "0x10", "1e"}) {
    for (const std::string& file : files(fmt::format("0 1 2\n3 {} 5 6 7\n", word), false))
      expect_error(file, {file, word, "voxel 4", "not a number"});
  }
  expect_error(files("0 1 2\n3 abc 5 6 7\n", false)[0], {"line 12"});
}

TEST_F(TextVoxels, AWordThatIsTooLongIsNotTakenInPieces) {
  for (const std::string& file : files("0 1 2\n3 " + std::string(10000, '1') + " 5 6 7\n", false))
    expect_error(file, {"111...", "voxel 4", "not a number"});
}

TEST_F(TextVoxels, WhatAnIntegerTypeHasNotIsCountedAndRefused) {
  for (const std::string& file : files("0 1 2 3 300 -1 1.5 255", true))
    expect_error(file, {"3 of its numbers", "uint8", "\"300\" at voxel 4"});
  for (const std::string& file : files("0 1 2 3 4.0 +5 1e2 255", true))
    EXPECT_EQ(load_volume(file).values[6], 100.f) << file;
}

TEST_F(TextVoxels, AnEarlyEndIsRefused) {
  for (const std::string& file : files("0.25 1 2 3 4 5 6", false))
    expect_error(file, {"promises 8", "has 7"});
}

TEST_F(TextVoxels, WordsAcrossBlocksAreWhole) {
  std::string numbers = "NRRD0004\ntype: float\ndimension: 3\nsizes: 100 100 30\nencoding: ascii\n\n";
  for (int i = 0; i < 300000; ++i) numbers += fmt::format("{} ", i % 1000 + 0.5);
  const Volume volume = load_volume(write("long.nrrd", numbers));
  for (std::size_t i = 0; i < volume.values.size(); ++i)
    ASSERT_EQ(volume.values[i], float(i % 1000) + 0.5f) << i;
}

}  // namespace
}  // namespace crest::test
