#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using DicomCodestream = FileTest;

std::string from_hex(std::string_view digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += char(std::stoi(std::string(digits.substr(i, 2)), nullptr, 16));
  return bytes;
}

/// 8x6 signed pixels of 12 bits, -2048 + 97 i up to 2047, by opj_compress.
const std::string signed_j2k = from_hex(
    "ff4fff5100290000000000080000000600000000000000000000000800000006000000000000000000018b0101ff52000c000000"
    "0100"
    "0004040001ff5c00044060ff640025000143726561746564206279204f70656e4a5045472076657273696f6e20322e352e30ff90"
    "000a"
    "0000000000580001ff93dfe11c1229d02c4b4c7f1ea5913c3a2af86e28ef72c61750dc1cc1bf2bf4f0a44a76909f03f5909093cf"
    "9517"
    "ed81b00d2066bcd8403158b3890a472cb8b99b19a812cff3eebe6f989ebfffd9");
/// 4x3 pixels of 16 bits, by gdcmconv.
const std::string jpeg_ls = from_hex(
    "ffd8fff7000b100003000401011100fff8000d01ffff0012004301140040ffda00080101000000000ffc42ff65c01080442d7ccf"
    "cef9"
    "dfa3f44600ffd900");

/// Two frames of it.
std::string coded_file(const std::string& frame, const std::string& syntax, int columns, int rows, int bits) {
  const auto element = dicom_element;
  const auto us = dicom_us;
  return dicom_head("1.2.840.10008.5.1.4.1.1.7.3", "1.2.3.4", syntax) + element(0x28, 2, "US", us(1)) +
         element(0x28, 4, "CS", "MONOCHROME2") + element(0x28, 8, "IS", "2") +
         element(0x28, 0x10, "US", us(rows)) + element(0x28, 0x11, "US", us(columns)) +
         element(0x28, 0x100, "US", us(bits)) + element(0x28, 0x101, "US", us(bits == 16 ? 12 : bits)) +
         element(0x28, 0x102, "US", us(bits == 16 ? 11 : bits - 1)) + element(0x28, 0x103, "US", us(0)) +
         dicom_fragments({frame, frame});
}

TEST_F(DicomCodestream, Jpeg2000SaysItsSignItself) {
  const auto coded = [&](int columns, int rows) {
    return write("j2k.dcm", coded_file(signed_j2k, "1.2.840.10008.1.2.4.90", columns, rows, 16));
  };
  const Volume volume = load_volume(coded(8, 6));
  EXPECT_EQ(volume.file_type, ScalarType::int16);
  for (std::size_t i = 0; i < 96; ++i)
    ASSERT_EQ(volume.values[i], float(i % 48 < 43 ? int(i % 48) * 97 - 2048 : 2047)) << i;
  expect_error(coded(6, 8), {"6x8", "8x6"});
  expect_error(coded(8, 12), {"8x12", "8x6"});
}

TEST_F(DicomCodestream, JpegLsIsOfTheSizeThatItsHeaderSays) {
  const auto coded = [&](int columns, int rows, int bits) {
    return write("jls.dcm", coded_file(jpeg_ls, "1.2.840.10008.1.2.4.80", columns, rows, bits));
  };
  EXPECT_EQ(load_volume(coded(4, 3, 16)).grid.dims, glm::ivec3(4, 3, 2));
  expect_error(coded(3, 4, 16), {"3x4", "4x3"});
  expect_error(coded(4, 2, 16), {"4x2", "4x3"});
  expect_error(coded(4, 3, 8), {"1 x 8 bits", "1 x 16"});
}

}  // namespace
}  // namespace crest::test
