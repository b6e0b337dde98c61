// Images that are right, made by the libraries that write them.
#include <fmt/core.h>
#include <png.h>
#include <tiffio.h>

#include <fstream>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <vector>

#include "presets/exchange/png_strip.h"
#include "tests/files/imagej_head.h"
#include "tests/fuzz/target_list.h"
#include "tests/fuzz/volume_file.h"

namespace crest::fuzz {
namespace {

/// How a page is stored.
struct TiffForm {
  int bits = 8, channels = 1, kind = SAMPLEFORMAT_UINT, compression = COMPRESSION_NONE,
      photometric = PHOTOMETRIC_MINISBLACK;
  bool tiled = false, planes = false, smaller = false;
  const char* description = nullptr;
};

void write_page(TIFF* tiff, const TiffForm& form) {
  constexpr int height = 18, tile = 16;
  const int width = form.smaller ? 10 : 20;
  if (form.smaller) TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, form.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, form.channels);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, form.kind);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, form.compression);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, form.photometric);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, form.planes ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
  if (form.description) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, form.description);
  if (form.tiled) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, tile);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 5);
  }
  std::string part(std::size_t(form.tiled ? TIFFTileSize(tiff) : TIFFStripSize(tiff)), '\0');
  const std::uint32_t parts = form.tiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
  for (std::uint32_t i = 0; i < parts; ++i) {
    for (std::size_t k = 0; k < part.size(); ++k) part[k] = char(k / 3 * (i + 1) % 200);
    if (form.tiled)
      TIFFWriteEncodedTile(tiff, i, part.data(), tmsize_t(part.size()));
    else
      TIFFWriteEncodedStrip(tiff, i, part.data(), tmsize_t(part.size()));
  }
  TIFFWriteDirectory(tiff);
}

std::string tiff_of(const std::vector<TiffForm>& pages) {
  const std::string path = write_scratch("seed.tif", "");
  {
    const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpen(path.c_str(), "w"), TIFFClose);
    for (const TiffForm& form : pages) write_page(tiff.get(), form);
  }
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
/// A file of some pages of one form.
std::string tiff_of(const TiffForm& form, std::size_t pages) {
  return tiff_of(std::vector<TiffForm>(pages, form));
}

}  // namespace

std::vector<std::string> tiff_seeds() {
  return {
      tiff_of({.bits = 8}, 2),
      tiff_of({.bits = 12, .compression = COMPRESSION_LZW}, 2),
      tiff_of({.bits = 1, .compression = COMPRESSION_PACKBITS, .photometric = PHOTOMETRIC_MINISWHITE}, 2),
      tiff_of(
          {.bits = 32, .kind = SAMPLEFORMAT_IEEEFP, .compression = COMPRESSION_ADOBE_DEFLATE, .tiled = true},
          2),
      tiff_of({.bits = 16, .channels = 3, .photometric = PHOTOMETRIC_RGB, .tiled = true, .planes = true}, 2),
      tiff_of({.bits = 16,
               .kind = SAMPLEFORMAT_INT,
               .description = "ImageJ=1.53t\nimages=4\nchannels=2\nslices=2\nspacing=3\nunit=um\n"},
              4),
      tiff_of({{.channels = 3, .photometric = PHOTOMETRIC_RGB, .smaller = true}, {}, {}}),
      crest::test::imagej_head(20, 18, std::endian::big, "ImageJ=1.53t\nimages=3\nslices=3\n", 720) +
          std::string(3 * 2 * 20 * 18, 's'),
      tiff_of(
          {.description = "<?xml version=\"1.0\"?><OME><Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"20\" "
                          "SizeY=\"18\" "
                          "SizeZ=\"2\" SizeC=\"1\" SizeT=\"2\" PhysicalSizeX=\"0.5\" PhysicalSizeY=\"0.5\" "
                          "PhysicalSizeZ=\"2\" PhysicalSizeZUnit=\"nm\"><TiffData IFD=\"0\" "
                          "PlaneCount=\"4\"/></Pixels></Image></OME>"},
          4)};
}

std::vector<std::string> png_seeds() {
  std::vector<std::string> seeds = {png_strip({{0, 0.5, 1, 1}, {1, 0.2, 0, 0.5}}, 3),
                                    png_strip({{0, 0.5, 1, 1}, {1, 0, 0, 0.5}}, 4)};
  for (const unsigned format : std::initializer_list<unsigned>{
           PNG_FORMAT_GRAY, PNG_FORMAT_GA, PNG_FORMAT_RGB, PNG_FORMAT_LINEAR_Y, PNG_FORMAT_RGB_COLORMAP}) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = 9, image.height = 7, image.format = format;
    image.colormap_entries = 4;
    std::string pixels(PNG_IMAGE_SIZE(image), '\1'), colours(16, 'x'), file(4096, '\0');
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = char(i * i % 4);
    png_alloc_size_t size = file.size();
    if (png_image_write_to_memory(&image, file.data(), &size, 0, pixels.data(), 0, colours.data()) == 0)
      continue;
    seeds.push_back(file.substr(0, size));
  }
  return seeds;
}

std::vector<std::string> pnm_seeds() {
  const std::string bytes(60, '7');
  return {"P1\n# a comment\n3 2\n0 1 0\n101\n",
          "P2 3 2 255\n0 1 2\n3 4 255\n",
          "P3 2 1 1000\n1 2 3 1000 5 6\n",
          "P4\n10 3\n" + bytes.substr(0, 6),
          "P5\n5 4\n255\n" + bytes.substr(0, 20),
          "P5 5 4 65535\n" + bytes.substr(0, 40),
          "P6 5 4 255\n" + bytes};
}

}  // namespace crest::fuzz
