#include "render/readers/dicom_image.h"

#include <fmt/core.h>
#include <gdcmReader.h>

#include <algorithm>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/dicom_elements.h"
#include "render/readers/dicom_places.h"
#include "render/readers/dicom_structure.h"
#include "render/readers/with_gdcm.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

namespace fs = std::filesystem;
using gdcm::Tag;

void take_spacing(const gdcm::DataSet& set, DicomImage& image) {
  for (const Tag& tag : {Tag(0x0028, 0x0030), Tag(0x0018, 0x1164), Tag(0x0018, 0x2010)}) {
    const auto v = dicom_numbers(set, tag);  // of rows, then of columns
    if (v.size() != 2 || image.spacing) continue;
    image.spacing = glm::dvec2(v[1], v[0]);
    image.spacing_at_detector = tag == Tag(0x0018, 0x1164);
  }
  if (const auto distance = dicom_number(set, Tag(0x0018, 0x0088))) image.slice_distance = distance;
  if (const auto thickness = dicom_number(set, Tag(0x0018, 0x0050))) image.thickness = thickness;
}

void take_scaling(const gdcm::DataSet& set, DicomImage& image) {
  if (const auto slope = dicom_number(set, Tag(0x0028, 0x1053))) image.scaling.slope = *slope;
  if (const auto intercept = dicom_number(set, Tag(0x0028, 0x1052))) image.scaling.intercept = *intercept;
  if (const auto dose = dicom_number(set, Tag(0x3004, 0x000e))) image.scaling.slope = *dose;
  image.has_value_table = image.has_value_table || !dicom_items(set, Tag(0x0028, 0x3000)).empty();
}

/// To values of the world, where they are others than the modality's (PS3.3, C.7.6.16.2.11).
void take_world(const gdcm::DataSet& set, DicomImage& image) {
  for (const auto& item : dicom_items(set, Tag(0x0040, 0x9096))) {
    const auto slope = dicom_binary(item, Tag(0x0040, 0x9225)),
               intercept = dicom_binary(item, Tag(0x0040, 0x9224));
    if (slope && intercept) image.world.push_back({*slope, *intercept});
  }
}

/// A frame's own in place of the file's.
void add_mark(const char* name, const std::string& value, DicomImage& image) {
  if (value.empty()) return;
  const auto known = std::ranges::find(image.marks, name, &DicomMark::name);
  if (known == image.marks.end())
    image.marks.push_back({name, value});
  else
    known->value = value;
}

std::string text_of(std::optional<double> number) { return number ? fmt::format("{:.10g}", *number) : ""; }

void take_marks(const gdcm::DataSet& set, DicomImage& image) {
  add_mark("time", dicom_text(set, Tag(0x0020, 0x0100)), image);
  add_mark("echo time", dicom_text(set, Tag(0x0018, 0x0081)), image);
  add_mark("b-value", text_of(dicom_binary(set, Tag(0x0018, 0x9087))), image);
  add_mark("trigger time", dicom_text(set, Tag(0x0018, 0x1060)), image);
  add_mark("frame reference time", dicom_text(set, Tag(0x0054, 0x1300)), image);
  add_mark("inversion time", dicom_text(set, Tag(0x0018, 0x0082)), image);
  add_mark("flip angle", dicom_text(set, Tag(0x0018, 0x1314)), image);
  add_mark("image type", dicom_text(set, Tag(0x0008, 0x0008)), image);
  add_mark("acquisition", dicom_text(set, Tag(0x0020, 0x0012)), image);
  add_mark("acquisition time", dicom_text(set, Tag(0x0008, 0x0032)), image);
  add_mark("content time", dicom_text(set, Tag(0x0008, 0x0033)), image);
}

