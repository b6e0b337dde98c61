#include <fmt/core.h>

#include <cmath>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;

/// What headers say in unusual ways, as other programs write them.
class Headers : public FileTest {
 protected:
  std::string nrrd_head(const std::string& more) const {
    return "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 4 3\nencoding: raw\n" + more;
  }
  std::string mha_head(const std::string& dims, const std::string& file) const {
    return fmt::format("NDims = 3\nDimSize = {}\nElementType = MET_UCHAR\nElementDataFile = {}", dims, file);
  }
  std::string note_of(const std::string& source) const { return load_volume(source).note; }
  static float stored(int i) { return float(stored_value(uint8, i)); }
  const std::string voxels = voxel_bytes(uint8, endian::little);
};

TEST_F(Headers, VoxelFilesThatAreTooManyOrTooLongAreRefused) {
  for (int i = 0; i < 4; ++i) write(fmt::format("s{}", i), voxels.substr(0, 20));
  const std::string list = "s0\ns1\ns2\ns3\n";  // of 15 bytes each, by the header
  expect_error(write("a.nhdr", nrrd_head("data file: LIST\n" + list)), {"4 files", "15 bytes", "has 20"});
  expect_error(write("a.mhd", mha_head("5 4 3", "LIST\n" + list)), {"4 files", "15 bytes", "has 20"});
}

TEST_F(Headers, AFileThatGoesOnBehindItsVoxelsIsNoted) {
  const std::string more = "goes on";
  write("a.raw", voxels + "x");
  EXPECT_NE(note_of(write("a.nhdr", nrrd_head("data file: a.raw\n"))).find("a.raw " + more),
            std::string::npos);
  EXPECT_EQ(note_of(write("b.nhdr", nrrd_head("byte skip: -1\ndata file: a.raw\n"))), "");
  EXPECT_NE(note_of(write("a.nrrd", nrrd_head("\n") + voxels + "x")).find(more), std::string::npos);
  EXPECT_EQ(note_of(write("b.nrrd", nrrd_head("\n") + voxels)), "");
  const std::string text =
      "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n1 2 3 4 5 6 7 8\n";
  EXPECT_EQ(note_of(write("c.nrrd", text)), "");
  EXPECT_NE(note_of(write("d.nrrd", text + "9\n")).find(more), std::string::npos);
  std::string hex = text.substr(0, text.find("ascii")) + "hex\n\n0102030405060708\n";
  EXPECT_EQ(note_of(write("e.nrrd", hex)), "");
  EXPECT_NE(note_of(write("f.nrrd", hex + "09\n")).find(more), std::string::npos);
  const Sample packed = nrrd_gzip(uint8, endian::little);
  EXPECT_EQ(note_of(write("g.nrrd", packed.content)), "");
  EXPECT_NE(note_of(write("h.nrrd", packed.content + gzip("x"))).find(more), std::string::npos);
}

TEST_F(Headers, WhatIsNoFileOfVoxelsIsSaid) {
  for (const char* odd : {"/dev/zero", "."}) {
    expect_error(write("a.nhdr", nrrd_head(fmt::format("data file: {}\n", odd))), {odd, "no ordinary file"});
    expect_error(write("a.mhd", mha_head("5 4 3", odd)), {odd, "no ordinary file"});
  }
  expect_error(write("b.nhdr", nrrd_head("data file: none\n")), {"none", "not there"});
  expect_error(write("a.vti", ""), {"empty"});
  for (const char* content : {"", "II", "PK\3\4 and more"})
    expect_error(write("a.tif", content), {"not a TIFF file"});
}

TEST_F(Headers, TheirLastLineNeedsNoEnd) {
  write("a.raw", voxels);
  EXPECT_EQ(load_volume(write("a.nhdr", nrrd_head("data file: a.raw"))).values[7], stored(7));
  EXPECT_EQ(load_volume(write("a.mhd", mha_head("5 4 3", "a.raw"))).values[7], stored(7));
  EXPECT_EQ(load_volume(write("b.nhdr", nrrd_head("data file: LIST\na.raw"))).values[7], stored(7));
}

