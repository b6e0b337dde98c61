#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <ranges>
#include <set>
#include <span>

#include "presets/error.h"
#include "render/files/geometry.h"
#include "render/files/header_text.h"
#include "render/files/kinds.h"
#include "render/files/open_choice.h"
#include "render/readers/dicom_pixels.h"
#include "render/readers/dicom_stack.h"
#include "render/readers/readers.h"
#include "render/readers/select_one.h"
#include "render/readers/subtract.h"
#include "render/readers/voxel_header.h"
#include "render/volume/orientation.h"
#include "render/volume/voxel_store.h"

namespace crest {
namespace {

namespace fs = std::filesystem;
using Images = std::vector<DicomImage>;
using AllSeries = std::map<std::string, Images>;  ///< by their UIDs

/// The folder's DICOM files, and those that its DICOMDIR names.
std::set<fs::path> files_in(const fs::path& folder) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!is_dicom(entry.path())) continue;
    if (entry.path().filename() != "DICOMDIR") {
      files.insert(entry.path());
      continue;
    }
    for (const fs::path& file : files_of_dicomdir(entry.path()))
      if (is_dicom(file)) files.insert(file);
  }
  return files;
}

/// Of files elsewhere; each counts a little more, as it is opened and parsed.
std::uint64_t bytes_outside(const fs::path& folder, const std::set<fs::path>& files) {
  constexpr std::uint64_t a_file = std::uint64_t(1) << 16;
  std::uint64_t bytes = 0;
  for (const fs::path& file : files)
    if (file.parent_path() != folder) bytes += fs::file_size(file) + a_file;
  return bytes;
}

AllSeries find_series(const std::set<fs::path>& files) {
  AllSeries series;
  for (const fs::path& file : files)
    for (DicomImage& image : read_dicom_images(file)) series[image.series].push_back(std::move(image));
  return series;
}

/// "T1 axial (MR), 124 images".
std::string text_of(const Images& series) {
  const auto& [description, modality] = std::pair(series[0].description, series[0].modality);
  return fmt::format("{}{}, {} image{}", description.empty() ? "no description" : description,
                     modality.empty() ? "" : fmt::format(" ({})", modality), series.size(),
                     series.size() == 1 ? "" : "s");
}

/// Those with the most images first, as they are most often meant.
OpenChoice choice_of(const FileRequest& request, const AllSeries& all) {
  OpenChoice choice{ChoiceKind::series, request.name(), request.query, all.size(), {}};
  choice.query.erase("series");
  std::vector<const AllSeries::value_type*> sorted;
  for (const auto& one : all) sorted.push_back(&one);
  std::ranges::stable_sort(sorted, std::greater(), [](const auto* one) { return one->second.size(); });
  for (const auto* one : sorted) choice.options.push_back({one->first, text_of(one->second)});
  return choice;
}

/// The images of the series that the query names, or of the one with the most.
Images series_images(const FileRequest& request, const std::set<fs::path>& files, std::string& note) {
  auto all = find_series(files);
  if (all.empty()) throw Error(fmt::format("{}: its DICOM files hold no images", request.name()));
  auto chosen = std::ranges::max_element(all, {}, [](const auto& entry) { return entry.second.size(); });
  if (const auto asked = request.query.find("series"); asked != request.query.end()) {
    chosen = all.find(asked->second);
    if (chosen == all.end()) {
      throw ChoiceNeeded(fmt::format("{}: it has no series \"{}\"; it has {}", request.name(), asked->second,
                                     fmt::join(std::views::keys(all), ", ")),
                         choice_of(request, all));
    }
  } else if (request.reading.asks && all.size() > 1) {
    throw ChoiceNeeded(fmt::format("{}: it has {} series: take one with ?series={}", request.name(),
                                   all.size(), chosen->first),
                       choice_of(request, all));
  }
  if (all.size() > 1) note = fmt::format("series {}, one of {} in the folder", chosen->first, all.size());
  return chosen->second;
}