/// What a functional group of an enhanced file says of a frame (PS3.3, C.7.6.16).
void take_group(const gdcm::DataSet& group, DicomImage& image) {
  for (const auto& item : dicom_items(group, Tag(0x0020, 0x9113)))
    if (const auto position = dicom_position(item)) image.position = position;
  for (const auto& item : dicom_items(group, Tag(0x0020, 0x9116))) take_dicom_orientation(item, image);
  for (const auto& item : dicom_items(group, Tag(0x0028, 0x9110))) {
    image.spacing.reset();
    take_spacing(item, image);
  }
  for (const auto& item : dicom_items(group, Tag(0x0028, 0x9145))) take_scaling(item, image);
  take_world(group, image);
  for (const auto& item : dicom_items(group, Tag(0x0020, 0x9111))) {
    add_mark("time", text_of(dicom_binary(item, Tag(0x0020, 0x9128))), image);
    add_mark("stack", dicom_text(item, Tag(0x0020, 0x9056)), image);
    add_mark("acquisition", text_of(dicom_binary(item, Tag(0x0020, 0x9156))), image);
    if (const auto number = dicom_binary(item, Tag(0x0020, 0x9057))) image.slice_number = number;
  }
  for (const auto& item : dicom_items(group, Tag(0x0062, 0x000a)))
    add_mark("segment", text_of(dicom_binary(item, Tag(0x0062, 0x000b))), image);
  for (const auto& item : dicom_items(group, Tag(0x0018, 0x9114)))
    add_mark("echo time", text_of(dicom_binary(item, Tag(0x0018, 0x9082))), image);
  for (const auto& item : dicom_items(group, Tag(0x0018, 0x9117)))
    add_mark("b-value", text_of(dicom_binary(item, Tag(0x0018, 0x9087))), image);
  for (const auto& item : dicom_items(group, Tag(0x0018, 0x9118)))
    add_mark("trigger time", text_of(dicom_binary(item, Tag(0x0020, 0x9153))), image);
  for (const auto& item : dicom_items(group, Tag(0x0018, 0x9226)))
    add_mark("image type", dicom_text(item, Tag(0x0008, 0x9007)), image);
}

/// GDCM would end the program.
void check_planes(const fs::path& file, const gdcm::DataSet& set) {
  const double planes = dicom_binary(set, Tag(0x0028, 0x0006)).value_or(0);
  if (planes > 1)
    throw Error(
        fmt::format("{}: its planar configuration is {}, which may be 0 or 1", file.string(), planes));
}

/// Of so many frames that are not compressed; nothing where they cannot be counted.
std::optional<std::uint64_t> promised_bytes(const DicomImage& image, std::uint64_t samples,
                                            std::size_t frames) {
  const auto bits = checked_product({image.bits, image.rows, image.columns, samples, std::uint64_t(frames)});
  return bits ? std::optional(*bits / 8 + (*bits % 8 > 0)) : bits;
}

/// `bytes`: of pixels that are not compressed.
void check_length(const DicomImage& image, std::size_t frames, std::uint64_t bytes) {
  const bool shares = shares_colours(image);
  const auto promised = promised_bytes(image, shares ? 2 : image.samples, frames);
  if (!promised || bytes < *promised)
    throw Error(fmt::format("{}: it promises {} frame{} of {}x{}, which are {} bytes of pixels, and has {}",
                            image.file.string(), frames, frames == 1 ? "" : "s", image.columns, image.rows,
                            promised ? fmt::format("{}", *promised) : "more than can be counted", bytes));
  const auto of_others = promised_bytes(image, image.samples, frames);
  if (shares && of_others && bytes >= *of_others)  // as some programs write them
    throw Error(
        fmt::format("{}: it says {}, of which two pixels share their colours in {} bytes, and has the "
                    "{} bytes of pixels that do not",
                    image.file.string(), image.photometric, *promised, bytes));
}

/// What holds for all of a file's frames.
DicomImage common_of(const fs::path& file, const gdcm::DataSet& set) {
  check_planes(file, set);
  DicomImage image;
  image.file = file;
  image.series = dicom_text(set, Tag(0x0020, 0x000e));
  image.instance = dicom_text(set, Tag(0x0008, 0x0018));
  image.description = dicom_text(set, Tag(0x0008, 0x103e));
  image.modality = dicom_text(set, Tag(0x0008, 0x0060));
  image.rows = std::uint64_t(dicom_binary(set, Tag(0x0028, 0x0010)).value_or(0));
  image.columns = std::uint64_t(dicom_binary(set, Tag(0x0028, 0x0011)).value_or(0));
  image.samples = std::uint64_t(dicom_binary(set, Tag(0x0028, 0x0002)).value_or(1));
  image.bits = std::uint64_t(dicom_binary(set, Tag(0x0028, 0x0100)).value_or(16));
  image.bits_stored = std::uint64_t(dicom_binary(set, Tag(0x0028, 0x0101)).value_or(double(image.bits)));
  image.high_bit =
      std::uint64_t(dicom_binary(set, Tag(0x0028, 0x0102)).value_or(double(image.bits_stored) - 1));
  image.is_signed = dicom_binary(set, Tag(0x0028, 0x0103)).value_or(0) != 0;
  image.has_planes = image.samples > 1 && dicom_binary(set, Tag(0x0028, 0x0006)).value_or(0) != 0;
  image.photometric = dicom_text(set, Tag(0x0028, 0x0004));
  image.position = dicom_position(set);
  image.number = dicom_number(set, Tag(0x0020, 0x0013));
  take_dicom_orientation(set, image);
  take_spacing(set, image);
  take_scaling(set, image);
  take_world(set, image);
  take_marks(set, image);
  image.is_tile = dicom_text(set, Tag(0x0020, 0x9311)).starts_with("TILED") ||
                  dicom_binary(set, Tag(0x0048, 0x0006)).value_or(0) > double(image.columns);
  image.is_mosaic = dicom_text(set, Tag(0x0008, 0x0008)).find("MOSAIC") != std::string::npos &&
                    !set.FindDataElement(Tag(0x5200, 0x9230));
  return image;
}

