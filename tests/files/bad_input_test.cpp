#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

namespace fs = std::filesystem;
using enum ScalarType;
using std::endian;

class BadInput : public FileTest {};

/// `text` with the first `from` replaced; the header must hold it.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(BadInput, WhatIsNotThereOrNotAFile) {
  expect_error(path("missing.nrrd"), {path("missing.nrrd"), "no such file"});
  expect_error(path("missing.nrrd") + "?component=0", {path("missing.nrrd"), "no such file"});
  expect_error("", {"no such file"});
  fs::create_directory(path("folder.nrrd"));
  expect_error(path("folder.nrrd"), {"folder", "neither a DICOM series nor images"});
  expect_error("/dev/null", {"/dev/null", "neither a file nor a folder"});
  expect_error(write("a.xyz", "abc"),
               {"extension", ".nrrd", ".mha", ".nii.gz", ".mrc", ".vtk", ".raw", "?size="});
  fs::create_symlink(path("nowhere"), path("dangling.nrrd"));
  expect_error(path("dangling.nrrd"), {"no such file"});
}

TEST_F(BadInput, NoPermission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const std::string file = write("a.nrrd", nrrd(uint8, endian::little).content);
  fs::permissions(file, fs::perms::none);
  expect_error(file, {file, "ermission denied"});
}

/// By this process so far, and its readers.
std::size_t bytes_read() {
  std::ifstream counts("/proc/self/io");
  std::string name;
  std::size_t bytes = 0;
  counts >> name >> bytes;
  return bytes;
}

// Gigabytes are not read to find that they hold nothing.
TEST_F(BadInput, ZerosAreAnsweredAtOnce) {
  const std::size_t before = bytes_read();
  for (const char* name :
       {"z.nrrd", "z.nhdr", "z.mha", "z.mhd", "z.nii", "z.nii.gz", "z.vtk", "z.mrc", "z.dcm", "z.tif"}) {
    fs::resize_file(write(name, ""), std::uintmax_t(2) << 30);  // sparse
    expect_error(path(name), {path(name)});
    fs::resize_file(path(name), 0);
    expect_error(path(name), {path(name)});
  }
  fs::resize_file(write("z.nrrd", "NRRD0004\ntype: uint8\n"), std::uintmax_t(2) << 30);
  expect_error(path("z.nrrd"), {"neither an end"});
  fs::resize_file(write("z.vtk", "# vtk DataFile Version 3.0\n"), std::uintmax_t(2) << 30);
  expect_error(path("z.vtk"), {"line 2"});
  EXPECT_LT(bytes_read() - before, std::size_t(64) << 20);
}

TEST_F(BadInput, HeadersThatPromiseMore) {
  const std::string header = nrrd(uint8, endian::little).content, huge = "sizes: 100000 100000 100000";
  expect_error(write("a.nrrd", replaced(header, "sizes: 5 4 3", huge)), {"promises 1000000000000000"});
  expect_error(write("a.nrrd", replaced(header, "sizes: 5 4 3", "sizes: 5 4 4")), {"promises 80", "has 60"});
  expect_error(write("z.nrrd", replaced(nrrd_gzip(uint8, endian::little).content, "sizes: 5 4 3", huge)),
               {"promises"});
  expect_error(
      write("z.nrrd", replaced(nrrd_gzip(uint8, endian::little).content, "sizes: 5 4 3", "sizes: 5 4 4")),
      {"promises 80", "has 60"});
  expect_error(
      write("a.mha", replaced(mha(uint8, endian::little).content, "DimSize = 5 4 3", "DimSize = 5 4 4")),
      {"promises 80", "has 60"});
  expect_error(write("a.mha", replaced(mha_compressed(uint8, endian::little).content, "DimSize = 5 4 3",
                                       "DimSize = 5 4 4")),
               {"promises 80", "has 60"});
  expect_error(
      write("a.vtk", replaced(vtk(uint8, endian::big).content, "DIMENSIONS 5 4 3", "DIMENSIONS 5 4 4")),
      {"promises 80", "has 60"});
  std::string nii = nifti(uint8, endian::little).content;
  nii[46] = 4;
  expect_error(write("a.nii", nii), {"promises 432", "has 412"});
  expect_error(write("a.nii.gz", gzip(nii)), {"promises 432", "has 412"});
  std::string map = mrc(int8, endian::little).content;
  map[8] = 4;
  expect_error(write("a.mrc", map), {"promises 80", "has 60"});
}

