#include <fmt/core.h>
#include <zlib.h>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;

/// Files that take a library down, keep it busy without an end, or have it invent voxels. Each is read, or
/// refused in one line.
class Hostile : public FileTest {
 protected:
  void expect_reader_failed(const std::string& file) const {
    expect_error(file, {file + ": its reader failed ("});
  }
};

std::string meta(const std::string& lines, const std::string& dims = "5 4 3") {
  return "ObjectType = Image\nNDims = 3\n" + lines + "DimSize = " + dims +
         "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + voxel_bytes(uint8, endian::little);
}

std::string nrrd_with(const std::string& lines, const std::string& encoding = "raw",
                      const std::string& data = "") {
  return "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 4 3\nencoding: " + encoding + "\n" + lines + "\n" +
         (data.empty() ? voxel_bytes(uint8, endian::little) : data);
}

TEST_F(Hostile, LongLinesOfMetaImage) {
  EXPECT_EQ(load_volume(write("a.mha", meta("Comment = " + std::string(254, 'x') + "\n"))).grid.dims.x, 5);
  for (const std::size_t length : {255, 256, 1000, 4000, 100000}) {
    const std::string text(length, 'x');
    expect_error(write("a.mha", meta("Comment = " + text + "\n")), {"line 3", "longer"});
    expect_error(write("a.mha", meta("Name = " + text + "\n")), {"line 3", "longer"});
    expect_error(write("a.mha", meta(text + " = 1\n")), {"line 3", "longer"});
  }
}

TEST_F(Hostile, KeysThatAreThereTwice) {
  expect_error(write("a.mha", meta("NDims = 9\n")), {"line 3", "NDims once more"});
  expect_error(write("a.mha", meta("DimSize = 1000000 1000000 1000000\n")), {"line 4", "DimSize once more"});
}

TEST_F(Hostile, LongLinesOfNrrd) {
  std::string many, one(1000, 'x');
  for (int i = 0; i < 1000; ++i) many += " domain";
  for (const char* key : {"kinds", "centers", "thicknesses"})
    expect_error(write("a.nrrd", nrrd_with(fmt::format("{}:{}\n", key, many))), {key, "1000 axes"});
  expect_error(write("a.nrrd", nrrd_with("kinds: " + one + "\n")), {"kinds", "128 characters"});
  expect_error(write("a.nrrd", nrrd_with("labels: \"" + std::string(5000, 'x') + "\"\n")), {"labels"});
}

TEST_F(Hostile, NumberedFilesWithoutAnEnd) {
  for (const char* numbers :
       {"-9223372036854775808 3 1", "1 3 9223372036854775807", "1 3 -9223372036854775808",
        "9223372036854775807 3 -1", "1 9223372036854775808 1"}) {
    const std::string pattern = fmt::format("s%d {}", numbers);
    expect_error(write("v.nhdr", nrrd_with("data file: " + pattern + "\n")), {pattern, "slice.%03d"});
    expect_error(write("v.mhd", "NDims = 3\nDimSize = 5 4 3\nElementType = MET_UCHAR\nElementDataFile = " +
                                    pattern + "\n"),
                 {pattern, "slice.%03d"});
  }
}

TEST_F(Hostile, BlankLinesInAListOfFiles) {
  const std::string head = "NDims = 3\nDimSize = 5 4 3\nElementType = MET_UCHAR\nElementDataFile = LIST\n";
  for (const char* name : {"s1", "s2", "s3"}) write(name, std::string(20, 'x'));
  EXPECT_EQ(load_volume(write("v.mhd", head + "s1\ns2\ns3\n\n")).grid.dims.z, 3);
  expect_error(write("v.mhd", head + "s1\n\ns2\ns3\n"), {"line 6", "empty"});
}

TEST_F(Hostile, SkippingInCompressedData) {
  const std::string zeros = gzip(std::string(std::size_t(32) << 20, '\0'));
  for (const char* skip : {"1000000000", "-1"})
    expect_error(write("a.nrrd", nrrd_with(fmt::format("byte skip: {}\n", skip), "gzip", zeros)),
                 {"byte skip", skip});
  const Volume volume = load_volume(
      write("a.nrrd", nrrd_with("byte skip: 3\n", "gzip", gzip("abc" + voxel_bytes(uint8, endian::little)))));
  EXPECT_EQ(volume.values[1], float(stored_value(uint8, 1)));
}

