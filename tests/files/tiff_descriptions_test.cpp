#include <fmt/core.h>
#include <tiffio.h>

#include <fstream>
#include <iterator>
#include <vector>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

/// One page: 4x3 pixels of 16-bit numbers, from `first` on.
struct Page {
  Page(int begin, std::uint32_t which = 0, int columns = 4, std::uint32_t planes = 1, int samples = 1)
      : first(begin), kind(which), width(columns), depth(planes), channels(samples) {}
  int first;
  std::uint32_t kind;  ///< FILETYPE_REDUCEDIMAGE or FILETYPE_MASK
  int width;
  std::uint32_t depth;
  int channels;
};

/// What other programs say of a TIFF file's pages.
class TiffDescriptions : public FileTest {
 protected:
  std::uint16_t resolution_unit = RESUNIT_NONE, orientation = ORIENTATION_TOPLEFT;  ///< of file()

  std::string file(const std::string& name, const std::string& description,
                   const std::vector<Page>& pages) const {
    constexpr int height = 3, bits = 16;
    write(name, "");  // with its folder
    TIFF* const tiff = TIFFOpen(path(name).c_str(), "w");
    for (const Page& page : pages) {
      TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, page.width);
      TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
      TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
      TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, page.channels);
      TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, height);
      TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, page.channels == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
      if (page.kind != 0) TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, page.kind);
      if (orientation != ORIENTATION_TOPLEFT) TIFFSetField(tiff, TIFFTAG_ORIENTATION, orientation);
      if (page.depth > 1) TIFFSetField(tiff, TIFFTAG_IMAGEDEPTH, page.depth);
      if (!description.empty()) {
        TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description.c_str());
        TIFFSetField(tiff, TIFFTAG_XRESOLUTION, 2.0);  // pixels a unit
        TIFFSetField(tiff, TIFFTAG_YRESOLUTION, 4.0);
        TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, resolution_unit);
      }
      std::vector<std::uint16_t> values;
      for (int i = 0; i < page.width * height * page.channels; ++i)
        values.push_back(std::uint16_t(page.first + i));
      TIFFWriteEncodedStrip(tiff, 0, values.data(), tmsize_t(2 * values.size()));
      TIFFWriteDirectory(tiff);
    }
    TIFFClose(tiff);
    return path(name);
  }
  static std::vector<Page> pages(int count) {
    std::vector<Page> list;
    for (int i = 0; i < count; ++i) list.emplace_back(100 * i);
    return list;
  }
};

std::string ome(const std::string& more, int images = 1) {
  std::string text = "<OME>";
  for (int i = 0; i < images; ++i)
    text += fmt::format(
        "<Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"4\" SizeY=\"3\" SizeZ=\"3\" "
        "SizeC=\"1\" SizeT=\"1\" {}><TiffData IFD=\"{}\" PlaneCount=\"3\"/></Pixels></Image>",
        more, 3 * i);
  return text + "</OME>";
}

TEST_F(TiffDescriptions, OmesLengthsAreInItsUnits) {
  const std::pair<const char*, double> units[] = {{"µm", 1},  {"nm", 1e-3}, {"mm", 1e3}, {"cm", 1e4},
                                                  {"m", 1e6}, {"pm", 1e-6}, {"Å", 1e-4}, {"in", 25400}};
  for (const auto& [unit, micrometres] : units) {
    std::string sizes;
    for (const char axis : {'X', 'Y', 'Z'})
      sizes += fmt::format("PhysicalSize{0}=\"2\" PhysicalSize{0}Unit=\"{1}\" ", axis, unit);
    const Volume volume = load_volume(file("a.tif", ome(sizes), pages(3)));
    EXPECT_DOUBLE_EQ(volume.grid.spacing.z, 2 * micrometres) << unit;
    EXPECT_NE(volume.note.find("micrometres"), std::string::npos) << volume.note;
  }
  const std::string pixels =
      "PhysicalSizeX=\"2\" PhysicalSizeXUnit=\"pixel\" PhysicalSizeY=\"3\" "
      "PhysicalSizeYUnit=\"pixel\" PhysicalSizeZ=\"4\" PhysicalSizeZUnit=\"pixel\"";
  const Volume volume = load_volume(file("b.tif", ome(pixels), pages(3)));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(2, 3, 4));
  EXPECT_NE(volume.note.find("lengths in \"pixel\""), std::string::npos) << volume.note;
  EXPECT_EQ(volume.note.find("micrometres"), std::string::npos) << volume.note;
}

