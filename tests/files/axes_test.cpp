#include <fmt/core.h>

#include <cstring>
#include <glm/geometric.hpp>

#include "files.h"
#include "render/files/load.h"
#include "render/volume/orientation.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;

using Axes = FileTest;

TEST_F(Axes, OfMrcArePutInOrder) {
  std::string file = mrc(int16, endian::little).content;
  file = with(file, 64, bytes_of({3, 2, 1}, int32));
  const Volume volume = load_volume(write("zyx.mrc", file));
  EXPECT_EQ(volume.grid.dims, glm::ivec3(3, 4, 5));
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 3; ++i)
        EXPECT_EQ(volume.at(i, j, k), float(stored_value(int16, k + 5 * (j + 4 * i))));
  EXPECT_NE(volume.note.find("3 2 1"), std::string::npos) << volume.note;
  expect_error(write("bad.mrc", with(file, 64, bytes_of({1, 1, 2}, int32))), {"MAPC"});
}

TEST_F(Axes, OfAnMrcStackAreVolumes) {
  std::string file = mrc(int8, endian::little).content + voxel_bytes(int8, endian::little, 60);
  file = with(file, 8, bytes_of({6}, int32));  // sections of all
  file = with(file, 88, bytes_of({401}, int32));
  const std::string stack = write("stack.mrc", file);
  expect_error(stack, {"2 frames", "?frame=0"});
  const Volume volume = load_volume(stack + "?frame=1");
  EXPECT_EQ(volume.grid.dims, glm::ivec3(5, 4, 3));
  EXPECT_EQ(volume.values[7], float(stored_value(int8, 7)));
}

TEST_F(Axes, AnMrcWithoutAStampIsReadInTheOrderThatFits) {
  for (const endian order : {endian::little, endian::big}) {
    std::string file = mrc(int16, order).content;
    file = with(file, 212, std::string(4, '\0'));
    const Volume volume = load_volume(write("none.mrc", file));
    EXPECT_EQ(volume.values[5], float(stored_value(int16, 5)));
    EXPECT_NE(volume.note.find("missing"), std::string::npos) << volume.note;
  }
}

TEST_F(Axes, HalfFloatsAreRead) {
  std::string file = mrc(int16, endian::little).content.substr(0, 1024);
  file = with(file, 12, bytes_of({12}, int32));
  const std::uint16_t halves[] = {0x3c00, 0xc100, 0x7bff, 0x0001, 0x7c00, 0x7e00};
  for (int i = 0; i < 60; ++i) append_value(file, halves[i % 6], uint16, endian::little);
  const Volume volume = load_volume(write("half.mrc", file));
  EXPECT_EQ(volume.file_type, float16);
  EXPECT_EQ(volume.values[0], 1.f);
  EXPECT_EQ(volume.values[1], -2.5f);
  EXPECT_EQ(volume.values[2], 65504.f);
  EXPECT_EQ(volume.values[3], 0x1p-24f);
  EXPECT_EQ(volume.statistics.inf_count, 10u);
  EXPECT_EQ(volume.statistics.nan_count, 10u);
  expect_error(write("complex.mrc", with(file, 12, bytes_of({4}, int32))), {"mode 4", "float16"});
}

TEST_F(Axes, NiftiDirectionsNeedNotBeOrthogonal) {
  std::string header = nifti_header(int16, endian::little, 1, 0);
  header = with(header, 254, bytes_of({1}, int16));
  header = with(header, 280, bytes_of({1, 0, 1, 5, 0, 2, 0, 6, 0, 0, 3, 7}, float32));
  const Volume volume = load_volume(write("shear.nii", header + voxel_bytes(int16, endian::little)));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(1, 2, 3));
  EXPECT_EQ(volume.grid.origin, glm::dvec3(-5, -6, 7));
  EXPECT_NE(volume.note.find("sform"), std::string::npos) << volume.note;
}

