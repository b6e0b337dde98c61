#include <fmt/core.h>
#include <itkImageIOBase.h>
#include <itkMRCImageIO.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkVTKImageIO.h>

#include <limits>
#include <span>

#include "presets/error.h"
#include "render/files/open_choice.h"
#include "render/readers/headers.h"
#include "render/readers/itk_support.h"
#include "render/readers/readers.h"
#include "render/volume/convert.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

/// The part of a file that becomes the volume.
struct Selection {
  glm::u64vec3 dims{0};
  std::uint64_t components = 1, frames = 1, component = 0, frame = 0;
  std::string note;

  std::uint64_t stored_values() const { return dims.x * dims.y * dims.z * components * frames; }
};

void add_note(std::string& note, const std::string& more) {
  if (!note.empty() && !more.empty()) note += "; ";
  note += more;
}

/// One of `count` components or frames, which the query must say when there are more than one.
std::uint64_t select_one(const FileRequest& request, ChoiceKind kind, std::uint64_t count,
                         std::vector<ChoiceOption> options, std::string& note) {
  const std::string_view key = key_of(kind);
  if (count > 1 && !request.query.contains(key)) {
    throw ChoiceNeeded(fmt::format("{}: it has {} {}s, and a volume is one: take the first with ?{}=0",
                                   request.name(), count, key, key),
                       {kind, request.name(), request.query, count, std::move(options)});
  }
  const auto index =
      std::uint64_t(integer_in(request.name(), request.query, key, 0, 0, std::int64_t(count) - 1));
  if (count > 1) add_note(note, fmt::format("{} {} of {} (counted from 0)", key, index, count));
  return index;
}

Selection select(const FileRequest& request, const itk::ImageIOBase& io) {
  unsigned axes = io.GetNumberOfDimensions();
  while (axes > 3 && io.GetDimensions(axes - 1) == 1) --axes;
  if (axes < 3 || axes > 4) {
    throw Error(fmt::format("{}: it has {} dimensions, and a volume has three{}", request.name(), axes,
                            axes == 2 ? ": put its slices into one file, or open a folder of images" : ""));
  }
  Selection selection;
  for (unsigned axis = 0; axis < 3; ++axis) selection.dims[int(axis)] = io.GetDimensions(axis);
  selection.components = io.GetNumberOfComponents();
  selection.frames = axes == 4 ? io.GetDimensions(3) : 1;
  selection.component =
      select_one(request, ChoiceKind::component, selection.components, component_options(io), selection.note);
  selection.frame = select_one(request, ChoiceKind::frame, selection.frames, {}, selection.note);
  return selection;
}

void require_countable(const std::string& name, const Selection& s, std::uint64_t value_size) {
  require_memory(name, s.dims, sizeof(double), std::numeric_limits<std::uint64_t>::max());
  const auto per_point = checked_product(s.components * value_size, s.frames);
  if (s.components == 0 || s.components > 1024 || s.frames == 0 || !per_point ||
      !checked_product(s.dims.x * s.dims.y * s.dims.z, *per_point)) {
    throw Error(fmt::format("{}: {}x{}x{} points of {} components in {} frames cannot be counted", name,
                            s.dims.x, s.dims.y, s.dims.z, s.components, s.frames));
  }
}

/// All of the file's voxels, in the machine's byte order.
void read_voxels(const std::string& name, itk::ImageIOBase& io, const FileHeader& header,
                 std::size_t value_size, std::span<std::byte> out) {
  if (header.inflate_here) {
    inflate_voxels(name, header.data, out);
    if (*header.inflate_here != std::endian::native) swap_bytes(out, value_size);
    return;
  }
  itk::ImageIORegion all(io.GetNumberOfDimensions());
  for (unsigned axis = 0; axis < io.GetNumberOfDimensions(); ++axis)
    all.SetSize(axis, io.GetDimensions(axis));
  io.SetIORegion(all);
  with_itk(name, [&] { io.Read(out.data()); });
}

/// Reads all of the file and keeps the selection. Plain float32 is read in place.
std::vector<float> read_values(const std::string& name, itk::ImageIOBase& io, const FileHeader& header,
                               const Selection& selection, ScalarType type) {
  const std::size_t points = selection.dims.x * selection.dims.y * selection.dims.z;
  std::vector<float> values(points);
  if (type == ScalarType::float32 && selection.stored_values() == points && header.scaling == LinearMap()) {
    read_voxels(name, io, header, size_of(type), std::as_writable_bytes(std::span(values)));
    return values;
  }
  std::vector<std::byte> bytes(selection.stored_values() * size_of(type));
  read_voxels(name, io, header, size_of(type), bytes);
  const std::size_t first = selection.frame * points * selection.components + selection.component;
  convert_to_float(std::span(bytes).subspan(first * size_of(type)), type, selection.components, values,
                   header.scaling);
  return values;
}

/// `copies`: how many times over the format's reader holds the file's data.
Volume read(const FileRequest& request, itk::ImageIOBase& io, FileHeader header, std::uint64_t copies = 1) {
  const std::string name = request.name();
  require_known_keys(name, request.query, "component,frame");
  io.SetFileName(name);
  with_itk(name, [&] { io.ReadImageInformation(); });
  if (const auto* vtk = dynamic_cast<itk::VTKImageIO*>(&io)) {
    header.data.offset = std::uint64_t(vtk->GetHeaderSize());
  }
  if (auto* nifti = dynamic_cast<itk::NiftiImageIO*>(&io)) {  // ITK would apply an intercept without a slope
    nifti->SetRescaleSlope(1);
    nifti->SetRescaleIntercept(0);
  }
  const ScalarType itk_type = scalar_type(name, io.GetComponentType());
  const ScalarType type = header.stored_type.value_or(itk_type);
  const Selection selection = select(request, io);
  const std::uint64_t values = selection.stored_values();
  require_countable(name, selection, sizeof(double));
  require_room(name, header.data, values, size_of(type));
  request.require_memory(selection.dims, selection.components * selection.frames * size_of(type) * copies);
  if (!header.inflate_here) require_all(name, header.data, values, size_of(type));

  Volume volume;
  volume.file_type = type;
  volume.note = selection.note;
  if (header.scaling != LinearMap()) {
    add_note(volume.note, fmt::format("values are {} times the stored ones plus {}", header.scaling.slope,
                                      header.scaling.intercept));
  }
  volume.grid.dims = glm::ivec3(selection.dims);
  take_geometry(io, volume);
  volume.values = read_values(name, io, header, selection, type);
  return volume;
}

}  // namespace

Volume read_nrrd(const FileRequest& request) {
  return read(request, *itk::NrrdImageIO::New(), read_nrrd_header(request.path));
}

Volume read_metaimage(const FileRequest& request) {
  return read(request, *itk::MetaImageIO::New(), read_metaimage_header(request.path));
}

Volume read_nifti(const FileRequest& request) {
  return read(request, *itk::NiftiImageIO::New(), read_nifti_header(request.path), 2);
}

Volume read_mrc(const FileRequest& request) {
  return read(request, *itk::MRCImageIO::New(), read_mrc_header(request.path));
}

Volume read_vtk(const FileRequest& request) {
  return read(request, *itk::VTKImageIO::New(), read_vtk_header(request.path));
}

}  // namespace crest
