#include <fmt/core.h>
#include <zlib.h>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;

std::string legacy(const std::string& form, const std::string& rest) {
  return fmt::format(
      "# vtk DataFile Version 3.0\nx\n{}\nDATASET STRUCTURED_POINTS\nDIMENSIONS 5 4 3\nORIGIN 0 0 0\nSPACING "
      "1 2 3\n{}",
      form, rest);
}

std::string numbers(int count, int first) {
  std::string text;
  for (int i = 0; i < count; ++i) text += fmt::format("{} ", first + i);
  return text + "\n";
}

class VtkArrays : public FileTest {};

TEST_F(VtkArrays, CellsAndFieldsBeforeThePointsScalars) {
  const std::string rest = "CELL_DATA 24\nSCALARS c float 1\nLOOKUP_TABLE default\n" + numbers(24, 500) +
                           "POINT_DATA 60\nFIELD FieldData 2\nf 1 60 double\n" + numbers(60, 1000) +
                           "v 3 60 float\n" + numbers(180, 2000) + "SCALARS d short\nLOOKUP_TABLE default\n" +
                           numbers(60, 0);
  const std::string file = write("a.vtk", legacy("ASCII", rest));
  const Volume volume = load_volume(file);
  EXPECT_EQ(volume.values[59], 59.f);
  EXPECT_NE(volume.note.find("array d, one of f, v, d"), std::string::npos) << volume.note;
  EXPECT_EQ(load_volume(file + "?array=f").values[1], 1001.f);
  EXPECT_EQ(load_volume(file + "?array=v&component=2").values[1], 2005.f);
  expect_error(file + "?array=w", {"no array \"w\"", "f, v, d"});
}

TEST_F(VtkArrays, MarksOfHiddenPointsAreNoChoice) {
  const std::string fields = "POINT_DATA 60\nFIELD FieldData 2\nvtkGhostType 1 60 unsigned_char\n" +
                             numbers(60, 0) + "d 1 60 float\n" + numbers(60, 1000);
  const std::string file = write("a.vtk", legacy("ASCII", fields));
  const Volume volume = load_volume(file);
  EXPECT_EQ(volume.values[59], 1059.f);
  EXPECT_NE(volume.note.find("what vtkGhostType hides is shown"), std::string::npos) << volume.note;
  EXPECT_EQ(load_volume(file + "?array=vtkGhostType").values[59], 59.f);
}

TEST_F(VtkArrays, BinaryOnesAreSteppedOver) {
  std::string rest = "POINT_DATA 60\nVECTORS v short\n" + std::string(360, '\n') +
                     "\nSCALARS d short 1\nLOOKUP_TABLE default\n";
  const Volume volume = load_volume(write("b.vtk", legacy("BINARY", rest + voxel_bytes(int16, endian::big))));
  for (int i = 0; i < 60; ++i) EXPECT_EQ(volume.values[std::size_t(i)], float(stored_value(int16, i)));
}

TEST_F(VtkArrays, ColoursAsTextAreBytes) {
  std::string rest = "POINT_DATA 60\nCOLOR_SCALARS c 1\n";
  for (int i = 0; i < 60; ++i) rest += fmt::format("{:.6g} ", (i * 4 + 3) / 255.0);  // as VTK writes them
  const Volume volume = load_volume(write("a.vtk", legacy("ASCII", rest + "\n")));
  for (int i = 0; i < 60; ++i) EXPECT_EQ(volume.values[std::size_t(i)], float(i * 4 + 3));
  EXPECT_NE(volume.note.find("255 times"), std::string::npos) << volume.note;
  expect_error(path("a.vtk") + "?subtract=1", {"holds bytes", "subtract"});
  rest = "POINT_DATA 60\nCOLOR_SCALARS c 1\n" + voxel_bytes(uint8, endian::big);
  EXPECT_EQ(load_volume(write("b.vtk", legacy("BINARY", rest))).values[7], float(stored_value(uint8, 7)));
}