TEST_F(Axes, SecondNiftiAndPairs) {
  const std::string second = nifti2_header();
  const Volume volume = load_volume(write("two.nii", second + voxel_bytes(int16, endian::little)));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(1, 2, 3));
  EXPECT_EQ(volume.values[11], float(stored_value(int16, 11)));

  std::string pair = nifti_header(int16, endian::little, 1, 0).substr(0, 348);
  pair = with(pair, 108, bytes_of({0}, float32));
  const std::string head = write("pair.hdr", with(pair, 344, std::string("ni1\0", 4)));
  expect_error(head, {"pair.img"});
  write("pair.img", voxel_bytes(int16, endian::little));
  for (const std::string& name : {head, path("pair.img")})
    EXPECT_EQ(load_volume(name).values[11], float(stored_value(int16, 11)));
  const Volume analyze = load_volume(write("pair.hdr", with(pair, 344, std::string(4, '\0'))));
  EXPECT_NE(analyze.note.find("Analyze"), std::string::npos) << analyze.note;
}

TEST_F(Axes, OfNiftiWithoutSpacingHaveTheSforms) {
  std::string bytes = nifti_header(uint8, endian::little, 0, 0), rows;
  for (const double v : {0.5, 0., 0., 0., 0., 2., 0., 0., 0., 0., 4., 0.})
    append_value(rows, v, float32, endian::little);
  bytes.replace(280, rows.size(), rows);
  bytes.replace(80, 12, std::string(12, '\0'));
  bytes[254] = 1;
  const Volume volume = load_volume(write("a.nii", bytes + voxel_bytes(uint8, endian::little)));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(0.5, 2, 4));
  EXPECT_TRUE(volume.is_in_patient);
  EXPECT_EQ((*anatomical_axes(volume))[0], (AxisEnds{'L', 'R'}));  // NIfTI's x goes to the right
}

TEST_F(Axes, OfNrrdNeedNoKinds) {
  std::string numbers;
  for (int i = 0; i < 120; ++i) numbers += fmt::format("{} ", i);
  const std::string head =
      "NRRD0005\ntype: short\ndimension: 4\nencoding: ascii\nspace: left-posterior-superior\n";
  const std::string first =
      write("first.nrrd", head +
                              "sizes: 2 5 4 3\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\n"
                              "space origin: (7,8,9)\n\n" +
                              numbers);
  expect_error(first, {"2 components", "?component=0"});
  EXPECT_EQ(load_volume(first + "?component=1").values[5], 11.f);
  EXPECT_EQ(load_volume(first + "?component=1").grid, (Grid{{5, 4, 3}, {1, 2, 3}, {7, 8, 9}}));
  const std::string last = write("last.nrrd", head +
                                                  "sizes: 5 4 3 2\nkinds: space space space time\n"
                                                  "space directions: (1,0,0) (0,2,0) (0,0,3) none\n\n" +
                                                  numbers);
  expect_error(last, {"2 frames"});
  const Volume timed = load_volume(last + "?frame=1");
  EXPECT_EQ(timed.values[5], 65.f);
  EXPECT_EQ((*anatomical_axes(timed))[1], (AxisEnds{'A', 'P'}));
  std::string bare = nrrd(int16, endian::little).content;
  bare.erase(bare.find("endian: little\n"), 15);
  expect_error(write("bare.nrrd", bare), {"no \"endian\"", "int16"});
}