/// Of a slide's tiles, and of mosaics, whose places are all the same.
void require_slices(const std::string& name, const DicomImage& first, bool has_places) {
  if (first.is_tile)
    throw Error(fmt::format("{}: its frames are the tiles of one large image, and no slices", name));
  if (first.is_mosaic && !has_places)
    throw Error(
        fmt::format("{}: its images are Siemens mosaics, with all slices side by side: dcm2niix writes "
                    "a NIfTI file of them, which is read",
                    name));
}

void note_values(const Images& slices, std::string& note) {
  const DicomImage& first = slices.front();
  if (const auto& world = first.world;
      !world.empty() && std::ranges::find(world, first.scaling) == world.end())
    add_note(note,
             fmt::format("its map to real-world values, {} times the stored ones plus {}, is not applied",
                         world[0].slope, world[0].intercept));
  if (first.photometric == "MONOCHROME1")
    add_note(note, "0 is shown white by other programs (MONOCHROME1); values are kept");
  if (first.photometric == "PALETTE COLOR") add_note(note, "values are numbers of colours in its palette");
  if (first.has_value_table) add_note(note, "a table for its values (Modality LUT) is not applied");
}

/// Decoded JPEG 2000 (YBR_RCT, YBR_ICT) is RGB.
Names sample_names(const DicomImage& image) {
  const std::string& photometric = image.photometric;
  if (photometric == "RGB" || photometric == "YBR_RCT" || photometric == "YBR_ICT")
    return colour_names(image.samples);
  if (photometric.starts_with("YBR") && image.samples == 3)
    return {"luma", "blue less luma", "red less luma"};
  return {};
}

/// The pixels of the file that was asked for last.
class OpenFile {
 public:
  /// Of a file with so many frames.
  DicomPixels& of(const DicomImage& slice, std::size_t frames) {
    if (!pixels_ || slice.file != file_) pixels_ = open_dicom_pixels(slice, frames);
    file_ = slice.file;
    return *pixels_;
  }

 private:
  fs::path file_;
  std::unique_ptr<DicomPixels> pixels_;
};

/// The slices of a part, file by file: frames of two files may take turns.
std::vector<std::uint64_t> file_by_file(const Images& slices, const GridPart& part) {
  std::map<fs::path, std::uint64_t> first_of;
  std::vector<std::uint64_t> order(part.dims().z);
  const auto file_of = [&](std::uint64_t k) -> const fs::path& {
    return slices[part.first.z + k * part.stride.z].file;
  };
  for (std::uint64_t k = 0; k < order.size(); ++k) first_of.emplace(file_of(order[k] = k), k);
  std::ranges::stable_sort(order, {}, [&](std::uint64_t k) { return first_of[file_of(k)]; });
  return order;
}

/// Whether one type and one map are those of all values.
bool are_stored_alike(const Images& slices) {
  return std::ranges::all_of(slices, [&](const DicomImage& slice) {
    return slice.scaling == slices[0].scaling && slice.bits == slices[0].bits &&
           slice.is_signed == slices[0].is_signed && slice.is_real == slices[0].is_real;
  });
}