TEST_F(Hostile, SkippingInAText) {
  std::string hex, numbers;
  for (int i = 0; i < points; ++i) hex += fmt::format("{:02x}", i), numbers += fmt::format("{} ", i);
  for (const auto& [encoding, text] : {std::pair("hex", hex), std::pair("ascii", numbers)}) {
    const std::string skipped = "xyz" + text;
    for (const char* key : {"byte skip", "byteskip"}) {
      const Volume volume =
          load_volume(write("a.nrrd", nrrd_with(fmt::format("{}: 3\n", key), encoding, skipped)));
      EXPECT_EQ(volume.values[59], 59.f) << encoding;
    }
    expect_error(write("a.nrrd", nrrd_with("byte skip: -1\n", encoding, skipped)), {"byte skip: -1", "raw"});
  }
}

/// A DICOM file of two frames of 4x3 pixels.
std::string dicom(int samples, int bits, const std::string& pixels, int planar = 0,
                  const std::string& syntax = "1.2.840.10008.1.2.1", const std::string& more = "") {
  const auto element = dicom_element;
  return dicom_head("1.2.840.10008.5.1.4.1.1.7.4", "1.2.3.4", syntax) + element(8, 0x60, "CS", "OT") +
         element(0x20, 0xd, "UI", "1.2") + element(0x20, 0xe, "UI", "1.2.3") +
         element(0x28, 2, "US", dicom_us(samples)) +
         element(0x28, 4, "CS", samples == 3 ? "RGB" : "MONOCHROME2") +
         element(0x28, 6, "US", dicom_us(planar)) + element(0x28, 8, "IS", "2") +
         element(0x28, 0x10, "US", dicom_us(3)) + element(0x28, 0x11, "US", dicom_us(4)) +
         element(0x28, 0x100, "US", dicom_us(bits)) + element(0x28, 0x101, "US", dicom_us(bits)) +
         element(0x28, 0x102, "US", dicom_us(bits - 1)) + element(0x28, 0x103, "US", dicom_us(0)) + more +
         pixels;
}

std::string pixel_data(const std::string& bytes) { return dicom_element(0x7fe0, 0x10, "OB", bytes); }

// DICOM has no modality values of colour (PS3.3, C.11.1): its rescale does not count.
TEST_F(Hostile, ColourWithARescaleIsRead) {
  std::string pixels;
  for (int i = 0; i < 72; ++i) pixels += char(i);
  const std::string rescale = dicom_element(0x28, 0x1052, "DS", "1") + dicom_element(0x28, 0x1053, "DS", "2");
  const std::string file =
      write("rgb.dcm", dicom(3, 8, pixel_data(pixels), 0, "1.2.840.10008.1.2.1", rescale));
  expect_error(file, {"3 components"});
  const Volume volume = load_volume(file + "?component=0");
  EXPECT_EQ(volume.grid.dims, glm::ivec3(4, 3, 2));
  for (int i = 0; i < 24; ++i) EXPECT_EQ(volume.values[std::size_t(i)], float(3 * i));
}

TEST_F(Hostile, SamplesOfYbrAreNotCalledColours) {
  std::string file = dicom(3, 8, pixel_data(std::string(72, 'x')));
  const std::string rgb = dicom_element(0x28, 4, "CS", "RGB");
  expect_error(write("rgb.dcm", file), {"3 components (red, green, blue)"});
  file.replace(file.find(rgb), rgb.size(), dicom_element(0x28, 4, "CS", "YBR_FULL"));
  expect_error(write("ybr.dcm", file), {"3 components (luma, blue less luma, red less luma)"});
}

TEST_F(Hostile, DicomThatTakesItsDecodersDown) {
  const std::string whole = pixel_data(std::string(72, 'x'));
  error_of(write("bits.dcm", dicom(1, 24, whole)));
  expect_error(write("planar.dcm", dicom(3, 8, whole, 7)) + "?component=0", {"planar configuration is 7"});
  const std::string jpeg = "1.2.840.10008.1.2.4.50", rle = "1.2.840.10008.1.2.5",
                    j2k = "1.2.840.10008.1.2.4.90";
  for (const std::string& syntax : {jpeg, rle, j2k, std::string("1.2.840.10008.1.2.4.80")}) {
    for (const std::string& part :
         {std::string("\xff\xd8\xff\xdb\x00\x43", 6), std::string(64, '\xff'), std::string(64, '\0'),
          std::string("\2\0\0\0\xff\xff\xff\x7f", 8) + std::string(60, 'x')}) {
      SCOPED_TRACE(syntax);
      error_of(write("cut.dcm", dicom(1, 8, dicom_fragments({part}), 0, syntax)));
      error_of(write("cut.dcm", dicom(1, 8, dicom_fragments({part, part}), 0, syntax)));
    }
  }
}

