#include <OpenImageIO/imageio.h>
#include <fmt/core.h>
#include <tiffio.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <functional>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;

/// An uncompressed little-endian TIFF of one strip a page.
class TiffBytes {
 public:
  int bits = 8, photometric = 1, width = 4, height = 3;
  bool has_palette = false;
  std::string description;

  std::string file(const std::vector<std::string>& pages) const {
    std::string out = "II*";
    out += '\0';
    std::size_t link = out.size();
    put(out, 0, uint32);
    for (const std::string& data : pages) {
      const std::size_t data_at = out.size(), text_at = data_at + data.size();
      out += data + description + std::string(1, '\0');
      if (out.size() % 2 != 0) out += '\0';
      const std::size_t palette_at = out.size();
      for (int color = 0; has_palette && color < 3 << bits; ++color) put(out, 65535 - 77 * color, uint16);
      if (out.size() % 2 != 0) out += '\0';
      std::string here;
      put(here, double(out.size()), uint32);
      out.replace(link, 4, here);
      std::vector<std::array<double, 4>> entries = {
          {256, 3, 1, double(width)},       {257, 3, 1, double(height)},
          {258, 3, 1, double(bits)},        {259, 3, 1, 1},
          {262, 3, 1, double(photometric)}, {270, 2, double(description.size() + 1), double(text_at)},
          {273, 4, 1, double(data_at)},     {277, 3, 1, 1},
          {278, 3, 1, double(height)},      {279, 4, 1, double(data.size())}};
      if (has_palette) entries.push_back({320, 3, double(3 << bits), double(palette_at)});
      put(out, double(entries.size()), uint16);
      for (const auto& [tag, type, count, value] : entries) {
        put(out, tag, uint16);
        put(out, type, uint16);
        put(out, count, uint32);
        put(out, value, uint32);
      }
      link = out.size();
      put(out, 0, uint32);
    }
    return out;
  }

 private:
  static void put(std::string& out, double value, ScalarType type) {
    append_value(out, value, type, endian::little);
  }
};

struct Parts {
  int width, height;
  bool tiled, planes;
};

/// A page of three 16-bit channels in tiles of 16x16 or strips of 5 rows. `value` is asked beyond the image,
/// too.
void write_parts(TIFF* tiff, Parts parts, const std::function<std::uint16_t(int, int, int)>& value) {
  constexpr int side = 16, rows = 5;
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, parts.width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, parts.height);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, parts.planes ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
  if (parts.tiled) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, side);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, side);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rows);
  }
  const int wide = parts.tiled ? side : parts.width, high = parts.tiled ? side : rows;
  std::uint32_t index = 0;
  for (int plane = 0; plane < (parts.planes ? 3 : 1); ++plane) {
    for (int top = 0; top < parts.height; top += high) {
      for (int left = 0; left < parts.width; left += wide, ++index) {
        std::vector<std::uint16_t> part;
        const int lines = parts.tiled ? high : std::min(high, parts.height - top);
        for (int y = top; y < top + lines; ++y)
          for (int x = left; x < left + wide; ++x)
            for (int c = 0; c < (parts.planes ? 1 : 3); ++c) part.push_back(value(plane + c, x, y));
        const auto size = tmsize_t(2 * part.size());
        EXPECT_EQ(parts.tiled ? TIFFWriteEncodedTile(tiff, index, part.data(), size)
                              : TIFFWriteEncodedStrip(tiff, index, part.data(), size),
                  size);
      }
    }
  }
  TIFFWriteDirectory(tiff);
}

class TiffValues : public FileTest {
 protected:
  /// Pages of 8-bit pixels: 20 page + pixel.
  static std::vector<std::string> pages(int count) {
    std::vector<std::string> all;
    for (int page = 0; page < count; ++page) {
      all.emplace_back();
      for (int i = 0; i < 12; ++i) all.back() += char(20 * page + i);
    }
    return all;
  }
};

TEST_F(TiffValues, PalettesKeepTheNumbersOfTheirColours) {
  TiffBytes tiff;
  tiff.photometric = 3;
  tiff.has_palette = true;
  const Volume volume = load_volume(write("palette.tif", tiff.file(pages(3))));
  for (int i = 0; i < 36; ++i) EXPECT_EQ(volume.values[std::size_t(i)], float(20 * (i / 12) + i % 12));
  EXPECT_NE(volume.note.find("numbers of colours"), std::string::npos) << volume.note;
}

