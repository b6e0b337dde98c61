#include <fmt/format.h>
#include <itkGDCMImageIO.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <ranges>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/files/kinds.h"

#include "render/files/open_choice.h"
#include "render/readers/dicom_structure.h"
#include "render/readers/itk_support.h"
#include "render/readers/readers.h"
#include "render/volume/convert.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<std::string>;

/// ITK's reader. It would rescale colour, for which DICOM has no modality values (PS3.3, C.11.1), into a
/// buffer that is too small.
class DicomIO : public itk::GDCMImageIO {
 public:
  using Pointer = itk::SmartPointer<DicomIO>;
  static Pointer New() {
    Pointer io = new DicomIO;
    io->UnRegister();
    return io;
  }
  void ReadImageInformation() override {
    itk::GDCMImageIO::ReadImageInformation();
    if (GetNumberOfComponents() == 1) return;
    m_RescaleSlope = 1;
    m_RescaleIntercept = 0;
    SetComponentType(GetInternalComponentType());
  }
};

itk::GDCMImageIO::Pointer open(const std::string& file) {
  const DicomStructure structure = read_dicom_structure(file);
  if (!structure.has_image) throw Error(fmt::format("{}: the DICOM file holds no image", file));
  const auto io = DicomIO::New();
  io->SetFileName(file);
  with_itk(file, [&] { io->ReadImageInformation(); });
  const std::uint64_t value_size = size_of(scalar_type(file, io->GetInternalComponentType()));
  constexpr std::uint64_t longest_axis = 1u << 16;  // the product cannot overflow
  std::uint64_t promised = value_size * io->GetNumberOfComponents();
  for (unsigned axis = 0; axis < 3; ++axis)
    promised *= std::min<std::uint64_t>(io->GetDimensions(axis), longest_axis);
  if (structure.pixel_bytes && *structure.pixel_bytes < promised) {
    throw Error(fmt::format("{}: the header promises {} bytes of pixels, and the file has {}", file, promised,
                            *structure.pixel_bytes));
  }
  return io.GetPointer();
}

glm::dvec3 position_of(const itk::GDCMImageIO& io) {
  return {io.GetOrigin(0), io.GetOrigin(1), io.GetOrigin(2)};
}

/// One slice of a series: its file, and what it is sorted by.
struct Slice {
  double along_normal, number;
  std::string file;
  auto operator<=>(const Slice&) const = default;
};

std::string text_of(itk::GDCMImageIO& io, const std::string& tag) {
  std::string value;
  io.GetValueFromTag(tag, value);
  return std::string(trim(std::string_view(value).substr(0, value.find('\0'))));
}

/// The images of a series, and what the person at the scanner called it.
struct Series {
  std::vector<Slice> slices;
  std::string description, modality;
};
using AllSeries = std::map<std::string, Series>;  ///< by their UIDs

AllSeries find_series(const fs::path& folder) {
  AllSeries all;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!is_dicom(entry.path()) || !read_dicom_structure(entry.path()).has_image) continue;
    const std::string file = entry.path().string();
    const auto io = open(file);
    const auto axis = [&](unsigned i) {
      const std::vector<double> d = io->GetDirection(i);
      return glm::dvec3(d[0], d[1], d[2]);
    };
    const double along_normal = glm::dot(position_of(*io), glm::cross(axis(0), axis(1)));
    const double number = to_number(text_of(*io, "0020|0013")).value_or(0);
    Series& series = all[text_of(*io, "0020|000e")];
    if (series.slices.empty())
      series.description = one_line(text_of(*io, "0008|103e")), series.modality = text_of(*io, "0008|0060");
    series.slices.push_back({along_normal, number, file});
  }
  return all;
}

/// "T1 axial (MR), 124 images".
std::string text_of(const Series& series) {
  const std::size_t count = series.slices.size();
  return fmt::format("{}{}, {} image{}", series.description.empty() ? "no description" : series.description,
                     series.modality.empty() ? "" : fmt::format(" ({})", series.modality), count,
                     count == 1 ? "" : "s");
}

/// Those with the most images first, as they are most often meant.
OpenChoice choice_of(const FileRequest& request, const AllSeries& all) {
  OpenChoice choice{ChoiceKind::series, request.name(), request.query, all.size(), {}};
  choice.query.erase("series");
  std::vector<const AllSeries::value_type*> sorted;
  for (const auto& one : all) sorted.push_back(&one);
  std::ranges::stable_sort(sorted, std::greater(), [](const auto* one) { return one->second.slices.size(); });
  for (const auto* one : sorted) choice.options.push_back({one->first, text_of(one->second)});
  return choice;
}