TEST_F(BadInput, SizesOfZeroOneAndBeyondCounting) {
  const std::string header = nrrd(uint8, endian::little).content;
  const std::string huge = "4000000000 4000000000 4000000000";
  for (const std::string& sizes : {std::string("0 4 3"), std::string("5 4 1"), std::string("1 4 3"), huge,
                                   std::string("-5 4 3"), std::string("5 4")}) {
    SCOPED_TRACE(sizes);
    expect_error(write("a.nrrd", replaced(header, "5 4 3", sizes)), {path("a.nrrd")});
    expect_error(
        write("a.mha", replaced(mha(uint8, endian::little).content, "DimSize = 5 4 3", "DimSize = " + sizes)),
        {path("a.mha")});
    expect_error(
        write("a.vtk", replaced(vtk(uint8, endian::big).content, "DIMENSIONS 5 4 3", "DIMENSIONS " + sizes)),
        {path("a.vtk")});
  }
  for (const int size : {0, 1, -1, 32767}) {
    SCOPED_TRACE(size);
    std::string bytes;
    append_value(bytes, size, int16, endian::little);
    expect_error(write("a.nii", nifti(uint8, endian::little).content.replace(46, 2, bytes)), {path("a.nii")});
    expect_error(
        write("a.mrc", mrc(int8, endian::little)
                           .content.replace(8, 4, bytes + (size < 0 ? "\xff\xff" : std::string(2, '\0')))),
        {path("a.mrc")});
  }
}

TEST_F(BadInput, DamagedCompressedDataIsSaid) {
  std::string nii = nifti_gzip(int16, endian::little).content;
  nii[nii.size() - 6] ^= 0x55;  // in the checksum
  error_of(write("a.nii.gz", nii));
  std::string packed = mha_compressed(int16, endian::little).content;
  packed[packed.size() - 1] ^= 0x55;
  expect_error(write("a.mha", packed), {"damaged"});
  // MetaIO goes by CompressedDataSize, and drops the rest in silence; real files have wrong ones.
  packed = mha_compressed(int16, endian::little).content;
  const Voxels whole = load_volume(write("b.mha", packed)).values;
  for (const char* line : {"CompressedSize = ", "CompressedDataSize = 5\nX = ", "CompressedDataSize = 9"}) {
    EXPECT_EQ(load_volume(write("b.mha", replaced(packed, "CompressedDataSize = ", line))).values, whole);
  }
}

TEST_F(BadInput, NrrdFormsThatAreNotRead) {
  const std::string header = nrrd_detached(int16, endian::little).content;
  expect_error(write("a.nhdr", header), {"the voxels.raw", "not there"});
  write("the voxels.raw", voxel_bytes(int16, endian::little));
  EXPECT_EQ(load_volume(write("ok.nhdr", header)).grid.dims, glm::ivec3(5, 4, 3));
  expect_error(write("a.nhdr", replaced(header, "encoding: raw", "encoding: bzip2")), {"bzip2", "gzip"});
  expect_error(write("a.nhdr", replaced(header, "encoding: raw", "encoding: raw\nbyte skip: -5")),
               {"byte skip: -5"});
  write("x.nii.gz", gzip("abc"));
  expect_error(write("a.nhdr", replaced(header, "the voxels.raw", "x.nii.gz")), {"NIfTI"});
  expect_error(write("a.nhdr", replaced(header, "the voxels.raw", "s.%s 1 3 1")), {"slice.%03d 1 93 1"});
  expect_error(write("a.nhdr", replaced(header, "the voxels.raw", "s.%d 1 3 0")), {"slice.%03d 1 93 1"});
  expect_error(write("a.nhdr", replaced(header, "type: int16", "type: block")), {path("a.nhdr")});
  expect_error(write("a.nrrd", replaced(nrrd(int16, endian::little).content, "type: int16\n", "")),
               {"\"type\""});
}

TEST_F(BadInput, ComponentsAndFramesAreTakenWhenAsked) {
  const std::string rgb =
      "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 3 4 5 2\nkinds: RGB-color domain domain domain\n"
      "encoding: raw\n\n";
  std::string voxels;
  for (int i = 0; i < 120; ++i) voxels += char(i);
  const std::string colored = write("rgb.nrrd", rgb + voxels);
  expect_error(colored, {"3 components", "?component=0"});
  expect_error(colored + "?component=3", {"component=3"});
  expect_error(colored + "?component=x", {"component=x"});
  expect_error(colored + "?colour=1", {"colour", "component, frame"});
  const Volume green = load_volume(colored + "?component=1");
  EXPECT_EQ(green.grid.dims, glm::ivec3(4, 5, 2));
  EXPECT_EQ(green.values[7], 22);
  EXPECT_NE(green.note.find("component 1 of 3"), std::string::npos) << green.note;

  const std::string frames = "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 4 5 2 3\nencoding: raw\n\n";
  const std::string film = write("film.nrrd", frames + voxels);
  expect_error(film, {"3 frames", "?frame=0"});
  const Volume last = load_volume(film + "?frame=2");
  EXPECT_EQ(last.grid.dims, glm::ivec3(4, 5, 2));
  EXPECT_EQ(last.values[7], 87);
  EXPECT_NE(last.note.find("frame 2 of 3"), std::string::npos) << last.note;

  const std::string one = replaced(frames, "4 5 2 3", "4 5 6 1");
  EXPECT_EQ(load_volume(write("one.nrrd", one + voxels)).grid.dims, glm::ivec3(4, 5, 6));
  expect_error(write("flat.nrrd",
                     replaced(replaced(frames, "4 5 2 3", "4 30"), "dimension: 4", "dimension: 2") + voxels),
               {"2 dimensions"});
}

