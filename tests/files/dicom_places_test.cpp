#include <fmt/core.h>

#include "dicom_elements.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;

std::string doubles(std::initializer_list<double> numbers) { return bytes_of(numbers, float64); }

std::string shorts(const std::vector<int>& numbers) {
  std::string bytes;
  for (const int number : numbers) bytes += dicom_us(number);
  return bytes;
}

constexpr const char* upright = "1\\0\\0\\0\\1\\0";

/// Where the frames and files of a series lie, which say so in many ways.
class DicomPlaces : public FileTest {
 protected:
  std::string file(const std::string& name, const Elements& elements) const {
    return write(name, dicom_head_of_two() + elements.bytes());
  }
  /// The frames that a volume's slices are.
  static std::vector<int> frames_in(const Volume& volume) {
    std::vector<int> frames;
    for (int k = 0; k < volume.grid.dims.z; ++k) frames.push_back(int(volume.at(0, 0, k)) / 10);
    return frames;
  }
  static void expect_note(const Volume& volume, const std::string& part) {
    EXPECT_NE(volume.note.find(part), std::string::npos) << volume.note;
  }
};

TEST_F(DicomPlaces, FramesFollowTheDistanceBetweenSlicesAndItsSign) {
  for (const int sign : {1, -1}) {
    Elements elements = image(3);
    elements.put(0x18, 0x88, "DS", std::to_string(4 * sign)).put(0x20, 0x32, "DS", "10\\20\\30");
    const Volume volume = load_volume(file("a.dcm", elements.put(0x20, 0x37, "DS", upright)));
    EXPECT_EQ(volume.grid.spacing, glm::dvec3(1, 2, 4));
    EXPECT_EQ(volume.grid.origin, glm::dvec3(10, 20, sign > 0 ? 30 : 22));
    EXPECT_EQ(volume.direction, glm::dmat3(1));
    EXPECT_EQ(frames_in(volume), sign > 0 ? std::vector({0, 1, 2}) : std::vector({2, 1, 0}));
    expect_note(volume, "placed by the distance between slices");
  }
}

TEST_F(DicomPlaces, TimesOfNuclearSlicesAreTakenApart) {
  Elements elements = image(6);
  elements.put(0x18, 0x88, "DS", "4").put(0x54, 0x80, "US", shorts({3, 1, 2, 3, 1, 2}));
  elements.put(0x54, 0x70, "US", shorts({1, 1, 1, 2, 2, 2}));
  const std::string unplaced = file("a.dcm", elements);
  expect_error(unplaced, {"2 frames (time slot 1, time slot 2)"});
  const Volume second = load_volume(unplaced + "?frame=1");
  EXPECT_EQ(frames_in(second), std::vector({4, 5, 3}));
  EXPECT_EQ(second.grid.spacing, glm::dvec3(1, 2, 4));
  expect_note(second, "in the order of their slices' numbers");
  elements.put_items(0x54, 0x22,
                     {Elements().put(0x20, 0x32, "DS", "1\\2\\3").put(0x20, 0x37, "DS", upright).bytes()});
  const Volume placed = load_volume(file("b.dcm", elements) + "?frame=0");
  EXPECT_EQ(frames_in(placed), std::vector({1, 2, 0}));
  EXPECT_EQ(placed.grid.origin, glm::dvec3(1, 2, 3));
  EXPECT_TRUE(placed.is_in_patient);
}

// A place of the first frame alone does not make slices of time slots.
TEST_F(DicomPlaces, TimesAreTakenApartAlsoWhereOneThingIsMissing) {
  const std::string place = dicom_element(0x20, 0x32, "DS", "1\\2\\3"),
                    turn = dicom_element(0x20, 0x37, "DS", upright);
  for (const std::string& detector : {place + turn, place, turn})
    for (const bool has_distance : {false, true}) {
      if (detector == place + turn && has_distance) continue;
      Elements elements = image(6);
      elements.put(0x54, 0x80, "US", shorts({3, 1, 2, 3, 1, 2}));
      elements.put(0x54, 0x70, "US", shorts({1, 1, 1, 2, 2, 2})).put_items(0x54, 0x22, {detector});
      if (has_distance) elements.put(0x18, 0x88, "DS", "4");
      const std::string name = file("a.dcm", elements);
      expect_error(name, {"2 frames (time slot 1, time slot 2)"});
      EXPECT_EQ(frames_in(load_volume(name + "?frame=1")), std::vector({4, 5, 3}));
    }
}