TEST_F(Headers, AnNrrdListNamesAnyFile) {
  for (const char* name : {"t: 1", "t: 2", "c:3"}) write(name, voxels.substr(0, 20));
  EXPECT_EQ(load_volume(write("a.nhdr", nrrd_head("data file: LIST\nt: 1\nt: 2\nc:3\n"))).values[47],
            stored(7));
}

TEST_F(Headers, NrrdFieldsInOneWordAreTheSame) {
  const std::string head = nrrd_head("axismins: 0 0 0\naxismaxs: 5 8 12\ncenterings: cell cell cell\n\n");
  const Volume volume = load_volume(write("a.nrrd", head + voxels));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(1, 2, 4));
  EXPECT_EQ(volume.grid.origin, glm::dvec3(0.5, 1, 2));
  expect_error(write("b.nrrd", nrrd_head("axismins: 0 0 0\naxis mins: 0 0 0\n\n") + voxels), {"twice"});
}

TEST_F(Headers, AnNrrdSpacingThatIsNotKnownIsNoted) {
  const Volume volume = load_volume(write("a.nrrd", nrrd_head("spacings: 2 nan 3\n\n") + voxels));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(2, 1, 3));
  EXPECT_NE(volume.note.find("axis 2"), std::string::npos) << volume.note;
}

TEST_F(Headers, AnNrrdDirectionOfNansIsNone) {
  std::string head =
      nrrd_head("space dimension: 3\nspace directions: (nan,nan,nan) (1,0,0) (0,1,0) (0,0,1)\n\n");
  head.replace(head.find("dimension: 3"), 12, "dimension: 4");
  head.replace(head.find("5 4 3"), 5, "2 5 2 3");
  EXPECT_EQ(load_volume(write("a.nrrd", head + voxels) + "?component=1").values[3], stored(7));
}

TEST_F(Headers, AMetaImageHasOneSizeAnAxis) {
  expect_error(write("a.mha", mha_head("5 4 3 2", "LOCAL\n") + voxels + voxels),
               {"DimSize", "4", "NDims is 3"});
}

TEST_F(Headers, BytesOfAnMrcAreSignedAsItsRangeSays) {
  const auto file_of = [&](int version, double least, double greatest) {
    std::string file = mrc(int8, endian::little).content.substr(0, 1024) + std::string(60, '\xc8');
    file = with(file, 76, bytes_of({least, greatest}, float32));
    return write("a.mrc", with(file, 108, bytes_of({double(version)}, int32)));
  };
  EXPECT_EQ(load_volume(file_of(0, -56, 0)).values[0], -56.f);
  EXPECT_EQ(load_volume(file_of(0, 0, 200)).values[0], 200.f);
  EXPECT_EQ(load_volume(file_of(20140, 0, 200)).values[0], 200.f);
  EXPECT_EQ(load_volume(file_of(0, 0, 0)).values[0], 200.f);  // not said: by the version
  EXPECT_EQ(load_volume(file_of(20140, 0, 0)).values[0], -56.f);
  EXPECT_NE(load_volume(file_of(20140, 0, 0)).note.find("int8"), std::string::npos);
}

TEST_F(Headers, AnMrcMayBeCompressed) {
  const std::string content = mrc(int16, endian::little).content;
  for (const char* name : {"a.map.gz", "a.rec.gz", "a.ccp4.gz"})
    EXPECT_EQ(load_volume(write(name, gzip(content))).values[7], float(stored_value(int16, 7)));
  const std::string whole = gzip(content), cut = whole.substr(0, whole.size() - 12);
  expect_error(write("b.mrc.gz", cut), {"b.mrc.gz", "ends early"});
  std::string extended = with(content, 92, bytes_of({40}, int32));
  extended.insert(1024, std::string(40, 'x'));
  EXPECT_EQ(load_volume(write("c.mrc.gz", gzip(extended))).values[7], float(stored_value(int16, 7)));
}

