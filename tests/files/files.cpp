#include "files.h"

#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include <fmt/core.h>

#include "presets/error.h"
#include "render/files/load.h"

namespace crest::test {

namespace fs = std::filesystem;

FileTest::FileTest() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  folder_ = fs::temp_directory_path() /
            fmt::format("crest {} {} {}", info->test_suite_name(), info->name(), getpid());  // with spaces
  fs::create_directories(folder_);
}

FileTest::~FileTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string FileTest::write(const std::string& name, const std::string& content) const {
  fs::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name, std::ios::binary) << content;
  return path(name);
}

std::string error_of(const std::string& source) {
  try {
    load_volume(source);
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  ADD_FAILURE() << source << " was read";
  return "";
}

void expect_error(const std::string& source, const std::vector<std::string>& parts) {
  const std::string message = error_of(source);
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << "\"" << part << "\" is not in: " << message;
  }
}

double stored_value(ScalarType type, int i) {
  const double value = (i * 37) % 101;
  switch (type) {
    case ScalarType::uint8:
      return value;
    case ScalarType::int8:
      return value - 60;
    case ScalarType::uint16:
      return value * 600 + 5;
    case ScalarType::int16:
      return value * 300 - 20000;
    case ScalarType::uint32:
      return value * 131072 + 2;
    case ScalarType::int32:
      return value * 131072 - 3000000;
    case ScalarType::uint64:
      return value * 131072 + 7;
    case ScalarType::int64:
      return value * 131072 - 5000000;
    case ScalarType::float32:
      return value * 0.25 - 7;
    case ScalarType::float64:
      return value * 0.1 - 3;
    case ScalarType::float16:
      break;
  }
  return 0;
}

void append_value(std::string& bytes, double value, ScalarType type, std::endian endian) {
  const auto append = [&](auto typed) {
    char raw[sizeof typed];
    std::memcpy(raw, &typed, sizeof typed);
    if (endian != std::endian::native) std::reverse(raw, raw + sizeof typed);
    bytes.append(raw, sizeof typed);
  };
  switch (type) {
    case ScalarType::uint8:
      return append(std::uint8_t(value));
    case ScalarType::int8:
      return append(std::int8_t(value));
    case ScalarType::uint16:
      return append(std::uint16_t(value));
    case ScalarType::int16:
      return append(std::int16_t(value));
    case ScalarType::uint32:
      return append(std::uint32_t(value));
    case ScalarType::int32:
      return append(std::int32_t(value));
    case ScalarType::uint64:
      return append(std::uint64_t(value));
    case ScalarType::int64:
      return append(std::int64_t(value));
    case ScalarType::float32:
      return append(float(value));
    case ScalarType::float64:
      return append(value);
    case ScalarType::float16:
      break;
  }
}

std::string voxel_bytes(ScalarType type, std::endian endian, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) append_value(bytes, stored_value(type, i), type, endian);
  return bytes;
}

std::string gzip(const std::string& bytes) {
  z_stream stream{};
  constexpr int gzip_format = 15 + 16;
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_format, 8, Z_DEFAULT_STRATEGY);
  std::string out(bytes.size() + 1024, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

namespace {

std::string nrrd_header(ScalarType type, std::endian endian, const std::string& encoding) {
  std::string name = name_of(type);
  if (type == ScalarType::float32) name = "float";
  if (type == ScalarType::float64) name = "double";
  return fmt::format(
      "NRRD0004\ntype: {}\ndimension: 3\nspace: left-posterior-superior\nsizes: 5 4 3\n"
      "space directions: (1,0,0) (0,2,0) (0,0,3)\nspace origin: (10,20,30)\nendian: {}\nencoding: {}\n",
      name, endian == std::endian::big ? "big" : "little", encoding);
}

std::string meta_header(ScalarType type, std::endian endian, const std::string& more) {
  static const char* const names[] = {"MET_UCHAR", "MET_CHAR",  "MET_USHORT",     "MET_SHORT",
                                      "MET_UINT",  "MET_INT",   "MET_ULONG_LONG", "MET_LONG_LONG",
                                      "MET_FLOAT", "MET_DOUBLE"};
  return fmt::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = {}\n"
      "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 10 20 30\nElementSpacing = 1 2 3\nDimSize = 5 4 3\n"
      "ElementType = {}\n{}",
      endian == std::endian::big ? "True" : "False", names[int(type)], more);
}

/// Puts numbers at their offsets of a binary header.
class HeaderBytes {
 public:
  HeaderBytes(std::size_t size, std::endian endian) : bytes_(size, '\0'), endian_(endian) {}
  void put(std::size_t offset, double value, ScalarType type) {
    std::string raw;
    append_value(raw, value, type, endian_);
    bytes_.replace(offset, raw.size(), raw);
  }
  void put(std::size_t offset, const std::string& raw) { bytes_.replace(offset, raw.size(), raw); }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::endian endian_;
};

int nifti_code(ScalarType type) {
  static const int codes[] = {2, 256, 512, 4, 768, 8, 1280, 1024, 16, 64};
  return codes[int(type)];
}

}  // namespace