TEST_F(TiffDescriptions, OfOmesImagesTheFirstIsTakenWithANote) {
  const Volume volume = load_volume(file("a.tif", ome("", 2), pages(6)));
  EXPECT_EQ(volume.grid.dims.z, 3);
  EXPECT_NE(volume.note.find("first of its 2 images"), std::string::npos) << volume.note;
}

TEST_F(TiffDescriptions, ImageJsCalibrationIsApplied) {
  const std::string head = "ImageJ=1.53t\nimages=3\nslices=3\n";
  const std::string is_signed = file("a.tif", head + "cf=0\nc0=-32768.0\nc1=1.0\n", pages(3));
  EXPECT_EQ(load_volume(is_signed).values[13], 101.f - 32768);
  EXPECT_EQ(load_volume(is_signed + "?subtract=-32768").values[13], 101.f);
  EXPECT_NE(load_volume(is_signed).note.find("calibration"), std::string::npos);
  EXPECT_EQ(load_volume(file("b.tif", head + "cf=0\nc0=-10\nc1=0.5\n", pages(3))).values[13], 40.5f);
  const Volume curve = load_volume(file("c.tif", head + "cf=4\nc0=1\nc1=2\n", pages(3)));
  EXPECT_EQ(curve.values[13], 101.f);
  EXPECT_NE(curve.note.find("not applied"), std::string::npos) << curve.note;
  EXPECT_EQ(load_volume(file("d.tif", head, pages(3))).note.find("calibration"), std::string::npos);
  // A straight line is what ImageJ takes where none is named, of values that have a unit
  const std::string unnamed = head + "c0=-10\nc1=2\n";
  EXPECT_EQ(load_volume(file("e.tif", unnamed + "vunit=Gray Value\n", pages(3))).values[13], 192.f);
  EXPECT_EQ(load_volume(file("f.tif", unnamed, pages(3))).values[13], 101.f);
}

TEST_F(TiffDescriptions, ImageJsLengthsAreInItsUnits) {
  const std::string head = "ImageJ=1.53t\nimages=3\nslices=3\nspacing=3\nunit=";
  const Volume escaped = load_volume(file("a.tif", head + "\\u00B5m\n", pages(3)));
  EXPECT_EQ(escaped.grid.spacing, glm::dvec3(0.5, 0.25, 3));
  EXPECT_NE(escaped.note.find("lengths in µm"), std::string::npos) << escaped.note;
  const Volume others = load_volume(file("b.tif", head + "cm\nyunit=cm\nzunit=inch\n", pages(3)));
  EXPECT_NE(others.note.find("lengths in cm, on z in inch"), std::string::npos) << others.note;
  resolution_unit = RESUNIT_CENTIMETER;  // which ImageJ converts to these of its text alone
  EXPECT_EQ(load_volume(file("c.tif", head + "um\n", pages(3))).grid.spacing, glm::dvec3(5000, 2500, 3));
  EXPECT_EQ(load_volume(file("d.tif", head + "cm\n", pages(3))).grid.spacing, glm::dvec3(0.5, 0.25, 3));
  const Volume odd = load_volume(file("e.tif", "ImageJ=1.53t\nimages=3\nslices=3\nspacing=0,5\n", pages(3)));
  EXPECT_NE(odd.note.find("\"0,5\", is no number"), std::string::npos) << odd.note;
}