/// The files of the series that the query names, or of the one with the most, in the order of their
/// positions.
Files series_files(const FileRequest& request, std::string& note) {
  auto all = find_series(request.path);
  if (all.empty()) throw Error(fmt::format("{}: its DICOM files hold no images", request.name()));
  auto chosen =
      std::ranges::max_element(all, {}, [](const auto& entry) { return entry.second.slices.size(); });
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
  std::ranges::sort(chosen->second.slices);
  Files files;
  for (const Slice& slice : chosen->second.slices) files.push_back(slice.file);
  return files;
}

/// Along the third axis the positions of the slices tell the spacing, not the slices' thickness.
void measure_slices(const std::vector<glm::dvec3>& positions, Volume& volume) {
  constexpr double tolerance = 0.01;
  const std::size_t steps = positions.size() - 1;
  if (steps == 0 || positions.front() == positions.back()) return;
  const glm::dvec3 whole = positions.back() - positions.front();
  const double spacing = glm::length(whole) / double(steps);
  volume.grid.spacing.z = spacing;
  volume.direction[2] = glm::normalize(whole);
  for (std::size_t i = 0; i < steps; ++i) {
    const double step = glm::distance(positions[i], positions[i + 1]);
    if (std::abs(step - spacing) <= tolerance * spacing) continue;
    volume.note += fmt::format("{}the slices are not evenly spaced: {} after slice {}, {} on average",
                               volume.note.empty() ? "" : "; ", step, i + 1, spacing);
    return;
  }
}

/// Throws Error unless a file's image is like the first one's.
void require_alike(const itk::GDCMImageIO& io, const itk::GDCMImageIO& first) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (io.GetDimensions(axis) == first.GetDimensions(axis)) continue;
    throw Error(fmt::format("{}: its image is {}x{}, and {} is {}x{}: a volume's slices are of one size",
                            io.GetFileName(), io.GetDimensions(0), io.GetDimensions(1), first.GetFileName(),
                            first.GetDimensions(0), first.GetDimensions(1)));
  }
  if (io.GetNumberOfComponents() != first.GetNumberOfComponents()) {
    throw Error(fmt::format("{}: it has {} components, and {} has {}", io.GetFileName(),
                            io.GetNumberOfComponents(), first.GetFileName(), first.GetNumberOfComponents()));
  }
}

Volume read_files(const FileRequest& request, const Files& files, std::string note) {
  const std::string name = request.name();
  const auto first = open(files.front());
  const std::uint64_t components = first->GetNumberOfComponents();
  if (components > 1 && !request.query.contains("component")) {
    throw ChoiceNeeded(
        fmt::format("{}: it has {} components, and a volume is one: take the first with ?component=0", name,
                    components),
        {ChoiceKind::component, name, request.query, components, component_options(*first)});
  }
  const auto component =
      std::size_t(integer_in(name, request.query, "component", 0, 0, std::int64_t(components) - 1));
  const glm::u64vec3 file_dims(first->GetDimensions(0), first->GetDimensions(1), first->GetDimensions(2));
  const glm::u64vec3 dims(file_dims.x, file_dims.y, file_dims.z * files.size());
  if (dims.z < 2) throw Error(fmt::format("{}: one DICOM slice: open the folder with its series", name));
  request.require_memory(dims, components * sizeof(double) / files.size());

  Volume volume;
  volume.note = std::move(note);
  if (components > 1) {
    volume.note += fmt::format("{}component {} of {} (counted from 0)", volume.note.empty() ? "" : "; ",
                               component, components);
  }
  volume.file_type = scalar_type(name, first->GetInternalComponentType());
  volume.grid.dims = glm::ivec3(dims);
  take_geometry(*first, volume);
  volume.values.resize(volume.grid.point_count());
  const std::size_t points = file_dims.x * file_dims.y * file_dims.z;
  std::vector<glm::dvec3> positions;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const auto io = open(files[f]);
    require_alike(*io, *first);
    positions.push_back(position_of(*io));
    const ScalarType type = scalar_type(files[f], io->GetComponentType());  // its rescaling is its own
    std::vector<std::byte> bytes(points * components * size_of(type));
    itk::ImageIORegion all(3);
    for (unsigned axis = 0; axis < 3; ++axis) all.SetSize(axis, io->GetDimensions(axis));
    io->SetIORegion(all);
    with_itk(files[f], [&] { io->Read(bytes.data()); });
    convert_to_float(std::span(bytes).subspan(component * size_of(type)), type, components,
                     std::span(volume.values).subspan(f * points, points));
  }
  measure_slices(positions, volume);
  return volume;
}

}  // namespace

Volume read_dicom_file(const FileRequest& request) {
  require_known_keys(request.name(), request.query, "component");
  return read_files(request, {request.name()}, "");
}

Volume read_dicom_series(const FileRequest& request) {
  require_known_keys(request.name(), request.query, "component,series");
  std::string note;
  const Files files = series_files(request, note);
  return read_files(request, files, note);
}

}  // namespace crest