Sample nrrd(ScalarType type, std::endian endian) {
  return {"volume.nrrd", nrrd_header(type, endian, "raw") + "\n" + voxel_bytes(type, endian)};
}
Sample nrrd_gzip(ScalarType type, std::endian endian) {
  return {"volume.nrrd", nrrd_header(type, endian, "gzip") + "\n" + gzip(voxel_bytes(type, endian))};
}
Sample nrrd_detached(ScalarType type, std::endian endian) {
  return {"volume.nhdr", nrrd_header(type, endian, "raw") + "data file: the voxels.raw\n", "the voxels.raw",
          voxel_bytes(type, endian)};
}

Sample mha(ScalarType type, std::endian endian) {
  return {"volume.mha", meta_header(type, endian, "ElementDataFile = LOCAL\n") + voxel_bytes(type, endian)};
}
Sample mha_compressed(ScalarType type, std::endian endian) {
  const std::string voxels = voxel_bytes(type, endian);
  uLongf size = compressBound(voxels.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(voxels.data()),
           voxels.size());
  packed.resize(size);
  const std::string more =
      fmt::format("CompressedData = True\nCompressedDataSize = {}\nElementDataFile = LOCAL\n", size);
  return {"volume.mha", meta_header(type, endian, more) + packed};
}
Sample mhd(ScalarType type, std::endian endian) {
  return {"volume.mhd", meta_header(type, endian, "ElementDataFile = volume.raw\n"), "volume.raw",
          voxel_bytes(type, endian)};
}

std::string bytes_of(std::initializer_list<double> numbers, ScalarType type) {
  std::string bytes;
  for (const double number : numbers) append_value(bytes, number, type, std::endian::little);
  return bytes;
}

std::string with(std::string bytes, std::size_t at, const std::string& part) {
  return bytes.replace(at, part.size(), part);
}

std::string nifti_header(ScalarType type, std::endian endian, float slope, float intercept) {
  using enum ScalarType;
  HeaderBytes header(352, endian);
  header.put(0, 348, int32);
  const int dims[] = {3, 5, 4, 3, 1, 1, 1, 1};
  for (std::size_t i = 0; i < 8; ++i) header.put(40 + 2 * i, dims[i], int16);
  header.put(70, nifti_code(type), int16);
  header.put(72, double(8 * size_of(type)), int16);
  for (std::size_t i = 0; i < 4; ++i) header.put(76 + 4 * i, double(i == 0 ? 1 : i), float32);
  header.put(108, 352, float32);
  header.put(112, slope, float32);
  header.put(116, intercept, float32);
  header.put(252, 1, int16);  // the qform holds: no rotation, and this origin
  for (std::size_t i = 0; i < 3; ++i) header.put(268 + 4 * i, double(10 * (i + 1)), float32);
  header.put(344, std::string("n+1\0", 4));
  return header.bytes();
}

std::string nifti2_header() {
  using enum ScalarType;
  std::string header(544, '\0');
  header = with(header, 0, bytes_of({540}, int32));
  header = with(header, 4, std::string("n+2\0\r\n\x1a\n", 8));
  header = with(header, 12, bytes_of({4, 16}, int16));
  header = with(header, 16, bytes_of({3, 5, 4, 3, 1, 1, 1, 1}, int64));
  header = with(header, 104, bytes_of({1, 1, 2, 3}, float64));
  header = with(header, 168, bytes_of({544}, int64));
  return header;
}

Sample nifti(ScalarType type, std::endian endian) {
  return {"volume.nii", nifti_header(type, endian, 0, 5) + voxel_bytes(type, endian)};
}
Sample nifti_gzip(ScalarType type, std::endian endian) {
  return {"volume.nii.gz", gzip(nifti(type, endian).content)};
}
namespace {
std::string vtk_header(ScalarType type, const std::string& encoding) {
  static const char* const names[] = {"unsigned_char", "char",  "unsigned_short", "short",
                                      "unsigned_int",  "int",   "unsigned_long",  "long",
                                      "float",         "double"};
  return fmt::format(
      "# vtk DataFile Version 3.0\nsmall\n{}\nDATASET STRUCTURED_POINTS\nDIMENSIONS 5 4 3\nSPACING 1 2 3\n"
      "ORIGIN 10 20 30\nPOINT_DATA 60\nSCALARS values {} 1\nLOOKUP_TABLE default\n",
      encoding, names[int(type)]);
}
}  // namespace

Sample vtk(ScalarType type, std::endian) {
  return {"volume.vtk", vtk_header(type, "BINARY") + voxel_bytes(type, std::endian::big)};
}
Sample vtk_ascii(ScalarType type, std::endian) {
  std::string text = vtk_header(type, "ASCII");
  for (int i = 0; i < points; ++i)
    text += fmt::format("{}{}", stored_value(type, i), i % 5 == 4 ? "\n" : " ");
  return {"volume.vtk", text};
}