TEST_F(Hostile, MrcWithoutAStamp) {
  std::string map = mrc(int16, endian::little).content;
  map.replace(212, 4, std::string(4, '\0'));
  std::string other = mrc(int16, endian::big).content;
  other.replace(212, 4, std::string(4, '\0'));
  for (const std::string& bytes : {map, other}) {
    try {
      EXPECT_EQ(load_volume(write("a.mrc", bytes)).values[1], float(stored_value(int16, 1)));
    } catch (const std::exception& refused) {
      EXPECT_NE(std::string(refused.what()).find("a.mrc: "), std::string::npos);
    }
  }
}

/// A page of a TIFF of 8-bit pixels: what its entries say, and the data that is there.
struct Page {
  int width = 40, height = 30, compression = 1;
  std::uint32_t bytes = 0;  ///< as its entry says
  std::string data;
};

std::string tiff(const std::vector<Page>& pages) {
  std::string file("II*\0\0\0\0\0", 8);
  std::size_t link = 4;  // where the place of the next directory stands
  const auto put = [&](double value, ScalarType type) { append_value(file, value, type, endian::little); };
  for (const Page& page : pages) {
    const std::size_t data = file.size();
    file += page.data;
    if (file.size() % 2 != 0) file += '\0';
    std::string place;
    append_value(place, double(file.size()), uint32, endian::little);
    file.replace(link, 4, place);
    const std::pair<int, double> entries[] = {
        {256, page.width},   {257, page.height}, {258, 8},           {259, page.compression}, {262, 1},
        {273, double(data)}, {277, 1},           {278, page.height}, {279, page.bytes}};
    put(std::size(entries), uint16);
    for (const auto& [tag, value] : entries) {
      put(tag, uint16);
      put(4, uint16);
      put(1, uint32);
      put(value, uint32);
    }
    link = file.size();
    put(0, uint32);
  }
  return file;
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
           bytes.size());
  packed.resize(size);
  return packed;
}

TEST_F(Hostile, PagesThatLackPixels) {
  std::string pixels;
  for (int i = 0; i < 1200; ++i) pixels += char((i * i * 31 + i) % 251);
  const std::string packed = deflated(pixels);
  const Page raw{40, 30, 1, 1200, pixels}, zip{40, 30, 8, std::uint32_t(packed.size()), packed};
  const Volume volume = load_volume(write("whole.tif", tiff({raw, zip})));
  EXPECT_EQ(volume.at(39, 29, 0), volume.at(39, 29, 1));
  EXPECT_EQ(volume.at(1, 0, 1), 32);

  Page bad = raw;
  bad.bytes = 400;
  expect_error(write("short.tif", tiff({raw, bad})), {"page 2", "shorter"});
  bad = raw;
  bad.bytes = 1 << 30;
  error_of(write("beyond.tif", tiff({raw, bad})));
  bad = zip;
  bad.bytes = 60;
  expect_error(write("cut.tif", tiff({zip, bad, zip})), {"page 2", "ends early"});
  bad = zip;
  bad.data[bad.data.size() / 2] ^= 0x55;
  expect_error(write("damaged.tif", tiff({zip, zip, bad})), {"page 3"});
  std::filesystem::create_directory(path("folder"));
  write("folder/1.tif", tiff({zip}));
  write("folder/2.tif", tiff({bad}));
  expect_error(path("folder"), {path("folder/2.tif"), "page 1"});
}

TEST_F(Hostile, AFewBytesThatPromiseMuch) {
  const std::string few = deflated(std::string(100, '\0'));
  for (const int compression : {1, 5, 8, 32773}) {
    const Page page{30000, 30000, compression, std::uint32_t(few.size()), few};
    expect_error(write("tiny.tif", tiff({page, page})), {"page 1"});
  }
}

TEST_F(Hostile, ControlCharactersInAFieldAreNotPassedOn) {
  const std::string message = error_of(write("a.nrrd", nrrd_with("", "\x1b]0;title\x07\x1b[31mraw\xff")));
  for (const char c : message) EXPECT_FALSE(std::iscntrl(static_cast<unsigned char>(c))) << message;
  EXPECT_NE(message.find("\\x1b]0;title\\x07"), std::string::npos) << message;
  EXPECT_NE(message.find("\\xff"), std::string::npos) << message;
}

}  // namespace
}  // namespace crest::test