TEST_F(Headers, AWrongMrcStampIsSeenInModeZeroToo) {
  std::string file = mrc(int8, endian::big).content;
  file = with(file, 212, "DA");
  const Volume volume = load_volume(write("a.mrc", file));
  EXPECT_EQ(volume.grid.dims, glm::ivec3(5, 4, 3));
  EXPECT_NE(volume.note.find("wrong"), std::string::npos) << volume.note;
}

TEST_F(Headers, ANiftiScalingThatIsNoNumberIsNoted) {
  const auto note = [&](float slope, float intercept) {
    return note_of(write("a.nii", nifti_header(uint8, endian::little, slope, intercept) + voxels));
  };
  EXPECT_NE(note(2, NAN).find("not applied"), std::string::npos);
  EXPECT_NE(note(INFINITY, 0).find("not applied"), std::string::npos);
  EXPECT_EQ(note(NAN, NAN).find("not applied"), std::string::npos);  // of programs that have none
  EXPECT_EQ(note(0, NAN).find("not applied"), std::string::npos);
}

TEST_F(Headers, NiftiVoxelsWithoutAPlaceFollowTheHeaderAndItsFlag) {
  std::string first = nifti_header(uint8, endian::little, 0, 0);
  first = with(first, 108, bytes_of({0}, float32));
  EXPECT_EQ(load_volume(write("a.nii", first + voxels)).values[7], stored(7));
  const std::string second = with(nifti2_header(), 168, bytes_of({0}, int64));
  const Volume volume = load_volume(write("b.nii", second + voxel_bytes(int16, endian::little)));
  EXPECT_EQ(volume.values[7], float(stored_value(int16, 7)));
}

TEST_F(Headers, OfSeveralFilesTheOneThatGoesOnIsNamed) {
  const std::string head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 4 3\nencoding: ",
                    list = "\ndata file: LIST\ns0\ns1\ns2\n";
  const auto note = [&](const std::string& encoding, int longer, const std::string& query, auto file_of) {
    for (int k = 0; k < 3; ++k) {
      std::string part = voxels.substr(std::size_t(20 * k), 20);
      if (k == longer) part += part.substr(0, 3);
      write(fmt::format("s{}", k), file_of(part));
    }
    return load_volume(write("s.nhdr", head + encoding + list) + query).note;
  };
  const auto as_text = [](const std::string& part) {
    std::string text;
    for (const char c : part) text += fmt::format("{} ", int(static_cast<unsigned char>(c)));
    return text;
  };
  for (int longer = 0; longer < 3; ++longer) {
    const std::string name = fmt::format("s{} goes on", longer);
    EXPECT_NE(note("gzip", longer, "", gzip).find(name), std::string::npos) << longer;
    EXPECT_NE(note("ascii", longer, "", as_text).find(name), std::string::npos) << longer;
  }
  EXPECT_EQ(note("gzip", 3, "", gzip).find("goes on"), std::string::npos);
  EXPECT_NE(note("gzip", 1, "?crop=:,:,0:2", gzip).find("s1 goes on"), std::string::npos);
  EXPECT_EQ(note("gzip", 2, "?crop=:,:,0:2", gzip).find("goes on"), std::string::npos);  // it is not read
}

TEST_F(Headers, ANumPyShapeOfPython2IsRead) {
  std::string head = "{'descr': '|u1', 'fortran_order': False, 'shape': (3L, 4L, 5L), }";
  head.resize(117, ' ');
  head += '\n';
  const std::string file = std::string("\x93NUMPY\x01\x00", 8) + char(head.size()) + '\0' + head + voxels;
  EXPECT_EQ(load_volume(write("a.npy", file)).values[7], stored(7));
}