TEST_F(TiffDescriptions, ImageJsSlicesMayComeBeforeChannels) {
  const std::string head = "ImageJ=1.48v\nimages=12\nchannels=2\nslices=3\nframes=2\n";
  const std::string query = "?component=1&frame=1";
  EXPECT_EQ(load_volume(file("a.tif", head, pages(12)) + query).values[12], 900.f);
  const Volume volume = load_volume(file("b.tif", head + "order=zct\n", pages(12)) + query);
  ASSERT_EQ(volume.grid.dims.z, 3);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(volume.at(0, 0, k), float(100 * (9 + k))) << k;
}

TEST_F(TiffDescriptions, AnOrientationIsSaidAndNotApplied) {
  orientation = ORIENTATION_BOTLEFT;
  const Volume volume = load_volume(file("a.tif", "", pages(3)));
  EXPECT_EQ(volume.values[13], 101.f);
  EXPECT_NE(volume.note.find("orientation 4"), std::string::npos) << volume.note;
}

TEST_F(TiffDescriptions, OmesOtherFilesAreNamed) {
  const auto other = [&](const char* more) {
    return file("a.ome.tif", fmt::format("<OME>{}</OME>", more), pages(3));
  };
  expect_error(
      other("<Image><Pixels SizeZ=\"3\" SizeT=\"2\"><TiffData><UUID FileName=\"a.ome.tif\"/></TiffData>"
            "<TiffData FirstT=\"1\"><UUID FileName=\"b.ome.tif\"/></TiffData></Pixels></Image>"),
      {"6 planes", "3 pages", "others are in b.ome.tif"});
  const Volume bare = load_volume(other("<BinaryOnly MetadataFile=\"a.companion.ome\"/>"));
  EXPECT_EQ(bare.values[13], 101.f);
  EXPECT_NE(bare.note.find("a.companion.ome, which is not read"), std::string::npos) << bare.note;
}

// A set of files has one description, which is in each: of two images, a file each, or of parts of one.
TEST_F(TiffDescriptions, PlanesOfOmesOtherFilesAreNotOfThisOne) {
  const auto block = [](const char* name, int t, int z) {
    return fmt::format(
        "<TiffData FirstT=\"{}\" FirstZ=\"{}\" IFD=\"{}\"><UUID FileName=\"{}\">urn:uuid:{}</UUID>"
        "</TiffData>",
        t, z, z, name, name);
  };
  const auto image = [&](const char* name) {
    return fmt::format(
        "<Image><Pixels SizeZ=\"3\" PhysicalSizeX=\"{0}\" PhysicalSizeY=\"{0}\">{1}{2}{3}</Pixels>"
        "</Image>",
        name[0] == 'a' ? 1 : 2, block(name, 0, 0), block(name, 0, 1), block(name, 0, 2));
  };
  const std::string both = fmt::format("<OME>{}{}</OME>", image("a.ome.tif"), image("b.ome.tif"));
  const Volume second = load_volume(file("b.ome.tif", both, pages(3)));
  EXPECT_EQ(second.grid.spacing.x, 2);
  EXPECT_NE(second.note.find("image 2 of its 2"), std::string::npos) << second.note;
  const std::string numbered = "<OME UUID=\"urn:uuid:b.ome.tif\">" + both.substr(5);
  EXPECT_EQ(load_volume(file("renamed.ome.tif", numbered, pages(3))).grid.spacing.x, 2);
  expect_error(file("renamed.ome.tif", both, pages(3)), {"in no page", "others are in a.ome.tif"});
  const std::string alone = fmt::format("<OME>{}</OME>", image("a.ome.tif"));
  EXPECT_EQ(load_volume(file("renamed.ome.tif", alone, pages(3))).grid.dims.z, 3);

  const std::string parts = fmt::format(
      "<OME><Image><Pixels SizeZ=\"2\" SizeT=\"2\">{}{}{}{}</Pixels></Image></OME>", block("a.ome.tif", 0, 0),
      block("a.ome.tif", 0, 1), block("b.ome.tif", 1, 0), block("b.ome.tif", 1, 1));
  expect_error(file("b.ome.tif", parts, pages(4)),
               {"some of which are in no page", "others are in a.ome.tif"});
  const std::string twice =
      fmt::format("<OME><Image><Pixels SizeZ=\"3\">{0}{0}</Pixels></Image></OME>", block("a.ome.tif", 0, 0));
  expect_error(file("a.ome.tif", twice, pages(3)), {"twice where plane 0 is"});
}