// Tiles of 16x16, which stand out over the image at its right and lower edge, and planes of each channel.
TEST_F(TiffValues, TilesAndPlanesAreJoined) {
  constexpr int width = 21, height = 18;
  const auto value = [](int page, int channel, int x, int y) {
    return std::uint16_t(1000 * page + 7000 * channel + 40 * y + x);
  };
  for (const bool tiled : {false, true}) {
    for (const bool planes : {false, true}) {
      SCOPED_TRACE(fmt::format("tiled {} planes {}", tiled, planes));
      const std::string file = write("parts.tif", "");
      TIFF* tiff = TIFFOpen(file.c_str(), "w");
      ASSERT_NE(tiff, nullptr);
      for (int page = 0; page < 2; ++page) {
        write_parts(tiff, {width, height, tiled, planes}, [&](int channel, int x, int y) {
          return x < width && y < height ? value(page, channel, x, y) : std::uint16_t(0xdead);
        });
      }
      TIFFClose(tiff);
      for (int channel = 0; channel < 3; ++channel) {
        const Volume volume = load_volume(fmt::format("{}?component={}", file, channel));
        EXPECT_EQ(volume.grid.dims, glm::ivec3(width, height, 2));
        for (int page = 0; page < 2; ++page)
          for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
              ASSERT_EQ(volume.at(x, y, page), float(value(page, channel, x, y)));
      }
    }
  }
}

TEST_F(TiffValues, MinIsWhiteKeepsWhatIsStored) {
  TiffBytes tiff;
  for (const int photometric : {0, 1}) {
    tiff.photometric = photometric;
    const Volume volume = load_volume(write("a.tif", tiff.file(pages(3))));
    EXPECT_EQ(volume.at(3, 2, 2), 51.f);
    EXPECT_EQ(volume.note.find("MINISWHITE") != std::string::npos, photometric == 0) << volume.note;
  }
}

TEST_F(TiffValues, NumbersOfFewBitsAreNotScaled) {
  for (const int bits : {1, 2, 4, 10, 12, 14}) {
    TiffBytes tiff;
    tiff.bits = bits;
    std::vector<std::string> packed;
    for (int page = 0; page < 2; ++page) {
      std::string data;
      for (int y = 0; y < 3; ++y) {
        std::uint64_t row = 0;
        for (int x = 0; x < 4; ++x)
          row = row << bits | std::uint64_t((11 * page + 4 * y + x) * 113 % (1 << bits));
        const int bytes = (4 * bits + 7) / 8;
        row <<= 8 * bytes - 4 * bits;
        for (int b = bytes - 1; b >= 0; --b) data += char(row >> (8 * b) & 0xff);
      }
      packed.push_back(data);
    }
    const Volume volume = load_volume(write("few.tif", tiff.file(packed)));
    EXPECT_EQ(volume.file_type, bits > 8 ? uint16 : uint8);
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i)
          EXPECT_EQ(volume.at(i, j, k), float((11 * k + 4 * j + i) * 113 % (1 << bits))) << bits;
  }
}

TEST_F(TiffValues, ImageJsChannelsAndFramesAreTakenApart) {
  TiffBytes tiff;
  tiff.description =
      "ImageJ=1.53t\nimages=12\nchannels=2\nslices=3\nframes=2\nhyperstack=true\nspacing=3\nunit=um\n";
  const std::string file = write("hyper.tif", tiff.file(pages(12)));
  expect_error(file, {"2 components"});
  expect_error(file + "?component=0", {"2 frames"});
  const Volume volume = load_volume(file + "?component=1&frame=1");
  EXPECT_EQ(volume.grid.dims, glm::ivec3(4, 3, 3));
  EXPECT_EQ(volume.grid.spacing.z, 3);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(volume.at(1, 0, k), float(20 * (6 + 2 * k + 1) + 1));
  expect_error(write("few.tif", tiff.file(pages(11))), {"12 images", "11"});
}