Sample mrc(ScalarType type, std::endian endian) {
  using enum ScalarType;
  HeaderBytes header(1024, endian);
  const int dims[] = {5, 4, 3};
  for (std::size_t i = 0; i < 3; ++i) {
    header.put(4 * i, dims[i], int32);
    header.put(28 + 4 * i, dims[i], int32);  // the cell's samples, and its size
    header.put(40 + 4 * i, double(dims[i]) * double(i + 1), float32);
    header.put(64 + 4 * i, double(i + 1), int32);  // the axes' order
    header.put(196 + 4 * i, double(10 * (i + 1)), float32);
  }
  header.put(12, type == int8 ? 0 : type == int16 ? 1 : type == float32 ? 2 : 6, int32);
  header.put(108, 20140, int32);
  header.put(208, "MAP ");
  header.put(212,
             endian == std::endian::big ? std::string("\x11\x11\0\0", 4) : std::string("\x44\x44\0\0", 4));
  return {"volume.mrc", header.bytes() + voxel_bytes(type, endian)};
}

std::string dicom_element(unsigned group, unsigned number, const std::string& vr, std::string value) {
  if (value.size() % 2 != 0) value += vr == "UI" || vr == "OB" ? '\0' : ' ';
  std::string out;
  const auto put16 = [&](std::size_t v) {
    append_value(out, double(v), ScalarType::uint16, std::endian::little);
  };
  put16(group);
  put16(number);
  out += vr;
  if (vr.starts_with("O") || vr == "SQ") {
    put16(0);
    append_value(out, double(value.size()), ScalarType::uint32, std::endian::little);
  } else {
    put16(value.size());
  }
  return out + value;
}

std::string dicom_us(int value) {
  std::string out;
  append_value(out, value, ScalarType::uint16, std::endian::little);
  return out;
}

std::string dicom_fragments(const std::vector<std::string>& parts) {
  std::string out("\xe0\x7f\x10\x00OB\0\0\xff\xff\xff\xff\xfe\xff\x00\xe0\0\0\0\0", 20);
  for (const std::string& part : parts) {
    out += std::string("\xfe\xff\x00\xe0", 4);
    append_value(out, double(part.size()), ScalarType::uint32, std::endian::little);
    out += part;
  }
  return out + std::string("\xfe\xff\xdd\xe0\0\0\0\0", 8);
}

std::string dicom_head(const std::string& sop_class, const std::string& instance, const std::string& syntax) {
  const std::string meta = dicom_element(2, 1, "OB", std::string("\0\1", 2)) +
                           dicom_element(2, 2, "UI", sop_class) + dicom_element(2, 3, "UI", instance) +
                           dicom_element(2, 0x10, "UI", syntax);
  std::string length;
  append_value(length, double(meta.size()), ScalarType::uint32, std::endian::little);
  std::string head(128, '\0');
  head += "DICM";
  return head + dicom_element(2, 0, "UL", length) + meta + dicom_element(8, 0x16, "UI", sop_class) +
         dicom_element(8, 0x18, "UI", instance);
}

std::string dicom_slice(int columns, int rows, double z, int number, const std::vector<std::int16_t>& pixels,
                        const std::string& slope, const std::string& intercept, const std::string& series) {
  const auto element = dicom_element;
  const auto us = dicom_us;
  std::string data;
  for (const std::int16_t pixel : pixels) append_value(data, pixel, ScalarType::int16, std::endian::little);
  return dicom_head("1.2.840.10008.5.1.4.1.1.2", fmt::format("{}.{}", series, number)) +
         element(8, 0x60, "CS", "CT") + element(0x18, 0x50, "DS", "9") + element(0x20, 0xd, "UI", "1.2") +
         element(0x20, 0xe, "UI", series) + element(0x20, 0x11, "IS", "1") +
         element(0x20, 0x13, "IS", std::to_string(number)) +
         element(0x20, 0x32, "DS", fmt::format("10\\20\\{}", z)) +
         element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0") + element(0x28, 2, "US", us(1)) +
         element(0x28, 4, "CS", "MONOCHROME2") + element(0x28, 0x10, "US", us(rows)) +
         element(0x28, 0x11, "US", us(columns)) + element(0x28, 0x30, "DS", "2\\1") +
         element(0x28, 0x100, "US", us(16)) + element(0x28, 0x101, "US", us(16)) +
         element(0x28, 0x102, "US", us(15)) + element(0x28, 0x103, "US", us(1)) +
         element(0x28, 0x1052, "DS", intercept) + element(0x28, 0x1053, "DS", slope) +
         element(0x7fe0, 0x10, "OW", data);
}

}  // namespace crest::test