TEST_F(VtkArrays, NamesHaveTheirSpaces) {
  const std::string rest = "POINT_DATA 60\nSCALARS my%20name%25 float 1\nLOOKUP_TABLE default\n" +
                           numbers(60, 0) + "SCALARS 100% float 1\nLOOKUP_TABLE default\n" + numbers(60, 100);
  const std::string file = write("a.vtk", legacy("ASCII", rest));
  expect_error(file, {"my name%, 100%"});
  EXPECT_EQ(load_volume(file + "?array=my name%").values[1], 1.f);
}

TEST_F(VtkArrays, StringsOfAFieldAreSteppedOver) {
  const std::string field = "FIELD FieldData 2\nwords 1 3 string\n", after = "t 1 1 double\n",
                    scalars = "POINT_DATA 60\nSCALARS d short 1\nLOOKUP_TABLE default\n";
  std::string text =
      legacy("ASCII", field + "POINT_DATA%20x\n\nb\n" + after + "5\n" + scalars + numbers(60, 3));
  EXPECT_EQ(load_volume(write("a.vtk", text)).values[59], 62.f);
  const std::string longer(100, '\n'), lengths[] = {"\xc2", std::string("\x80\x64", 2)};
  text = legacy("BINARY", field + lengths[0] + "ab\xc0" + lengths[1] + longer + "\n" + after +
                              std::string(8, '\0') + "\n" + scalars + voxel_bytes(int16, endian::big));
  EXPECT_EQ(load_volume(write("b.vtk", text)).values[59], float(stored_value(int16, 59)));
}

TEST_F(VtkArrays, WhereNothingSaysWhichTheyAreListed) {
  const std::string rest =
      "POINT_DATA 60\nFIELD FieldData 2\np 1 60 float\n" + numbers(60, 0) + "q 1 60 float\n" + numbers(60, 9);
  expect_error(write("a.vtk", legacy("ASCII", rest)), {"2 arrays (p, q)", "?array=p"});
  const Volume cells = load_volume(write(
      "c.vtk", legacy("ASCII", "CELL_DATA 24\nSCALARS c float 1\nLOOKUP_TABLE default\n" + numbers(24, 0))));
  EXPECT_EQ(cells.grid, (Grid{{4, 3, 2}, {1, 2, 3}, {0.5, 1, 1.5}}));
}

std::string base64(const std::string& bytes) {
  static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j > bytes.size() ? '=' : digits[bits >> (18 - 6 * j) & 63];
  }
  return text;
}

std::string length(std::uint64_t value, bool wide, endian order) {
  std::string bytes;
  append_value(bytes, double(value), wide ? uint64 : uint32, order);
  return bytes;
}

/// The array compressed in blocks: what says their lengths, and they themselves.
std::pair<std::string, std::string> compressed(const std::string& bytes, std::size_t block, bool wide,
                                               endian order) {
  std::string head = length((bytes.size() + block - 1) / block, wide, order) + length(block, wide, order) +
                     length(bytes.size() % block, wide, order);
  std::string data;
  for (std::size_t i = 0; i < bytes.size(); i += block) {
    const std::string part = bytes.substr(i, block);
    uLongf size = compressBound(part.size());
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(part.data()),
             part.size());
    head += length(size, wide, order);
    data += packed.substr(0, size);
  }
  return {head, data};
}

std::string vti(const std::string& attributes, const std::string& array, const std::string& after = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" " + attributes +
         ">\n<ImageData WholeExtent=\"2 6 0 3 0 2\" Origin=\"10 20 30\" Spacing=\"1 2 3\">\n"
         "<Piece Extent=\"2 6 0 3 0 2\">\n<PointData Scalars=\"d\">\n" +
         array + "\n</PointData>\n</Piece>\n</ImageData>\n" + after + "</VTKFile>\n";
}