TEST_F(Axes, OfNumPy) {
  const auto npy = [](const std::string& dictionary, const std::string& data, bool second = false) {
    std::string head = "\x93NUMPY";
    head += char(second ? 2 : 1);
    head += '\0';
    append_value(head, double(dictionary.size()), second ? uint32 : uint16, endian::little);
    return head + dictionary + data;
  };
  std::string c_order, fortran;
  for (int i = 0; i < 60; ++i) append_value(c_order, i, int16, endian::big);
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 3; ++z) append_value(fortran, x + 5 * (y + 4 * z), float64, endian::little);
  const Volume c = load_volume(
      write("c.npy", npy("{'descr': '>i2', 'fortran_order': False, 'shape': (3, 4, 5), }\n", c_order)));
  const Volume f = load_volume(
      write("f.npy", npy("{'descr': '<f8', 'fortran_order': True, 'shape': (3, 4, 5), }\n", fortran, true)));
  EXPECT_EQ(c.grid.dims, glm::ivec3(5, 4, 3));
  EXPECT_EQ(c.values[59], 59.f);
  EXPECT_EQ(f.values, c.values);
  const std::string film =
      write("film.npy",
            npy("{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, 4, 5), }", std::string(120, 'x')));
  expect_error(film, {"2 frames"});
  EXPECT_EQ(load_volume(film + "?frame=1").grid.dims, glm::ivec3(5, 4, 3));
  expect_error(write("o.npy", npy("{'descr': '|O', 'fortran_order': False, 'shape': (3, 4, 5), }", c_order)),
               {"type"});
  expect_error(write("s.npy", npy("{'descr': '<i2', 'fortran_order': False, 'shape': (3, 4, 6), }", c_order)),
               {"promises"});
}

TEST_F(Axes, IntegersThatFloatMergesAreSaidAndCanBeKeptApart) {
  std::string numbers;
  for (int i = 0; i < 60; ++i) numbers += fmt::format("{} ", 1700000000 + i);
  const std::string file =
      write("big.nrrd", "NRRD0005\ntype: int\ndimension: 3\nsizes: 5 4 3\nencoding: ascii\n\n" + numbers);
  EXPECT_NE(load_volume(file).note.find("?subtract=1700000000"), std::string::npos) << load_volume(file).note;
  const Volume apart = load_volume(file + "?subtract=1700000000");
  for (int i = 0; i < 60; ++i) EXPECT_EQ(apart.values[std::size_t(i)], float(i));
}

TEST_F(Axes, NiftiColoursAreComponents) {
  std::string header = nifti_header(uint8, endian::little, 1, 0);
  header = with(header, 70, bytes_of({128, 24}, int16));
  std::string voxels;
  for (int i = 0; i < 180; ++i) voxels += char(i);
  const std::string file = write("rgb.nii", header + voxels);
  expect_error(file, {"3 components (red, green, blue)", "?component=0"});
  for (int component = 0; component < 3; ++component) {
    const Volume volume = load_volume(fmt::format("{}?component={}", file, component));
    for (int i = 0; i < 60; ++i) EXPECT_EQ(volume.values[std::size_t(i)], float(3 * i + component));
  }
}

TEST_F(Axes, HowTheyLieIsSaid) {
  const auto note_of = [&](std::initializer_list<double> rows) {
    std::string header = nifti_header(int16, endian::little, 1, 0);
    header = with(with(header, 254, bytes_of({1}, int16)), 280, bytes_of(rows, float32));
    return load_volume(write("v.nii", header + voxel_bytes(int16, endian::little))).note;
  };
  // NIfTI counts to the right and the front, where DICOM counts to the left and the back
  EXPECT_EQ(note_of({-1, 0, 0, 0, 0, -2, 0, 0, 0, 0, 3, 0}).find("axes"), std::string::npos);
  EXPECT_NE(note_of({1, 0, 0, 0, 0, -2, 0, 0, 0, 0, 3, 0}).find("mirrored (left-handed)"), std::string::npos);
  EXPECT_NE(note_of({1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0}).find("axes are turned"), std::string::npos);
  EXPECT_NE(note_of({-1, 0, 0, 0, 0, -2, 1, 0, 0, 0, 2.828427, 0}).find("not at right angles"),
            std::string::npos);
}

TEST_F(Axes, AnMrcThatDoesNotHoldWhatItSaysIsRefusedInItsOrder) {
  std::string file = mrc(int16, endian::big).content;
  file = with(with(file, 212, std::string(4, '\0')), 92, "\xf3\x31\xcb\x64");
  expect_error(write("none.mrc", file), {"sizes 5 4 3 and mode 1 (big-endian)", "no stamp"});
}

}  // namespace
}  // namespace crest::test