TEST_F(TiffValues, WhatIsRoundedCountsInAllPages) {
  TiffBytes tiff;
  tiff.bits = 32;
  std::vector<std::string> large(3);
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 12; ++i)  // odd ones in the second page, even ones in the others
      append_value(large[std::size_t(k)], double(1 << 24) + 24 * k + 2 * i + k % 2, uint32, endian::little);
  const std::string file = write("large.tif", tiff.file(large)), note = load_volume(file).note;
  EXPECT_NE(note.find("rounds 12 voxels by up to 1"), std::string::npos) << note;
  EXPECT_NE(note.find("?subtract=16777216 keeps"), std::string::npos) << note;
  EXPECT_EQ(load_volume(file + "?subtract=16777216").at(3, 0, 1), 31.f);
  const std::string first = load_volume(file + "?stride=1,1,2").note;
  EXPECT_EQ(first.find("rounds"), std::string::npos) << first;  // what is not taken is not counted
}

TEST_F(TiffValues, NumbersThatOverflowToThePagesAreRefused) {
  TiffBytes tiff;  // their product is 2^64 + 34
  tiff.description = "ImageJ=1.53t\nchannels=1128506\nslices=1500025\nframes=10897261\n";
  expect_error(write("wrap.tif", tiff.file(pages(34))), {"1500025 slices", "the file has 34"});
}

TEST_F(TiffValues, OmesPlanesAreTakenApart) {
  TiffBytes tiff;
  tiff.description =
      "<?xml version=\"1.0\"?><OME><Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"4\" SizeY=\"3\" "
      "SizeZ=\"3\" SizeC=\"2\" "
      "SizeT=\"1\" PhysicalSizeX=\"0.5\" PhysicalSizeY=\"0.5\" PhysicalSizeZ=\"2000\" "
      "PhysicalSizeZUnit=\"nm\">"
      "<TiffData/></Pixels></Image></OME>";
  const std::string file = write("a.ome.tif", tiff.file(pages(6)));
  expect_error(file, {"2 components"});
  const Volume volume = load_volume(file + "?component=1");
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(0.5, 0.5, 2));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(volume.at(1, 0, k), float(20 * (3 + k) + 1));
  expect_error(write("b.ome.tif", tiff.file(pages(5))), {"6 planes", "5 pages"});
}

TEST_F(TiffValues, AFoldersFilesOfSeveralPagesAreJoined) {
  const TiffBytes tiff;
  write("f/a10.tif", tiff.file(pages(5)));
  write("f/a2.tif", tiff.file(pages(2)));
  const Volume volume = load_volume(path("f"));
  EXPECT_EQ(volume.grid.dims.z, 7);
  EXPECT_EQ(volume.at(0, 0, 2), 0.f);
  EXPECT_EQ(volume.at(0, 0, 6), 80.f);
  EXPECT_NE(volume.note.find("2 files with several pages"), std::string::npos) << volume.note;
  TiffBytes wide;
  wide.width = 3, wide.height = 4;
  write("f/a3.tif", wide.file(pages(2)));
  expect_error(path("f"), {"a3.tif", "3x4"});
}

// In the processor time that the reader has for so short a file.
TEST_F(TiffValues, ThousandsOfPagesAreRead) {
  constexpr int count = 8000;
  const std::string file = write("many.tif", TiffBytes().file(pages(count)));
  const Volume all = load_volume(file);
  ASSERT_EQ(all.grid.dims, glm::ivec3(4, 3, count));
  for (int k = 0; k < count; ++k) ASSERT_EQ(all.at(1, 2, k), float((20 * k + 9) % 256)) << k;
  const Volume some = load_volume(file + "?stride=1,1,7");
  for (int k = 0; k < some.grid.dims.z; ++k) ASSERT_EQ(some.at(1, 2, k), all.at(1, 2, 7 * k)) << k;
}

TEST_F(TiffValues, DataThatIsShorterThanPromisedIsRefused) {
  const TiffBytes tiff;
  std::vector<std::string> cut = pages(3);
  cut[1].resize(7);
  expect_error(write("short.tif", tiff.file(cut)), {"page 2"});
}

TEST_F(TiffValues, NetpbmsGreatestValueScalesNothing) {
  for (int page = 0; page < 2; ++page) {
    write(fmt::format("pgm/{}.pgm", page),
          fmt::format("P2\n# a comment\n3 2\n4095\n0 457 1 2 {} 4095\n", page));
    std::string binary = "P5 3 2 1000\n";
    for (const int v : {0, 457, 1, 2, page, 1000}) append_value(binary, v, uint16, endian::big);
    write(fmt::format("binary/{}.pgm", page), binary);
  }
  for (const char* folder : {"pgm", "binary"}) {
    const Volume volume = load_volume(path(folder));
    EXPECT_EQ(volume.at(1, 0, 0), 457.f) << folder;
    EXPECT_EQ(volume.at(1, 1, 1), 1.f) << folder;
  }
}