TEST_F(TiffDescriptions, TifffilesAxesBeforeZAreFrames) {
  const std::string four = file("a.tif", "{\"shape\": [2, 3, 3, 4]}", pages(6));
  expect_error(four, {"2 frames"});
  EXPECT_EQ(load_volume(four + "?frame=1").values[12], 400.f);
  const std::string colours = file("b.tif", "{\"shape\": [2, 3, 3, 4], \"axes\": \"CZYX\"}", pages(6));
  EXPECT_EQ(load_volume(colours + "?component=1").values[12], 400.f);
  EXPECT_EQ(load_volume(file("c.tif", "{\"shape\": [6, 3, 4]}", pages(6))).grid.dims.z, 6);
  EXPECT_EQ(load_volume(file("d.tif", "{\"shape\": [1, 6, 3, 4]}", pages(6))).grid.dims.z, 6);
  for (const char* odd :
       {"{\"shape\": [5, 3, 4]}", "{\"shape\": [", "{\"shape\": [-1, 99999999999999999999]}"})
    EXPECT_EQ(load_volume(file("e.tif", odd, pages(6))).grid.dims.z, 6) << odd;
}

// As tifffile writes them where the caller names the axes: before the shape.
TEST_F(TiffDescriptions, TifffilesAxesHaveLetters) {
  const auto axes = [&](const char* letters, const char* shape) {
    return file("a.tif", fmt::format("{{\"axes\": \"{}\", \"shape\": [{}, 3, 4]}}", letters, shape),
                pages(12));
  };
  EXPECT_EQ(load_volume(axes("CZYX", "2, 6") + "?component=1").values[12], 700.f);
  EXPECT_EQ(load_volume(axes("TZYX", "2, 6") + "?frame=1").values[12], 700.f);
  const Volume between = load_volume(axes("ZCYX", "6, 2") + "?component=1");
  EXPECT_EQ(between.grid.dims.z, 6);
  EXPECT_EQ(between.values[12], 300.f);
  EXPECT_EQ(load_volume(axes("TZCYX", "2, 3, 2") + "?component=1&frame=1").values[12], 900.f);
  EXPECT_EQ(load_volume(axes("QZYX", "2, 6") + "?frame=1").values[12], 700.f);
  EXPECT_EQ(load_volume(axes("ZYX", "12")).values[12], 100.f);
  const Volume times = load_volume(axes("TYX", "12"));
  EXPECT_NE(times.note.find("frames are taken as slices"), std::string::npos) << times.note;
}

TEST_F(TiffDescriptions, TifffilesThumbnailIsLeftOut) {
  const std::vector<Page> list = {Page(900, FILETYPE_REDUCEDIMAGE, 2), Page(0), Page(100)};
  EXPECT_EQ(load_volume(file("a.tif", "{\"shape\": [3, 2]}", list)).values[13], 101.f);
}

TEST_F(TiffDescriptions, SmallerCopiesAndMasksAreLeftOut) {
  const std::vector<Page> list = {Page(0), Page(900, FILETYPE_REDUCEDIMAGE, 2), Page(100),
                                  Page(900, FILETYPE_MASK)};
  const Volume volume = load_volume(file("a.tif", "", list));
  EXPECT_EQ(volume.grid.dims, glm::ivec3(4, 3, 2));
  EXPECT_EQ(volume.values[12], 100.f);
  EXPECT_NE(volume.note.find("2 pages left out"), std::string::npos) << volume.note;
}