TEST_F(BadInput, NiftiFramesAndComponents) {
  std::string header = nifti_header(uint8, endian::little, 1, 0);
  header[40] = 4, header[48] = 2;
  const std::string film = write("film.nii", header + voxel_bytes(uint8, endian::little, 2 * points));
  expect_error(film, {"2 frames"});
  EXPECT_EQ(load_volume(film + "?frame=1").values[0], float(stored_value(uint8, points)));
  header[48] = 1;
  EXPECT_EQ(load_volume(write("one.nii", header + voxel_bytes(uint8, endian::little))).grid.dims,
            glm::ivec3(5, 4, 3));
}

TEST_F(BadInput, SpacingThatIsNotANumberIsOneAndSaid) {
  std::string header = nrrd(uint8, endian::little).content;
  header = replaced(header, "space: left-posterior-superior\n", "");
  header = replaced(header, "space origin: (10,20,30)\n", "");
  header = replaced(header, "space directions: (1,0,0) (0,2,0) (0,0,3)", "spacings: nan -2 3");
  const Volume volume = load_volume(write("a.nrrd", header));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(1, 2, 3));
  const std::string meta =
      replaced(mha(uint8, endian::little).content, "ElementSpacing = 1 2 3", "ElementSpacing = 1 0 -3");
  const Volume second = load_volume(write("a.mha", meta));
  EXPECT_EQ(second.grid.spacing, glm::dvec3(1, 1, 3));
  EXPECT_NE(second.note.find("spacing 0 on axis 2"), std::string::npos) << second.note;
}

TEST_F(BadInput, NothingIsPrinted) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  std::string bad = nifti(uint8, endian::little).content;
  bad[70] = 99;  // no such type
  error_of(write("a.nii", bad));
  error_of(write("a.mha", replaced(mha(uint8, endian::little).content, "MET_UCHAR", "MET_NONSENSE")));
  error_of(write("a.vtk", replaced(vtk(uint8, endian::big).content, "STRUCTURED_POINTS", "POLYDATA")));
  error_of(write("a.dcm", std::string(128, '\0') + "DICM and nothing"));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(BadInput, WhatIsNotReadTellsHowToConvertIt) {
  std::filesystem::create_directory(path("v.zarr"));
  write("v.zarr/.zgroup", "{}");
  const std::pair<std::string, const char*> files[] = {{write("v.npz", "PK"), "NumPy"},
                                                       {write("v.h5", "\x89HDF"), "h5py"},
                                                       {write("v.HDF5", "\x89HDF"), "h5py"},
                                                       {path("v.zarr"), "zarr.open"},
                                                       {path("v.zarr") + "/", "zarr.open"}};
  for (const auto& [file, part] : files) expect_error(file, {file, part, "python3 -c", "volume.npy"});
}

TEST_F(BadInput, OtherKindsOfVtkAreNamed) {
  expect_error(write("v.vtu", "<VTKFile/>"), {".vtu (an unstructured grid)", "Resample To Image"});
  expect_error(write("v.PVTP", "<VTKFile/>"), {"surfaces", "no voxels"});
  expect_error(write("v.vtm", "<VTKFile/>"), {"its blocks", ".vti"});
  const std::string list =
      "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" file=\"s/f_1.vti\"/>";
  expect_error(write("v.pvd", list), {"as steps: 'NAME_*.vti'"});
  write("s/f_1.vti", "");
  write("s/f_2.vti", "");
  expect_error(path("v.pvd"), {"as steps: '" + path("s/f_*.vti") + "'"});
  const std::string series = R"({ "files" : [ { "name" : "s/f_1.vti", "time" : 0 } ] })";
  expect_error(write("v.vti.series", series), {"as steps: '" + path("s/f_*.vti") + "'"});
  expect_error(write("w.vti.series", "{ \"name\""), {"as steps: 'NAME_*.vti'"});
}

}  // namespace
}  // namespace crest::test