TEST_F(DicomPlaces, AFramesOwnMarkCountsNotTheFiles) {
  std::vector<std::string> groups;
  for (const auto& [z, type] : {std::pair(0, "M"), {0, "P"}, {4, "M"}, {4, "P"}}) {
    Elements group;
    group.put_items(0x18, 0x9226, {dicom_element(8, 0x9007, "CS", type)});
    group.put_items(0x20, 0x9113, {dicom_element(0x20, 0x32, "DS", fmt::format("0\\0\\{}", z))});
    groups.push_back(group.bytes());
  }
  Elements elements = image(4);
  elements.put(8, 8, "CS", "MIXED").put_items(0x5200, 0x9230, groups);
  const std::string name = file("a.dcm", elements.put(0x20, 0x37, "DS", upright));
  expect_error(name, {"2 frames (image type M, image type P)"});
  EXPECT_EQ(frames_in(load_volume(name + "?frame=1")), std::vector({1, 3}));
}

TEST_F(DicomPlaces, FramesOfAStackMayTellTheirNumbersAlone) {
  std::vector<std::string> groups;
  for (const int number : {2, 3, 1}) {
    const std::string place = bytes_of({double(number)}, uint32);
    groups.push_back(Elements().put_items(0x20, 0x9111, {dicom_element(0x20, 0x9057, "UL", place)}).bytes());
  }
  const Volume volume = load_volume(file("a.dcm", image(3).put_items(0x5200, 0x9230, groups)));
  EXPECT_EQ(frames_in(volume), std::vector({2, 0, 1}));
  expect_note(volume, "in the order of their slices' numbers");
}

TEST_F(DicomPlaces, SlicesThatASegmentationLeavesOutAreEmpty) {
  const auto segmentation = [&](const std::vector<double>& heights, const std::string& distance = "2") {
    std::vector<std::string> groups;
    for (const double z : heights) {
      Elements group;
      group.put_items(0x20, 0x9113, {dicom_element(0x20, 0x32, "DS", fmt::format("0\\0\\{}", z))});
      group.put_items(0x62, 0xa, {dicom_element(0x62, 0xb, "US", dicom_us(1))});
      groups.push_back(group.bytes());
    }
    const std::string measures =
        dicom_element(0x18, 0x88, "DS", distance) + dicom_element(0x28, 0x30, "DS", "2\\1");
    Elements shared;
    shared.put_items(0x20, 0x9116, {dicom_element(0x20, 0x37, "DS", upright)});
    Elements elements = image(int(heights.size()));
    elements.put_items(0x5200, 0x9229, {shared.put_items(0x28, 0x9110, {measures}).bytes()});
    return load_volume(file("a.dcm", elements.put_items(0x5200, 0x9230, groups)));
  };
  const Volume volume = segmentation({0, 2, 8, 10});
  ASSERT_EQ(volume.grid.dims.z, 6);
  EXPECT_EQ(volume.grid.spacing.z, 2);
  for (const int k : {0, 1, 4, 5}) EXPECT_EQ(volume.at(1, 1, k), float(10 * (k < 2 ? k : k - 2) + 4)) << k;
  for (const int k : {2, 3}) EXPECT_EQ(volume.at(1, 1, k), 0.f) << k;
  expect_note(volume, "2 slices that the file leaves out are put in");
  EXPECT_EQ(volume.note.find("evenly"), std::string::npos) << volume.note;
  const Volume uneven = segmentation({0, 2, 5});  // at no multiple
  EXPECT_EQ(uneven.grid.dims.z, 3);
  expect_note(uneven, "not evenly spaced");
  EXPECT_EQ(segmentation({0, 1e9}).grid.dims.z, 2);  // and no end of them
  const Volume close =
      segmentation({0, 2, 4, 6}, "1");  // none is left out: the file is wrong about the distance
  EXPECT_EQ(close.grid.dims.z, 4);
  EXPECT_EQ(close.grid.spacing.z, 2);
}