TEST_F(VtkArrays, XmlInEachOfItsForms) {
  int files = 0;
  for (const bool wide : {false, true}) {
    for (const endian order : {endian::little, endian::big}) {
      for (const std::size_t block : {0, 7, 100, 120, 1 << 15}) {  // VTK's own is longer than a small array
        const bool packed = block > 0;
        const std::string bytes = voxel_bytes(int16, order);
        const auto [head, data] = packed ? compressed(bytes, block, wide, order)
                                         : std::pair(length(bytes.size(), wide, order), bytes);
        const std::string attributes = fmt::format("byte_order=\"{}Endian\" header_type=\"UInt{}\"{}",
                                                   order == endian::big ? "Big" : "Little", wide ? 64 : 32,
                                                   packed ? " compressor=\"vtkZLibDataCompressor\"" : "");
        const std::string text = packed ? base64(head) + base64(data) : base64(head + data);
        const std::string open = "<DataArray type=\"Int16\" Name=\"d\" ";
        for (const std::string& content :
             {vti(attributes, open + "format=\"binary\">\n  " + text + "\n</DataArray>"),
              vti(attributes, open + "format=\"appended\" offset=\"3\"/>",
                  "<AppendedData encoding=\"raw\">\n_xyz" + head + data + "\n</AppendedData>\n"),
              vti(attributes, open + "format=\"appended\" offset=\"4\"/>",
                  "<AppendedData encoding=\"base64\">\n_AAAA" + text + "\n</AppendedData>\n")}) {
          SCOPED_TRACE(content.substr(0, 600));
          const Volume volume = load_volume(write("v.vti", content));
          EXPECT_EQ(volume.grid, (Grid{{5, 4, 3}, {1, 2, 3}, {12, 20, 30}}));
          for (int i = 0; i < 60; ++i)
            ASSERT_EQ(volume.values[std::size_t(i)], float(stored_value(int16, i)));
          ++files;
        }
      }
    }
  }
  EXPECT_EQ(files, 60);
}

TEST_F(VtkArrays, WhereTheAppendedDataBeginsMayLieAcrossTwoBlocksOfReading) {
  const std::string bytes = voxel_bytes(int16, endian::little);
  const std::string array = "<DataArray type=\"Int16\" Name=\"d\" format=\"appended\" offset=\"0\"/>",
                    open = "<AppendedData encoding=\"raw\">\n_",
                    after =
                        open + length(bytes.size(), false, endian::little) + bytes + "\n</AppendedData>\n";
  const std::size_t head = vti("", array, after).find(open);
  for (std::size_t cut = 0; cut <= open.size(); ++cut) {  // so many bytes of it are in the first block
    const std::string space((std::size_t(1) << 20) - head - cut, ' ');
    const Volume volume = load_volume(write("v.vti", vti("", array + space, after)));
    EXPECT_EQ(volume.values[59], float(stored_value(int16, 59))) << cut;
  }
}

TEST_F(VtkArrays, AFileThatIsCutIsRefusedAlsoWhereItsBeginIsAskedFor) {
  const std::string array = "<DataArray type=\"Int16\" Name=\"d\" format=\"appended\" offset=\"0\"/>",
                    bytes = voxel_bytes(int16, endian::little);
  const auto [head, blocks] = compressed(bytes, 40, false, endian::little);
  const auto cut_by_ten = [&](const std::string& attributes, const std::string& data) {
    std::string content = vti(attributes, array, "<AppendedData encoding=\"raw\">\n_" + data);
    content.resize(content.rfind("</VTKFile>") - 10);
    return write("cut.vti", content) + "?crop=:,:,0:2";
  };
  expect_error(cut_by_ten("", length(bytes.size(), false, endian::little) + bytes),
               {"after 110 of 120 bytes"});
  expect_error(cut_by_ten("compressor=\"vtkZLibDataCompressor\"", head + blocks),
               {"of its blocks", fmt::format("after {} of {} bytes", blocks.size() - 10, blocks.size())});
  const std::string endless = write("e.vti", vti("", array, "<AppendedData " + std::string(300000, ' ')));
  expect_error(endless, {"appended data has no begin"});
}