// The first page tells nothing of the others where it is none of them.
TEST_F(TiffDescriptions, ALeftOutFirstPageChoosesNoChannel) {
  constexpr int colours = 3;
  const Page small_colour(7, FILETYPE_REDUCEDIMAGE, 2, 1, colours), small_grey(7, FILETYPE_REDUCEDIMAGE, 2);
  const std::vector<Page> grey = {small_colour, Page(0), Page(100)};
  const std::vector<Page> colour = {small_grey, Page(0, 0, 4, 1, colours), Page(100, 0, 4, 1, colours)};
  for (const char* name : {"a.tif", "f/a.tif"}) {
    SCOPED_TRACE(name);
    const std::string source = name[0] == 'f' ? path("f") : path(name);
    file(name, "", grey);
    EXPECT_EQ(load_volume(source).values[13], 101.f);
    expect_error(source + "?component=2", {"component=2"});
    file(name, "", colour);
    expect_error(source, {"3 components"});
    const Volume blue = load_volume(source + "?component=2");
    EXPECT_EQ(blue.grid.dims, glm::ivec3(4, 3, 2));
    EXPECT_EQ(blue.values[13], 105.f);
    EXPECT_NE(blue.note.find("1 page left out"), std::string::npos) << blue.note;
  }
  const std::string listed =
      "<OME><Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"4\" SizeY=\"3\" SizeZ=\"2\" SizeC=\"3\" "
      "SizeT=\"1\">"
      "<Channel SamplesPerPixel=\"3\"/><TiffData IFD=\"1\" PlaneCount=\"2\"/></Pixels></Image></OME>";
  EXPECT_EQ(load_volume(file("o.tif", listed, colour) + "?component=2").values[13], 105.f);
}

TEST_F(TiffDescriptions, ComponentsOfOtherChannelsAreRefused) {
  const std::string mixed = file("a.tif", "ImageJ=1.53t\nimages=4\nchannels=2\nslices=2\n",
                                 {Page(0, 0, 4, 1, 3), Page(100), Page(200, 0, 4, 1, 3), Page(300)});
  EXPECT_EQ(load_volume(mixed + "?component=2").values[12], 202.f);
  expect_error(mixed + "?component=5", {"image 2", "1 channels", "3 of"});
}

TEST_F(TiffDescriptions, AFoldersFilesKeepTheirCalibration) {
  const std::string scaled = "ImageJ=1.53t\nunit=um\ncf=0\nc0=-32768\nc1=2\n";
  for (int k = 0; k < 3; ++k) file(fmt::format("f/{}.tif", k), scaled, {Page(100 * k)});
  const Volume volume = load_volume(path("f"));
  EXPECT_EQ(volume.values[13], 2 * 101.f - 32768);
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(0.5, 0.25, 1));
  EXPECT_NE(volume.note.find("lengths in um; the slices' distance is not known"), std::string::npos)
      << volume.note;
  const std::string told = load_volume(path("f") + "?spacing=1,1,3").note;
  EXPECT_EQ(told.find("lengths"), std::string::npos) << told;
  file("f/3.tif", "ImageJ=1.53t\nunit=um\ncf=0\nc0=0\nc1=2\n", {Page(300)});
  expect_error(path("f"), {"3.tif", "calibration", "0.tif", "-32768"});
  file("f/3.tif", "", {Page(300)});
  expect_error(path("f"), {"3.tif", "calibration", "0.tif"});
}

TEST_F(TiffDescriptions, AFoldersFilesOfSeveralPagesKeepTheirSpacing) {
  const std::string head = "ImageJ=1.53t\nimages=2\nslices=2\nunit=um\nspacing=";
  for (const char* name : {"f/1.tif", "f/2.tif"}) file(name, head + "3\n", pages(2));
  const Volume same = load_volume(path("f"));
  EXPECT_EQ(same.grid.spacing, glm::dvec3(0.5, 0.25, 3));
  EXPECT_EQ(same.note.find("lengths in um"), same.note.rfind("lengths in um")) << same.note;
  file("f/2.tif", head + "4\n", pages(2));
  const Volume other = load_volume(path("f"));
  EXPECT_EQ(other.grid.spacing, glm::dvec3(1));
  EXPECT_NE(other.note.find("different spacings"), std::string::npos) << other.note;
  EXPECT_EQ(other.note.find("lengths in"), std::string::npos) << other.note;
}

