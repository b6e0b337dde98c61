#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "presets/json.h"
#include "program.h"
#include "render/files/image.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;

std::string float_bytes(const std::vector<float>& values) {
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

class BadVolume : public ProgramTest {
 protected:
  /// Refused by the command that tells about it and by the one that draws it.
  void expect_refused(const std::string& source, const Words& parts) {
    expect_error(1, {"info", source}, parts);
    expect_error(1, {"render", source, "-o", path("a.png")}, parts);
  }
  static std::string nrrd(const std::string& sizes, const std::string& type = "uint8") {
    return "NRRD0004\ntype: " + type + "\ndimension: 3\nsizes: " + sizes +
           "\nendian: little\nencoding: raw\n\n";
  }
  static std::string mha(const std::string& sizes) {
    return "ObjectType = Image\nNDims = 3\nDimSize = " + sizes +
           "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  }
  static std::string vtk(const std::string& sizes) {
    return "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS " + sizes +
           "\nORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 64\nSCALARS s unsigned_char 1\nLOOKUP_TABLE default\n";
  }
};

TEST_F(BadVolume, WhatIsCutOff) {
  const std::string voxels(63, 'x');
  expect_refused(write("a.nrrd", nrrd("4 4 4") + voxels), {"a.nrrd", "64", "63"});
  expect_refused(write("a.mha", mha("4 4 4") + voxels), {"a.mha", "64", "63"});
  expect_refused(write("a.vtk", vtk("4 4 4") + voxels), {"a.vtk", "64", "63"});
  expect_refused(write("a.raw", voxels) + "?size=4x4x4&type=uint8", {"a.raw", "64", "63"});
  expect_refused(write("a.nii", std::string(200, '\0')), {"a.nii"});
  expect_refused(write("a.nii.gz", "\x1f\x8b garbage"), {"a.nii.gz"});
  expect_refused(write("a.mrc", std::string(500, '\0')), {"a.mrc"});
  expect_refused(write("a.dcm", "DICM"), {"a.dcm"});
  expect_refused(write("a.tif", "II*"), {"a.tif"});
}

TEST_F(BadVolume, SizesOfZeroOneAndBeyondCounting) {
  for (const std::string sizes : {"0 4 4", "1 4 4", "4 4 1", "-4 4 4", "4294967296 4294967296 4294967296"}) {
    expect_refused(write("a.nrrd", nrrd(sizes) + std::string(64, 'x')), {"a.nrrd"});
    expect_refused(write("a.mha", mha(sizes) + std::string(64, 'x')), {"a.mha"});
    expect_refused(write("a.vtk", vtk(sizes) + std::string(64, 'x')), {"a.vtk"});
    std::string query = sizes;
    std::ranges::replace(query, ' ', 'x');
    expect_refused(write("a.raw", std::string(64, 'x')) + "?type=uint8&size=" + query, {"a.raw"});
  }
  expect_refused("builtin:sphere?n=1", {"n=1", "[2,"});
  expect_refused("builtin:sphere?n=1000000", {"builtin:sphere", "memory"});
}

TEST_F(BadVolume, UnknownTypes) {
  expect_refused(write("a.nrrd", nrrd("4 4 4", "quaternion") + std::string(64, 'x')), {"a.nrrd"});
  expect_refused(write("a.raw", std::string(64, 'x')) + "?size=4x4x4&type=uint9", {"uint9", "uint8"});
  expect_refused(path("a.raw") + "?type=uint8", {"unknown size", "?size="});
  expect_refused(path("a.raw"), {"unknown size", "sidecar"});
  expect_refused(write("a.xyz", "abc"), {"extension", ".nrrd", ".raw"});
}

TEST_F(BadVolume, GigabytesOfZeros) {
  std::filesystem::resize_file(write("z.nrrd", ""), std::uintmax_t(2) << 30);  // sparse
  expect_error(1, {"info", path("z.nrrd")}, {"z.nrrd"});
}

TEST_F(BadVolume, FoldersAndFilesThatAreNotThere) {
  std::filesystem::create_directory(path("folder.nrrd"));
  expect_refused(path("folder.nrrd"), {"folder.nrrd", "neither a DICOM series nor images"});
  expect_refused(path("missing.nrrd"), {"missing.nrrd", "no such file"});
  expect_refused("/dev/null", {"/dev/null"});
}

TEST_F(BadVolume, FilesOfManyFormatsAreRefusedInOneLine) {
  // What a reader's own library would print, it does not.
  for (const char* name : {"n.nhdr", "n.mhd", "n.mha", "n.nii", "n.vtk", "n.mrc", "n.dcm", "n.tif"})
    expect_error(1, {"info", write(name, "this is not a volume\nat all\n")}, {name});
}

TEST_F(BadVolume, EmptyVoxelsAreCountedAndNotShown) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  std::vector<float> values;
  for (int i = 0; i < 512; ++i) values.push_back(float(i % 8));
  values[0] = values[100] = values[511] = nan;
  values[200] = inf;
  values[300] = -inf;
  const std::string source = write("e.raw", float_bytes(values)) + "?size=8x8x8&type=float32";
  const auto info = json_of({"info", source});
  EXPECT_EQ(info["nan"], 3);
  EXPECT_EQ(info["inf"], 2);
  EXPECT_EQ(info["range"], nlohmann::json({0.0, 7.0}));
  for (const char* mode : {"both", "DVR_ONLY", "PEAK_ONLY", "PEAK_XOR_DVR"}) {
    output_of(
        {"render", source, "--preset", "onion", "--mode", mode, "--size", "32x32", "-o", path("e.exr")});
    const Image image = read_image(path("e.exr"));
    float most = 0;
    for (const glm::vec4& pixel : image.pixels)
      for (int channel = 0; channel < 4; ++channel) {
        ASSERT_TRUE(std::isfinite(pixel[channel])) << mode;
        most = std::max(most, pixel[channel]);
      }
    EXPECT_GT(most, 0.05F) << mode << ": nothing to be seen";
  }
}

TEST_F(BadVolume, NothingButNaNIsAnEmptyPicture) {
  const std::vector<float> values(64, std::numeric_limits<float>::quiet_NaN());
  const std::string source = write("n.raw", float_bytes(values)) + "?size=4x4x4&type=float32";
  EXPECT_EQ(json_of({"info", source})["nan"], 64);
  const Outcome outcome = run({"render", source, "--size", "16x16", "-o", path("n.exr")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "crest: note: No voxel has a value: all are NaN or infinite.\n");
  for (const glm::vec4& pixel : read_image(path("n.exr")).pixels) ASSERT_EQ(pixel, glm::vec4(0));
}

}  // namespace
}  // namespace crest::test