TEST_F(Headers, AByteOrderMarkBeforeVtkXmlIsPassedOver) {
  const std::string file =
      "\xef\xbb\xbf<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\"><ImageData "
      "WholeExtent=\"0 1 0 1 0 1\"><Piece Extent=\"0 1 0 1 0 1\"><PointData><DataArray type=\"UInt8\" "
      "Name=\"s\" format=\"ascii\">1 2 3 4 5 6 7 8</DataArray></PointData></Piece></ImageData></VTKFile>\n";
  EXPECT_EQ(load_volume(write("a.vti", file)).values[7], 8.f);
}

TEST_F(Headers, AMetaImagesNumberedFilesAreCountedFromOneUnlessItSays) {
  for (int k = 1; k <= 3; ++k) write(fmt::format("s{:02}", k), voxels.substr(20 * std::size_t(k - 1), 20));
  EXPECT_EQ(load_volume(write("a.mhd", mha_head("5 4 3", "s%02d"))).values[47], stored(47));
}

TEST_F(Headers, AMetaImagesDirectionsAreOfLengthOne) {
  const std::string head = "TransformMatrix = 2 0 0 0 2 0 0 0 2\n" + mha_head("5 4 3", "LOCAL\n");
  EXPECT_EQ(note_of(write("a.mha", head + voxels)), "");
}

TEST_F(Headers, AnNrrdListBehindComponentsIsFrames) {
  const std::string head =
      "NRRD0004\ntype: uint8\ndimension: 5\nsizes: 3 2 2 2 2\nencoding: raw\n"
      "kinds: vector domain domain domain list\n\n";
  const Volume volume = load_volume(write("a.nrrd", head + voxels.substr(0, 48)) + "?component=1&frame=1");
  EXPECT_EQ(volume.frames, 2);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(volume.values[std::size_t(i)], stored(24 + 3 * i + 1)) << i;
}

// As NIfTI's own library reads them: some programs write 0 for an axis that is not there.
TEST_F(Headers, NiftiSizesOfNoneCountAsOne) {
  const std::string bytes = nifti_header(int16, endian::little, 1, 0) + voxel_bytes(int16, endian::little);
  const std::string none = bytes_of({5, 5, 4, 3, 0, 0}, int16);  // of five axes
  EXPECT_EQ(load_volume(write("a.nii", with(bytes, 40, none))).values[7], float(stored_value(int16, 7)));
  expect_error(write("b.nii", with(bytes, 40, bytes_of({3, 5, 0, 3}, int16))), {"axis 2", "0 points"});
}

TEST_F(Headers, NiftiComplexNumbersAreTwoComponents) {
  std::string bytes = nifti_header(float32, endian::little, 2, 1);
  bytes = with(with(bytes, 40, bytes_of({3, 2, 2, 2}, int16)), 70, bytes_of({32}, int16));
  for (int i = 0; i < 16; ++i) append_value(bytes, 10 * i, float32, endian::little);
  const std::string source = write("a.nii", bytes);
  expect_error(source, {"2 components", "real part, imaginary part"});
  const Volume imaginary = load_volume(source + "?component=1");
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(imaginary.values[std::size_t(i)], float(2 * 10 * (2 * i + 1) + 1)) << i;
}

// As programs leave it that copy a header, and not what it tells of.
TEST_F(Headers, AnMrcsExtendedHeaderMayBeMissing) {
  const std::string bytes = mrc(int16, endian::little).content;
  const Volume whole = load_volume(write("a.mrc", bytes));
  const std::string telling = with(bytes, 92, bytes_of({160}, int32));
  const Volume volume = load_volume(write("b.mrc", telling));
  EXPECT_EQ(volume.values, whole.values);
  EXPECT_NE(volume.note.find("extended header of 160 bytes, which is not there"), std::string::npos)
      << volume.note;
  expect_error(write("c.mrc", telling + "xy"), {"c.mrc"});  // neither as long as with it nor as without
}

}  // namespace
}  // namespace crest::test
