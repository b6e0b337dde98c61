#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "files.h"
#include "presets/error.h"
#include "render/files/load.h"
#include "tests/paths.h"

namespace crest::test {
namespace {

namespace fs = std::filesystem;
using enum ScalarType;

/// The folder of real volumes, where there is one.
fs::path data_folder() {
  const char* folder = std::getenv("CREST_DATA");
  return folder ? fs::path(folder) : test::source_folder() / "../shared/data";
}

class RealVolumes : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(data_folder())) {
      GTEST_SKIP() << "the real volumes are not in " << data_folder() << " (set CREST_DATA to their folder)";
    }
  }
  static std::string path(const std::string& name) { return (data_folder() / name).string(); }
};

struct Known {
  const char* name;
  glm::ivec3 dims;
  ScalarType type;
  ValueRange range;
  glm::dvec3 spacing{1};
};

TEST_F(RealVolumes, AreReadAsTheyAreKnown) {
  const Known known[] = {
      {"aneurism.nrrd", {256, 256, 256}, uint8, {0, 255}},
      {"heptane.nii.gz", {302, 302, 302}, uint8, {0, 255}},
      {"bonsai.nii.gz", {256, 256, 256}, uint8, {0, 255}},
      {"engine.nii.gz", {256, 256, 128}, uint8, {0, 255}},
      {"boston_teapot.nrrd", {256, 256, 178}, uint8, {0, 255}},
      {"hydrogen_atom.nrrd", {128, 128, 128}, uint8, {0, 250}},
      {"tooth.nrrd", {103, 94, 161}, uint8, {0, 255}},
      {"fuel_64x64x64_uint8.raw", {64, 64, 64}, uint8, {0, 255}},
      {"neghip_64x64x64_uint8.raw", {64, 64, 64}, uint8, {0, 255}},
      {"nucleon.nrrd", {41, 41, 41}, uint8, {0, 249}},
      {"silicium_98x34x34_uint8.raw", {98, 34, 34}, uint8, {0, 255}},
      {"ironProt.vtk", {68, 68, 68}, uint8, {0, 255}},
      {"headsq/quarter.nhdr", {64, 64, 93}, int16, {0, 3926}, {3.2, 3.2, 1.5}},
      {"HeadMRVolume.mhd", {48, 62, 42}, uint8, {0, 255}, {4, 4, 4}},
      {"frogtissue.mhd", {500, 470, 136}, uint8, {0, 29}, {1, 1, 1.5}},
      {"cth_pressure_128x64x64_float32.nrrd", {128, 64, 64}, float32, {-23594520576.0, 112037625856.0}},
      {"3DCT_lung_baseline_small.mha", {57, 78, 64}, int16, {-1130, 1379}, {2.732, 2.732, 5}},
      {"mni152_icbm2009asym.nii.gz", {157, 197, 165}, uint8, {0, 255}},
      {"avg152T1_RL_nifti.nii.gz", {91, 109, 91}, uint8, {0, 255}, {2, 2, 2}},
  };
  for (const Known& expected : known) {
    SCOPED_TRACE(expected.name);
    const Volume volume = load_volume(path(expected.name));
    EXPECT_EQ(volume.grid.dims, expected.dims);
    EXPECT_EQ(volume.file_type, expected.type);
    EXPECT_EQ(volume.statistics.range, expected.range);
    EXPECT_LT(glm::distance(volume.grid.spacing, expected.spacing), 1e-6);
    EXPECT_EQ(volume.statistics.nan_count + volume.statistics.inf_count, 0u);
    if (volume.note != "its axes are turned, and shown as they are stored") {
      EXPECT_EQ(volume.note, "");
    }
  }
  // Its header's CompressedDataSize is too small by 2067 bytes, which hold the last megabyte.
  EXPECT_NEAR(load_volume(path("frogtissue.mhd")).statistics.mean, 0.384213767, 1e-8);
  const Volume lung = load_volume(path("3DCT_lung_baseline_small.mha"));
  EXPECT_LT(glm::distance(lung.grid.origin, glm::dvec3(-152.461, -148.986, -1432)), 1e-9);
}

TEST_F(RealVolumes, BothByteOrdersHoldTheSame) {
  const Volume big = load_volume(path("awkward/nifti/rii_big.nii.gz"));
  const Volume little = load_volume(path("awkward/nifti/rii_little.nii.gz"));
  EXPECT_EQ(big.grid.dims, glm::ivec3(64, 64, 21));
  EXPECT_EQ(big.grid, little.grid);
  EXPECT_EQ(big.values, little.values);
  EXPECT_NEAR(big.statistics.range.max, 18.5825, 1e-4);
}

TEST_F(RealVolumes, EveryAwkwardBallIsTheSameOrRefused) {
  const Volume ball =
      load_volume(path("awkward/pynrrd/BallBinary30x30x30.raw") + "?size=30x30x30&type=int16");
  const std::string refused[] = {"_bz2.nrrd", "_byteskip_minus_five.nhdr", "nifti.nhdr"};
  int read = 0;
  for (const auto& entry : fs::directory_iterator(data_folder() / "awkward/pynrrd")) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("BallBinary") || name.ends_with(".raw")) continue;
    SCOPED_TRACE(name);
    if (std::ranges::any_of(refused, [&](const std::string& end) { return name.ends_with(end); })) {
      expect_error(entry.path().string(), {name});
    } else {
      EXPECT_EQ(load_volume(entry.path().string()).values, ball.values);
      ++read;
    }
  }
  EXPECT_GE(read, 7);
}

TEST_F(RealVolumes, TheOtherAwkwardOnesAreReadOrRefusedClearly) {
  for (const char* folder : {"awkward/NRRD.jl-headers", "awkward/NRRD.jl-io", "awkward/pynrrd"}) {
    for (const auto& entry : fs::directory_iterator(data_folder() / folder)) {
      const std::string file = entry.path().string();
      SCOPED_TRACE(file);
      try {
        EXPECT_GT(load_volume(file).grid.point_count(), 7u);
      } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with(file + ": ")) << error.what();
      }
    }
  }
  expect_error(path("awkward/NRRD.jl-io/test_helix.nrrd"), {"7 components", "?component=0"});
  EXPECT_EQ(load_volume(path("awkward/NRRD.jl-io/test_helix.nrrd") + "?component=0").grid.dims,
            glm::ivec3(11, 12, 13));
  EXPECT_EQ(load_volume(path("awkward/NRRD.jl-io/units.nhdr")).grid.spacing, glm::dvec3(0.1, 0.2, 1));
}

}  // namespace
}  // namespace crest::test
