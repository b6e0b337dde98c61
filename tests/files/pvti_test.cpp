// Parallel VTK XML files: pieces in files of their own.
#include <fmt/core.h>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

/// The ramp x + 10 y + 100 z at points [x0, x1] of 5x4x3, or in cells, as a file.
std::string piece_file(int x0, int x1, const std::string& type = "Int16", bool cells = false) {
  const int inner = cells ? 1 : 0;
  std::string values;
  for (int z = 0; z < 3 - inner; ++z)
    for (int y = 0; y < 4 - inner; ++y)
      for (int x = x0; x <= x1 - inner; ++x) values += fmt::format("{} ", x + 10 * y + 100 * z);
  const std::string extent = fmt::format("{} {} 0 3 0 2", x0, x1), section = cells ? "CellData" : "PointData";
  return fmt::format(
      "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"{0}\"><Piece Extent=\"{0}\"><{1}>"
      "<DataArray type=\"{2}\" Name=\"d\" format=\"ascii\">{3}</DataArray>"
      "<DataArray type=\"UInt8\" Name=\"vtkGhostType\" format=\"ascii\">0</DataArray>"
      "</{1}></Piece></ImageData></VTKFile>",
      extent, section, type, values);
}

std::string piece(int x0, int x1, const std::string& file) {
  return fmt::format("<Piece Extent=\"{} {} 0 3 0 2\" Source=\"{}\"/>\n", x0, x1, file);
}

std::string whole(const std::string& pieces, bool cells = false) {
  return fmt::format(
      "<VTKFile type=\"PImageData\">\n<PImageData WholeExtent=\"0 4 0 3 0 2\" GhostLevel=\"1\" Origin=\"10 "
      "20 "
      "30\" Spacing=\"1 2 3\">\n<{0}><PDataArray type=\"Int16\" Name=\"d\"/>"
      "<PDataArray type=\"UInt8\" Name=\"vtkGhostType\"/></{0}>\n{1}</PImageData></VTKFile>\n",
      cells ? "PCellData" : "PPointData", pieces);
}

class Pvti : public FileTest {
 protected:
  void SetUp() override {
    write("parts/a.vti", piece_file(0, 3));  // it has a layer more than its piece: ghosts
    write("parts/b.vti", piece_file(2, 4));
  }
};

TEST_F(Pvti, PiecesBecomeTheWholeGrid) {
  const std::string file =
      write("w.pvti", whole(piece(0, 2, "parts/a.vti") + piece(2, 4, path("parts/b.vti"))));
  const Volume volume = load_volume(file);
  EXPECT_EQ(volume.grid, (Grid{{5, 4, 3}, {1, 2, 3}, {10, 20, 30}}));
  EXPECT_EQ(volume.file_type, ScalarType::int16);
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 5; ++x) EXPECT_EQ(volume.at(x, y, z), float(x + 10 * y + 100 * z));
  EXPECT_NE(volume.note.find("2 files"), std::string::npos) << volume.note;
  const Volume part = load_volume(file + "?crop=1:,1:3,1:3&stride=2,1,1");
  EXPECT_EQ(part.grid, (Grid{{2, 2, 2}, {2, 2, 3}, {11, 22, 33}}));
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x)
        EXPECT_EQ(part.at(x, y, z), float(1 + 2 * x + 10 * (y + 1) + 100 * (z + 1)));
}

TEST_F(Pvti, HundredsOfFilesMayShareALayer) {
  constexpr int side = 20;  // pieces of 3x3x2 points, which share those at their sides
  std::string pieces;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const std::string extent = fmt::format("{} {} {} {} 0 1", 2 * i, 2 * i + 2, 2 * j, 2 * j + 2),
                        file = fmt::format("p{}_{}.vti", i, j);
      std::string values = std::string("\x24\0\0\0", 4);
      for (int k = 0; k < 18; ++k)
        append_value(values, 2 * i + k % 3 + 100 * (2 * j + k / 3 % 3) + 5000 * (k / 9), ScalarType::int16,
                     std::endian::little);
      write(file, fmt::format("<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"{0}\"><Piece "
                              "Extent=\"{0}\"><PointData><DataArray type=\"Int16\" Name=\"d\" "
                              "format=\"appended\" offset=\"0\"/></PointData></Piece></ImageData>"
                              "<AppendedData encoding=\"raw\">_",
                              extent) +
                      values + "</AppendedData></VTKFile>");
      pieces += fmt::format("<Piece Extent=\"{}\" Source=\"{}\"/>", extent, file);
    }
  }
  std::string content = whole(pieces);
  content.replace(content.find("0 4 0 3 0 2"), 11, "0 40 0 40 0 1");
  const Volume volume = load_volume(write("many.pvti", content));
  ASSERT_EQ(volume.grid.dims, glm::ivec3(41, 41, 2));
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 41; ++y)
      for (int x = 0; x < 41; ++x) ASSERT_EQ(volume.at(x, y, z), float(x + 100 * y + 5000 * z));
}

TEST_F(Pvti, CellsDoNotOverlap) {
  write("c0.vti", piece_file(0, 1, "Int16", true));
  write("c1.vti", piece_file(1, 4, "Int16", true));
  const Volume cells =
      load_volume(write("c.pvti", whole(piece(0, 1, "c0.vti") + piece(1, 4, "c1.vti"), true)));
  EXPECT_EQ(cells.grid, (Grid{{4, 3, 2}, {1, 2, 3}, {10.5, 21, 31.5}}));
  EXPECT_EQ(cells.at(3, 2, 1), 123.f);
  EXPECT_EQ(cells.at(0, 2, 1), 120.f);
}

TEST_F(Pvti, WhatIsWrongWithAPieceIsSaid) {
  const std::string a = piece(0, 2, "parts/a.vti"), b = piece(2, 4, "parts/b.vti");
  const auto expect = [&](const std::string& pieces, const std::vector<std::string>& parts) {
    expect_error(write("w.pvti", whole(pieces)), parts);
  };
  expect(a + piece(2, 4, "parts/missing.vti"), {"piece 2", "parts/missing.vti", "not there"});
  expect(a + "<Piece Extent=\"2 4 0 3 0 2\"/>", {"piece 2", "names no file"});
  expect(a + piece(3, 5, "parts/b.vti"), {"piece 2", "whole extent"});
  expect(a + piece(0, 4, "parts/b.vti"), {"b.vti", "other points"});
  expect(a, {"without a value", "(3, 0, 0)"});
  expect(b, {"without a value", "(0, 0, 0)"});
  expect("", {"no pieces"});
  write("parts/f.vti", piece_file(2, 4, "Float32"));
  expect(a + piece(2, 4, "parts/f.vti"), {"f.vti", "\"d\"", "not the same"});
  std::string other = piece_file(2, 4);
  other.replace(other.find("\"d\""), 3, "\"e\"");
  write("parts/e.vti", other);
  expect(a + piece(2, 4, "parts/e.vti"), {"e.vti", "no array \"d\""});
  write("parts/x.vti", "PK");
  expect(a + piece(2, 4, "parts/x.vti"), {"x.vti", "not a VTK XML file"});
  expect(a + piece(2, 4, "w.pvti"), {"PImageData"});  // itself
  expect_error(path("w.pvti") + "?array=e", {"no array \"e\""});
}

}  // namespace
}  // namespace crest::test