TEST_F(DicomPlaces, OrientationsAreOfLengthOne) {
  for (int k = 0; k < 3; ++k) {
    Elements elements = image(1, fmt::format("1.2.3.{}", k));
    elements.put(0x20, 0x32, "DS", fmt::format("0\\0\\{}", 3 * k)).put(0x20, 0x37, "DS", "2\\0\\0\\0\\2\\0");
    file(fmt::format("f/{}", k), elements);
  }
  const Volume volume = load_volume(path("f"));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(1, 2, 3));
  EXPECT_EQ(volume.direction, glm::dmat3(1));
}

TEST_F(DicomPlaces, PositionsAloneTellTheOrderAndTheDistance) {
  for (int k = 0; k < 3; ++k) {
    Elements elements = image(1, fmt::format("1.2.3.{}", k));
    elements.put(0x20, 0x13, "IS", std::to_string(k)).put(0x28, 0x1052, "DS", std::to_string(10 * k));
    elements.put(0x28, 0x1053, "DS", "1").put(0x20, 0x32, "DS", fmt::format("0\\0\\{}", -3 * k));
    file(fmt::format("f/{}", k), elements);
  }
  const Volume volume = load_volume(path("f"));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(1, 2, 3));
  EXPECT_EQ(volume.grid.origin.z, -6);
  EXPECT_EQ(frames_in(volume), std::vector({2, 1, 0}));
  EXPECT_FALSE(volume.is_in_patient);
  expect_note(volume, "taken as axial");
}

TEST_F(DicomPlaces, TilesOfASlideAreNoSlices) {
  expect_error(file("a.dcm", image(3).put(0x20, 0x9311, "CS", "TILED_FULL")), {"tiles of one large image"});
  const std::string wide = bytes_of({9}, uint32);
  expect_error(file("b.dcm", image(3).put(0x48, 6, "UL", wide)), {"tiles of one large image"});
}

TEST_F(DicomPlaces, MosaicsAreNoSlices) {
  const auto mosaic = [&](int k, double z) {
    Elements elements = image(1, fmt::format("1.2.3.{}", k));
    elements.put(8, 8, "CS", "ORIGINAL\\PRIMARY\\M\\MOSAIC").put(0x20, 0x13, "IS", std::to_string(k));
    elements.put(0x20, 0x32, "DS", fmt::format("0\\0\\{}", z)).put(0x20, 0x37, "DS", upright);
    file(fmt::format("f/{}", k), elements);
  };
  for (int k = 0; k < 3; ++k) mosaic(k, 0);
  expect_error(path("f"), {"Siemens mosaics", "dcm2niix"});
  for (int k = 0; k < 3; ++k) mosaic(k, 3 * k);  // the word alone is left
  EXPECT_EQ(load_volume(path("f")).grid.dims.z, 3);
}

TEST_F(DicomPlaces, AMapToTheWorldIsSaidUnlessItIsTheRescale) {
  const auto mapped = [&](double slope) {
    Elements elements = image(3);
    elements.put_items(0x40, 0x9096,
                       {dicom_element(0x40, 0x9224, "FD", doubles({0})) +
                        dicom_element(0x40, 0x9225, "FD", doubles({slope}))});
    return load_volume(file("a.dcm", elements));
  };
  expect_note(mapped(0.5), "real-world values, 0.5 times");
  EXPECT_EQ(mapped(0.5).at(1, 0, 1), 11.f);
  EXPECT_EQ(mapped(1).note.find("real-world"), std::string::npos);
}

TEST_F(DicomPlaces, AFileNeedsNoExtension) {
  EXPECT_EQ(load_volume(file("IM_0001", image(3))).grid.dims.z, 3);
  EXPECT_EQ(load_volume(file("1.2.840.1", image(3))).grid.dims.z, 3);
}

TEST_F(DicomPlaces, NumbersThatBeginLikeAnElementAreNoDicom) {
  std::filesystem::create_directory(path("stack"));
  std::string labels;
  for (int i = 0; i < 100; ++i) append_value(labels, 8, uint32, std::endian::little);
  write("stack/labels", labels);
  for (const char* name : {"stack/1.pgm", "stack/2.pgm"}) write(name, "P5 2 2 255\nabcd");
  EXPECT_EQ(load_volume(path("stack")).grid.dims, glm::ivec3(2, 2, 2));
}

}  // namespace
}  // namespace crest::test