// As one that is left of many files, whose descriptions all tell of the whole.
TEST_F(TiffDescriptions, AFoldersFileOfOnePageNeedNotHaveAllItTellsOf) {
  const std::string whole =
      "<OME><Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"4\" SizeY=\"3\" SizeZ=\"3\" SizeC=\"1\" "
      "SizeT=\"2\" PhysicalSizeX=\"2\" PhysicalSizeY=\"2\" PhysicalSizeZ=\"5\"/></Image></OME>";
  for (int k = 0; k < 3; ++k) file(fmt::format("f/{}.tif", k), whole, {Page(100 * k)});
  const Volume volume = load_volume(path("f"));
  EXPECT_EQ(volume.grid.dims.z, 3);
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(2, 2, 5));
  EXPECT_NE(volume.note.find("channels and frames"), std::string::npos) << volume.note;
  const std::string head = "ImageJ=1.53t\nimages=9\nslices=9\n";
  for (int k = 0; k < 2; ++k) file(fmt::format("g/{}.tif", k), head, {Page(100 * k)});
  EXPECT_EQ(load_volume(path("g")).values[13], 101.f);
  for (int k = 0; k < 2; ++k) file(fmt::format("h/{}.tif", k), "<OME><BinaryOnly/></OME>", {Page(100 * k)});
  EXPECT_EQ(load_volume(path("h")).values[13], 101.f);
}

TEST_F(TiffDescriptions, AFolderCountsThePagesThatItsFilesLeaveOut) {
  const Page left_out(900, FILETYPE_MASK);
  file("f/1.tif", "", {Page(0), left_out, left_out, Page(100)});
  file("f/2.tif", "", {left_out, Page(200)});
  file("f/3.tif", "", {Page(300)});
  const Volume volume = load_volume(path("f"));
  EXPECT_EQ(volume.grid.dims.z, 4);
  EXPECT_EQ(volume.values[25], 201.f);
  EXPECT_NE(volume.note.find("3 pages left out"), std::string::npos) << volume.note;
}

TEST_F(TiffDescriptions, AFileThatWasCutOffIsRefused) {
  std::string bytes;
  {
    std::ifstream stream(file("a.tif", "", pages(5)), std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
  }
  EXPECT_EQ(load_volume(write("b.tif", bytes)).grid.dims.z, 5);
  for (std::size_t cut = 1; cut < bytes.size(); cut += 7) {
    SCOPED_TRACE(cut);
    error_of(write("b.tif", bytes.substr(0, bytes.size() - cut)));
  }
  for (const char* name : {"f/1.tif", "f/2.tif"}) write(name, bytes.substr(0, bytes.size() - 1));
  expect_error(path("f"), {"1.tif", "page 5", "the file ends"});
}

TEST_F(TiffDescriptions, APageWithADepthIsRefused) {
  expect_error(file("a.tif", "", {Page(0), Page(100, 0, 4, 3)}), {"page 2", "depth"});
  expect_error(file("b.tif", "", {Page(100, 0, 4, 3)}), {"page 1", "depth"});
}

TEST_F(TiffDescriptions, ACompressionThatIsNotReadIsNamed) {
  std::string bytes;
  {
    std::ifstream stream(file("a.tif", "", pages(2)), std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
  }
  const std::string none = bytes_of({259, 3, 1, 0, 1}, ScalarType::uint16);  // tag, type, count, value
  const std::string jpeg2000 = bytes_of({259, 3, 1, 0, 34712}, ScalarType::uint16);
  for (std::size_t at = bytes.find(none); at != std::string::npos; at = bytes.find(none))
    bytes.replace(at, none.size(), jpeg2000);
  expect_error(write("b.tif", bytes), {"page 1", "compression (number 34712) is not read"});
}

}  // namespace
}  // namespace crest::test