TEST_F(TiffValues, ANetpbmFileOfSeveralImagesIsRefused) {
  for (const char* name : {"pgm/0.pgm", "pgm/1.pgm"}) write(name, "P5 2 2 255\nabcd\nP5 2 2 255\nefgh\n");
  expect_error(path("pgm"), {"0.pgm", "several images"});
  for (const char* name : {"pgm/0.pgm", "pgm/1.pgm"}) write(name, "P5 2 2 255\nabcd\n");
  EXPECT_EQ(load_volume(path("pgm")).at(1, 0, 0), float('b'));
}

TEST_F(TiffValues, PngsAlphaMultipliesNothing) {
  for (int page = 0; page < 2; ++page) {
    const std::string file = write(fmt::format("png/{}.png", page), "");
    const auto out = OIIO::ImageOutput::create(file);
    OIIO::ImageSpec spec(2, 2, 4, OIIO::TypeUInt8);
    spec["oiio:UnassociatedAlpha"] = 1;
    spec.alpha_channel = 3;
    ASSERT_TRUE(out->open(file, spec));
    const std::vector<std::uint8_t> pixels = {200, 1, 2, 10, 201, 1, 2, 0, 202, 1, 2, 128, 203, 1, 2, 255};
    ASSERT_TRUE(out->write_image(OIIO::TypeUInt8, pixels.data()));
    out->close();
  }
  const Volume volume = load_volume(path("png") + "?component=0");
  EXPECT_EQ(volume.at(0, 0, 0), 200.f);
  EXPECT_EQ(volume.at(1, 0, 0), 201.f);
}

/// A PNG file of 5x2 pixels: grey, or numbers of colours in a palette.
std::string png(int bits, bool palette, const std::string& rows) {
  const auto number = [](std::uint32_t value) {
    std::string out;
    append_value(out, value, uint32, endian::big);
    return out;
  };
  const auto chunk = [&](const std::string& type, const std::string& data) {
    const std::string checked = type + data;
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(checked.data()), uInt(checked.size()));
    return number(std::uint32_t(data.size())) + checked + number(std::uint32_t(sum));
  };
  uLongf size = compressBound(rows.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
           rows.size());
  packed.resize(size);
  const std::string head = number(5) + number(2) + char(bits) + char(palette ? 3 : 0) + std::string(3, '\0');
  std::string colors;
  for (int i = 0; i < 3 << bits; ++i) colors += char(255 - 50 * i);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) + (palette ? chunk("PLTE", colors) : "") +
         chunk("IDAT", packed) + chunk("IEND", "");
}

TEST_F(TiffValues, PngsOfFewBitsAndWithAPalette) {
  for (const bool palette : {false, true}) {
    for (const int bits : {1, 2, 4}) {
      const auto value = [&](int page, int x, int y) { return (7 * page + 3 * x + y) % (1 << bits); };
      std::filesystem::remove_all(path("few"));
      for (int page = 0; page < 2; ++page) {
        std::string rows;
        for (int y = 0; y < 2; ++y) {
          std::uint32_t row = 0;
          for (int x = 0; x < 5; ++x) row = row << bits | std::uint32_t(value(page, x, y));
          const int bytes = (5 * bits + 7) / 8;
          row <<= 8 * bytes - 5 * bits;
          rows += '\0';  // no filter
          for (int b = bytes - 1; b >= 0; --b) rows += char(row >> (8 * b) & 0xff);
        }
        write(fmt::format("few/{}.png", page), png(bits, palette, rows));
      }
      const Volume volume = load_volume(path("few"));
      EXPECT_EQ(volume.grid.dims, glm::ivec3(5, 2, 2));
      for (int page = 0; page < 2; ++page)
        for (int y = 0; y < 2; ++y)
          for (int x = 0; x < 5; ++x)
            EXPECT_EQ(volume.at(x, y, page), float(value(page, x, y))) << bits << palette;
      EXPECT_EQ(volume.note.find("numbers of colours") != std::string::npos, palette) << volume.note;
    }
  }
}

}  // namespace
}  // namespace crest::test
