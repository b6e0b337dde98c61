// Files of voxels that are right, in each of their forms.
#include <fmt/core.h>

#include <bit>
#include <initializer_list>

#include "tests/files/files.h"
#include "tests/fuzz/target_list.h"

namespace crest::fuzz {
namespace {

using enum ScalarType;
using std::endian;
using namespace crest::test;

std::string numbers(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += fmt::format("{}{}", i % 7 == 0 ? i * 0.5 : i, i % 9 == 8 ? "\n" : " ");
  return text;
}

}  // namespace

std::vector<std::string> nrrd_seeds() {
  const std::string small =
      "NRRD0005\ntype: short\ndimension: 4\nsizes: 2 5 4 3\nspace: RAS\nencoding: ascii\n";
  return {
      nrrd(uint8, endian::little).content,
      nrrd(float64, endian::big).content,
      nrrd_gzip(int16, endian::little).content,
      small +
          "space directions: none (1,0,0) (0,2,0) (0,0,3)\nspace origin: (7,8,9)\nspace units: \"mm\" \"mm\" "
          "\"mm\"\n\n" +
          [] {
            std::string text;
            for (int i = 0; i < 120; ++i) text += fmt::format("{} ", i);
            return text;
          }(),
      "NRRD0001\n# a comment\ntype: unsigned char\ndimension: 3\nsizes: 5 4 3\nspacings: 1 2 nan\naxis mins: "
      "0 1 2\n"
      "kinds: domain domain domain\ncenters: cell cell node\nkey:=value\nencoding: hex\nbyte skip: 2\n\nxx" +
          [] {
            std::string text;
            for (int i = 0; i < points; ++i) text += fmt::format("{:02x}", i);
            return text;
          }(),
      "NRRD0004\ntype: float\ndimension: 4\nsizes: 3 3 3 2\nthicknesses: 1 1 1 nan\nlabels: \"x\" \"y\" "
      "\"z\" \"t\"\n"
      "line skip: 1\nendian: little\nencoding: raw\n\na line\n" +
          voxel_bytes(float32, endian::little, 54)};
}

std::vector<std::string> nhdr_seeds() {
  const std::string head =
      "NRRD0004\ntype: double\ndimension: 3\nsizes: 5 4 3\nendian: little\nencoding: raw\n";
  return {head + "data file: voxels.raw\n", head + "byte skip: -1\ndata file: voxels.raw\n",
          "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 4 3\nencoding: raw\nbyte skip: 8\nline skip: "
          "0\ndatafile: ./voxels.raw\n",
          "NRRD0004\ntype: double\ndimension: 3\nsizes: 5 4 6\nendian: little\nencoding: raw\ndata file: "
          "LIST\nvoxels.raw\nvoxels.raw\n"};
}

std::vector<std::string> mha_seeds() {
  return {
      mha(uint16, endian::big).content, mha_compressed(int32, endian::little).content,
      "ObjectType = Image\nComment = none\nNDims = 4\nBinaryData = False\nElementNumberOfChannels = 1\n"
      "CenterOfRotation = 0 0 0 0\nAnatomicalOrientation = RAI\nElementSpacing = 1 2 3 1\nDimSize = 3 3 3 2\n"
      "ElementSize = 1 1 1 1\nElementMin = 0\nElementMax = 99\nElementType = MET_FLOAT\nElementDataFile = "
      "LOCAL\n" +
          numbers(54)};
}

std::vector<std::string> mhd_seeds() {
  const std::string head = "ObjectType = Image\nNDims = 3\nDimSize = 5 4 3\nElementType = MET_UCHAR\n";
  return {
      head + "HeaderSize = 8\nElementDataFile = voxels.raw\n",
      head + "HeaderSize = -1\nElementDataFile = voxels.raw\n",
      "ObjectType = Image\nNDims = 3\nDimSize = 5 4 3\nElementNumberOfChannels = 2\nElementType = MET_INT\n"
      "ElementByteOrderMSB = True\nElementDataFile = voxels.raw\n",
      "NDims = 3\nDimSize = 5 4 6\nElementType = MET_DOUBLE\nElementDataFile = LIST "
      "2D\nvoxels.raw\nvoxels.raw\n"};
}

std::vector<std::string> nifti_seeds() {
  const std::string second = nifti2_header();
  std::string film = nifti_header(uint8, endian::little, 2, -1);
  film = with(film, 40, bytes_of({4, 5, 4, 3, 2}, int16));
  std::string sheared = nifti_header(int16, endian::little, 1, 0);
  sheared = with(sheared, 254, bytes_of({1}, int16));
  sheared = with(sheared, 280, bytes_of({1, 0, 1, 5, 0, 2, 0, 6, 0, 0, 3, 7}, float32));
  const std::string colours = with(nifti_header(uint8, endian::little, 1, 0), 70, bytes_of({128, 24}, int16));
  return {nifti(float32, endian::big).content,          nifti_gzip(int16, endian::little).content,
          second + voxel_bytes(int16, endian::little),  film + voxel_bytes(uint8, endian::little, 2 * points),
          sheared + voxel_bytes(int16, endian::little), colours + std::string(3 * points, 'c')};
}

std::vector<std::string> analyze_seeds() {
  std::string head =
      with(nifti_header(int16, endian::little, 1, 0).substr(0, 348), 108, bytes_of({0}, float32));
  return {with(head, 344, std::string(4, '\0')), with(head, 344, std::string("ni1\0", 4))};
}

std::vector<std::string> mrc_seeds() {
  const std::string plain = mrc(int16, endian::little).content;
  std::string stack = mrc(int8, endian::little).content;
  stack =
      with(with(stack, 8, bytes_of({6}, int32)), 36, bytes_of({3}, int32));  // two volumes of three slices
  stack = with(stack, 88, bytes_of({401}, int32));
  const std::string half = with(mrc(int16, endian::little).content, 12, bytes_of({12}, int32));
  return {plain,
          mrc(float32, endian::big).content,
          with(plain, 64, bytes_of({3, 1, 2}, int32)),  // other axes
          with(plain, 212, std::string(4, '\0')),       // no stamp
          stack + voxel_bytes(int8, endian::little),
          half};
}

std::vector<std::string> vtk_seeds() {
  const std::string grid = "DATASET STRUCTURED_POINTS\nDIMENSIONS 5 4 3\nSPACING 1 2 3\nORIGIN 10 20 30\n";
  return {vtk(int16, endian::big).content, vtk_ascii(float32, endian::big).content,
          "# vtk DataFile Version 3.0\nsmall\nASCII\n" + grid +
              "CELL_DATA 24\nSCALARS c float 1\nLOOKUP_TABLE default\n" + numbers(24) +
              "POINT_DATA 60\nFIELD FieldData 2\nf 1 60 double\n" + numbers(60) + "v 3 60 float\n" +
              numbers(180) + "METADATA\nINFORMATION 0\n\nVECTORS w float\n" + numbers(180) +
              "SCALARS d float\nLOOKUP_TABLE t\n" + numbers(60) + "LOOKUP_TABLE t 2\n0 0 0 1\n1 1 1 1\n",
          "# vtk DataFile Version 5.1\nx\nBINARY\n" + grid + "POINT_DATA 60\nVECTORS v short\n" +
              std::string(360, '\n') + "\nSCALARS d short 1\nLOOKUP_TABLE default\n" +
              voxel_bytes(int16, endian::big)};
}

namespace {

/// A VTK XML file of two arrays in the points.
std::string vti(const std::string& attributes, const std::string& array, const std::string& after = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" " + attributes +
         ">\n<ImageData WholeExtent=\"2 6 0 3 0 2\" Origin=\"10 20 30\" Spacing=\"1 2 3\" Direction=\"1 0 0 "
         "0 1 0 0 0 1\">\n"
         "<Piece Extent=\"2 6 0 3 0 2\">\n<PointData Scalars=\"d\">\n<DataArray Name=\"d\" " +
         array + "</DataArray>\n</PointData>\n</Piece>\n</ImageData>\n" + after + "</VTKFile>\n";
}

}  // namespace

std::vector<std::string> vti_seeds() {
  const std::string order = "byte_order=\"LittleEndian\" header_type=\"UInt32\"", text = numbers(points);
  const std::string raw = bytes_of({2 * points}, uint32) + voxel_bytes(int16, endian::little);
  const std::string mha_file = mha_compressed(int16, endian::little).content;
  const std::string stream = mha_file.substr(mha_file.find("LOCAL\n") + 6);
  const std::string blocks = bytes_of({1, 1 << 15, 2 * points, double(stream.size())}, uint32) + stream;
  const std::string appended = "type=\"Int16\" format=\"appended\" offset=\"0\">";
  const auto behind = [](const std::string& bytes) {
    return "<AppendedData encoding=\"raw\">\n_" + bytes + "\n</AppendedData>\n";
  };
  const std::string zeros_in_base64 = "PAAA" + std::string(80, 'A') + "AA==";
  const std::string half = numbers(40);
  return {vti(order, "type=\"Float32\" format=\"ascii\">" + text),
          vti(order, "type=\"UInt8\" format=\"binary\">" + zeros_in_base64),
          vti(order, appended, behind(raw)),
          vti(order + " compressor=\"vtkZLibDataCompressor\"", appended, behind(blocks)),
          "<VTKFile type=\"ImageData\" byte_order=\"BigEndian\"><ImageData WholeExtent=\"0 4 0 3 0 2\">"
          "<Piece Extent=\"0 4 0 3 0 1\"><CellData/><PointData><DataArray type=\"Float64\" Name=\"d\" "
          "format=\"ascii\">" +
              half +
              "</DataArray></PointData></Piece><Piece Extent=\"0 4 0 3 1 2\"><PointData><DataArray "
              "type=\"Float64\" "
              "Name=\"d\" format=\"ascii\">" +
              half + "</DataArray></PointData></Piece></ImageData></VTKFile>"};
}

std::vector<std::string> pvti_seeds() {
  const std::string head =
      "<VTKFile type=\"PImageData\"><PImageData WholeExtent=\"2 6 0 3 0 2\" GhostLevel=\"1\" "
      "Spacing=\"1 2 3\"><PPointData Scalars=\"d\"><PDataArray type=\"Float32\" Name=\"d\"/></PPointData>";
  const std::string tail = "</PImageData></VTKFile>";
  return {head + "<Piece Extent=\"2 6 0 3 0 2\" Source=\"piece.vti\"/>" + tail,
          head +
              "<Piece Extent=\"2 4 0 3 0 2\" Source=\"piece.vti\"/><Piece Extent=\"4 6 0 3 0 2\" "
              "Source=\"./piece.vti\"/>" +
              tail};
}

std::vector<std::string> npy_seeds() {
  const auto npy = [](const std::string& dictionary, const std::string& data, bool second = false) {
    std::string head = "\x93NUMPY";
    head += char(second ? 2 : 1);
    head += '\0';
    append_value(head, double(dictionary.size()), second ? uint32 : uint16, endian::little);
    return head + dictionary + data;
  };
  return {npy("{'descr': '>i2', 'fortran_order': False, 'shape': (3, 4, 5), }\n",
              voxel_bytes(int16, endian::big)),
          npy("{'descr': '<f8', 'fortran_order': True, 'shape': (3, 4, 5), }\n",
              voxel_bytes(float64, endian::little), true),
          npy("{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, 4, 5), }", std::string(120, 'x')),
          npy("{'descr': '<f2', 'fortran_order': False, 'shape': (3, 4, 5, 3), }", std::string(360, 'x'))};
}

std::vector<std::string> raw_seeds() {
  return {"size=5x4x3&type=float64\n{}",
          "\n{\"size\": [5, 4, 3], \"type\": \"int16\", \"offset\": 360, \"spacing\": [1, 2, 0.5]}",
          "spacing=1,2,3&origin=0,0,-1\n{\"size\": \"5x4x3\", \"type\": \"float32\", \"endian\": \"big\", "
          "\"offset\": 240}"};
}

std::vector<std::string> dicom_seeds() {
  const std::vector<std::int16_t> pixels(12, 70);
  const std::string head = dicom_head("1.2.840.10008.5.1.4.1.1.7.4", "1.2.3.4", "1.2.840.10008.1.2.4.90") +
                           dicom_element(0x28, 0x10, "US", dicom_us(3)) +
                           dicom_element(0x28, 0x11, "US", dicom_us(4));
  std::string fragments("\xe0\x7f\x10\x00OB\0\0\xff\xff\xff\xff\xfe\xff\x00\xe0\0\0\0\0",
                        20);  // an empty table of offsets
  fragments += std::string("\xfe\xff\x00\xe0\4\0\0\0abcd\xfe\xff\xdd\xe0\0\0\0\0", 20);
  const std::string item = dicom_element(0x20, 0x32, "DS", "1\\2\\3");
  std::string open("\xfe\xff\x00\xe0\xff\xff\xff\xff", 8), closed("\xfe\xff\x00\xe0", 4);
  open += item + std::string("\xfe\xff\x0d\xe0\0\0\0\0", 8);
  closed += bytes_of({double(item.size())}, uint32) + item;
  return {dicom_slice(4, 3, 2.5, 1, pixels), head + fragments,
          head + dicom_element(0x5200, 0x9230, "SQ", open + closed) + fragments,
          dicom_slice(4, 3, 0, 2, pixels, "2", "-10")};
}

std::vector<std::string> dicom_pixel_seeds() {
  const auto segments = [](std::uint32_t first, std::uint32_t second) {
    std::string head = bytes_of({2, double(first), double(second)}, ScalarType::uint32);
    head.resize(64, '\0');
    return head;
  };
  return {"2 2 1 16 16 15 0 0 1 1 3 0\n" + segments(64, 69) + "\3abcd\xfdx",
          "5 3 1 1 1 0 0 0 3 1 0 0\nabcdef",
          "5 3 1 16 12 13 1 0 2 2 0 0\n" + std::string(60, 'p'),
          "2 2 3 8 8 7 0 1 2 1 0 0\n" + std::string(24, 'p'),
          "4 2 3 16 12 11 0 0 2 2 0 1\n" + std::string(64, 'p'),
          "2 2 1 32 32 31 0 0 1 1 1 0\n" + std::string(16, 'p')};
}

}  // namespace crest::fuzz