TEST_F(VtkArrays, XmlAsTextAndWhatIsWrongWithIt) {
  const std::string open = "<DataArray type=\"Float32\" Name=\"d\" format=\"ascii\">\n";
  const std::string other =
      "<DataArray type=\"Float32\" Name=\"e\" format=\"ascii\">" + numbers(60, 9) + "</DataArray>";
  const Volume volume = load_volume(write("t.vti", vti("", open + numbers(60, 0) + "</DataArray>" + other)));
  EXPECT_EQ(volume.values[59], 59.f);
  EXPECT_NE(volume.note.find("array d, one of d, e"), std::string::npos) << volume.note;
  expect_error(write("u.vti", vti("", open + numbers(59, 0) + "</DataArray>")), {"promises 60"});
  expect_error(write("u.vti", vti("", open + "1 2 x</DataArray>")), {"\"x\"", "line 7"});
  std::string damaged =
      vti("", open + "1 2 x</DataArray>\r\n&amp;\r\n</Bata>");  // lines as the file has them
  expect_error(write("u.vti", damaged), {"XML is damaged in line 9"});
  // In Latin-1, whose characters past ASCII are longer in UTF-8, by more than comes behind the numbers.
  std::string latin = vti("", open + "1 2 x</DataArray>");
  latin.replace(
      0, latin.find('\n'),
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><!-- " + std::string(100000, '\xe9') + " -->");
  expect_error(write("u.vti", latin), {"\"x\""});
  expect_error(write("u.vti", vti("", other + other).replace(0, 200, "")), {"u.vti"});
  expect_error(write("u.vti", vti("compressor=\"vtkLZ4DataCompressor\"",
                                  "<DataArray type=\"Int8\" Name=\"d\" "
                                  "format=\"binary\">AAAA</DataArray>")),
               {"vtkLZ4DataCompressor"});
  expect_error(
      write("u.vti", vti("", "<DataArray type=\"Int8\" Name=\"d\" format=\"binary\">AAAA</DataArray>")),
      {"u.vti", "array"});
}

/// A piece of the ramp x + 10 y + 100 z over points [x0, x1] of a 5x4x3 grid.
std::string ramp_piece(int x0, int x1, bool cells = false) {
  const int inner = cells ? 1 : 0;
  std::string values;
  for (int z = 0; z < 3 - inner; ++z)
    for (int y = 0; y < 4 - inner; ++y)
      for (int x = x0; x <= x1 - inner; ++x) values += fmt::format("{} ", x + 10 * y + 100 * z);
  const char* section = cells ? "CellData" : "PointData";
  return fmt::format(
      "<Piece Extent=\"{} {} 0 3 0 2\"><{}><DataArray type=\"Int16\" Name=\"d\" "
      "format=\"ascii\">{}</DataArray>"
      "</{}></Piece>\n",
      x0, x1, section, values, section);
}

std::string in_pieces(const std::string& pieces) {
  return "<VTKFile type=\"ImageData\">\n<ImageData WholeExtent=\"0 4 0 3 0 2\" Origin=\"10 20 30\" "
         "Spacing=\"1 2 3\">\n" +
         pieces + "</ImageData>\n</VTKFile>\n";
}

TEST_F(VtkArrays, XmlInSeveralPieces) {
  const Volume volume = load_volume(write("p.vti", in_pieces(ramp_piece(2, 4) + ramp_piece(0, 2))));
  EXPECT_EQ(volume.grid, (Grid{{5, 4, 3}, {1, 2, 3}, {10, 20, 30}}));
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 5; ++x) EXPECT_EQ(volume.at(x, y, z), float(x + 10 * y + 100 * z));
  EXPECT_NE(volume.note.find("2 pieces"), std::string::npos) << volume.note;
  const Volume cells =
      load_volume(write("c.vti", in_pieces(ramp_piece(0, 1, true) + ramp_piece(1, 4, true))));
  EXPECT_EQ(cells.grid, (Grid{{4, 3, 2}, {1, 2, 3}, {10.5, 21, 31.5}}));
  EXPECT_EQ(cells.at(3, 2, 1), 123.f);
  expect_error(write("gap.vti", in_pieces(ramp_piece(0, 1) + ramp_piece(3, 4))),
               {"leave points without a value", "(2, 0, 0)"});
  std::string other = ramp_piece(2, 4);
  other.replace(other.find("\"d\""), 3, "\"e\"");
  expect_error(write("other.vti", in_pieces(ramp_piece(0, 2) + other)), {"piece 2", "\"d\""});
}

}  // namespace
}  // namespace crest::test