/// Frame Increment Pointer: Frame Time, or Frame Time Vector.
bool frames_are_times(const gdcm::DataSet& set) {
  if (!set.FindDataElement(Tag(0x0028, 0x0009))) return false;
  const gdcm::ByteValue* value = set.GetDataElement(Tag(0x0028, 0x0009)).GetByteValue();
  if (!value || value->GetLength() < 4) return false;
  std::uint16_t tag[2];
  std::copy_n(value->GetPointer(), sizeof tag, reinterpret_cast<char*>(tag));
  return tag[0] == 0x0018 && (tag[1] == 0x1063 || tag[1] == 0x1065);
}

/// Frames without a place of their own have none: the file's position is the first one's.
std::vector<DicomImage> frames_of(const gdcm::DataSet& set, const DicomImage& common, std::size_t count) {
  std::vector<DicomImage> images(count, common);
  if (count == 1) return images;
  for (std::size_t i = 0; i < count; ++i) {
    images[i].frame = i;
    images[i].number = double(i);
    images[i].is_time = frames_are_times(set);
  }
  take_dicom_offsets(set, images);
  take_dicom_slice_numbers(set, images);
  return images;
}

}  // namespace

std::vector<DicomImage> read_dicom_images(const fs::path& file) {
  constexpr std::size_t most_frames = std::size_t(1) << 20;
  const DicomStructure structure = read_dicom_structure(file);
  if (!structure.has_image) return {};
  const Tag pixels(structure.pixel_tag);
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  with_gdcm(file.string(), [&] { return reader.ReadUpToTag(pixels, {pixels}); });
  const gdcm::DataSet& set = reader.GetFile().GetDataSet();
  DicomImage common = common_of(file, set);
  const double said = dicom_number(set, Tag(0x0028, 0x0008)).value_or(1);
  const auto count = said >= 1 && said <= double(most_frames) ? std::size_t(said) : 1;
  if (structure.pixels) {
    const DicomNumbers numbers = structure.pixels->numbers;
    common.is_real = numbers != DicomNumbers::integers;
    if (common.is_real) common.bits = numbers == DicomNumbers::float32 ? 32 : 64;
    check_length(common, count, structure.pixels->bytes);
  }
  for (const auto& group : dicom_items(set, Tag(0x5200, 0x9229))) take_group(group, common);
  std::vector<DicomImage> images = frames_of(set, common, count);
  const auto groups = dicom_items(set, Tag(0x5200, 0x9230));
  const bool has_groups = groups.size() == count;
  for (std::size_t i = 0; has_groups && i < count; ++i) {
    images[i].position.reset();
    take_group(groups[i], images[i]);
  }
  const bool placed = has_groups || !dicom_numbers(set, Tag(0x3004, 0x000c)).empty();
  if (count > 1 && !placed) place_dicom_frames(images);
  return images;
}

std::vector<fs::path> files_of_dicomdir(const fs::path& dicomdir) {
  gdcm::Reader reader;
  reader.SetFileName(dicomdir.c_str());
  with_gdcm(dicomdir.string(), [&] { return reader.Read(); });
  std::vector<fs::path> files;
  for (const auto& record : dicom_items(reader.GetFile().GetDataSet(), Tag(0x0004, 0x1220))) {
    std::string text = dicom_text(record, Tag(0x0004, 0x1500));
    if (text.empty()) continue;
    std::ranges::replace(text, '\\', '/');
    for (const std::string& path : {text, lower(text)}) {
      if (!fs::is_regular_file(dicomdir.parent_path() / path)) continue;
      files.push_back(dicomdir.parent_path() / path);
      break;
    }
  }
  return files;
}

}  // namespace crest