Volume read_images(const FileRequest& request, Images images, std::string note) {
  const std::string name = request.name();
  std::map<fs::path, std::size_t> frames_of;
  for (const DicomImage& image : images) ++frames_of[image.file];
  const DicomStack stack = stack_dicom(name, std::move(images));
  add_note(note, stack.note);
  const DicomImage& any = stack.frames[0].front();
  require_slices(name, any, stack.frames[0].size() > 1 && any.position);
  Volume volume;
  const auto frame = std::size_t(select_frame(request, stack.frames.size(), volume, stack.frame_names));
  const Images& slices = stack.frames[frame];
  const DicomImage& first = slices.front();
  const auto component = std::size_t(
      select_one(request, ChoiceKind::component, first.samples, volume.note, sample_names(first)));
  add_note(volume.note, note);
  if (!stack.frame_notes.empty()) add_note(volume.note, stack.frame_notes[frame]);
  const glm::u64vec3 dims(first.columns, first.rows, slices.size());
  if (dims.z < 2) throw Error(fmt::format("{}: one DICOM slice: open the folder with its series", name));
  const GridPart part = request.part_of(dims);
  const bool is_alike = are_stored_alike(slices);
  OpenFile file;
  const std::uint64_t stored = (first.bits + 7) / 8;
  request.reading_also(dims.x * dims.y * first.samples * sizeof(double) * part.dims().z)
      .require_memory({part, first.bits <= 16 && is_alike ? stored : sizeof(float),
                       file.of(first, frames_of[first.file]).held_bytes()});

  const DicomGeometry geometry = geometry_of(slices);
  volume.grid = {glm::ivec3(dims), geometry.spacing, geometry.origin};
  volume.direction = geometry.direction;
  volume.is_in_patient = first.orientation.has_value() && !first.is_taken_as_axial;
  add_note(volume.note, geometry.note);
  add_note(volume.note, orientation_note(geometry.direction));
  note_values(slices, volume.note);
  const LinearMap subtraction = subtracted(request, {}, volume.note);
  const auto map_of = [&](const DicomImage& slice) {
    LinearMap map = slice.samples == 1 ? slice.scaling : LinearMap();
    map.intercept += subtraction.intercept;
    return map;
  };
  std::optional<VoxelStore> store;
  std::vector<std::byte> empty;  ///< pixels of a slice that is not in the file
  Rounding lost;
  std::uint64_t done = 0;
  bool has_other_bits = false;
  for (const std::uint64_t k : file_by_file(slices, part)) {
    const DicomImage& slice = slices[part.first.z + k * part.stride.z];
    DicomPixels& pixels = file.of(slice, frames_of[slice.file]);
    const auto there = pixels.frame(slice.frame);  // of an empty one another's, which has its size and type
    if (slice.is_empty) empty.assign(there.size(), std::byte{0});
    const auto bytes = slice.is_empty ? std::span<const std::byte>(empty) : there;
    has_other_bits = has_other_bits || pixels.had_other_bits();
    if (!store) {
      volume.file_type = pixels.type();
      store.emplace(volume.file_type, part.point_count(),
                    is_alike ? std::optional(map_of(first)) : std::nullopt);
    }
    if (is_alike && pixels.type() != volume.file_type)
      throw Error(fmt::format("{}: {}: it holds other pixels than it says", name, slice.file.string()));
    lost = joined(
        lost, put_slice(*store, part, k, bytes, pixels.type(), {slice.samples, component}, map_of(slice)));
    tell(request.reading.progress, double(++done) / double(part.dims().z));
  }
  volume.values = store->take();
  if (has_other_bits)
    add_note(volume.note,
             fmt::format("what stands in other bits than the {} stored ones is left out", first.bits_stored));
  add_note(volume.note, rounding_note(lost, volume.file_type, map_of(first)));
  place_part(volume, part);
  return volume;
}

}  // namespace

Volume read_dicom_file(const FileRequest& request) {
  require_known_keys(request.name(), request.query, "component,frame,subtract" + std::string(part_keys));
  Images images = read_dicom_images(request.path);
  if (images.empty()) throw Error(fmt::format("{}: the DICOM file holds no image", request.name()));
  return read_images(request, std::move(images), "");
}

Volume read_dicom_series(const FileRequest& request) {
  require_known_keys(request.name(), request.query,
                     "component,frame,series,subtract" + std::string(part_keys));
  const std::set<fs::path> files = files_in(request.path);
  const FileRequest whole = request.reading_also(bytes_outside(request.path, files));
  std::string note;
  Images images = series_images(whole, files, note);
  return read_images(whole, std::move(images), note);
}

}  // namespace crest
