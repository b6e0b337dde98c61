#include "render/files/other_formats.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "presets/printable.h"
#include "render/files/file_request.h"
#include "render/files/header_text.h"
#include "render/files/time_steps.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

struct OtherFormat {
  std::string_view extensions, what, import, array;  ///< `array`: a Python expression
};

constexpr OtherFormat formats[] = {
    {".npz", "an archive of NumPy arrays", "numpy as n, sys", "n.load(sys.argv[1])[\"NAME\"]"},
    {".h5 .hdf5 .he5 .hdf", "an HDF5 file", "h5py, numpy as n, sys", "h5py.File(sys.argv[1])[\"DATASET\"]"},
    {".zarr", "a Zarr array", "zarr, numpy as n, sys", "n.squeeze(zarr.open(sys.argv[1])[\"0\"])"}};

constexpr std::string_view resampled =
    "ParaView's \"Resample To Image\" makes a regular grid of it, which is saved as .vti";

/// Kinds of VTK's that are no regular grids.
struct OtherVtk {
  std::string_view extensions, what, how;
};
constexpr OtherVtk vtk_kinds[] = {
    {".vtu .pvtu", "an unstructured grid", resampled},
    {".vts .pvts", "a curvilinear grid", resampled},
    {".vtr .pvtr", "a grid with uneven spacing", resampled},
    {".vtp .pvtp", "surfaces, lines or points", "they have no voxels"},
    {".vtm .vtmb .vthb", "a list of files, its blocks", "of these a .vti file can be opened alone"}};

/// A file that a ParaView collection names, from its first megabyte: file="NAME" of a .pvd, "name": "NAME" of
/// a .series.
std::optional<fs::path> first_in_collection(const fs::path& path) {
  const std::string head = read_head(path, longest_header);
  const std::string_view key = extension_of(path) == ".series" ? "\"name\"" : "file=";
  const std::size_t at = head.find(key), begin = at == head.npos ? at : head.find('"', at + key.size()),
                    end = begin == head.npos ? begin : head.find('"', begin + 1);
  if (end == head.npos) return std::nullopt;
  return path.parent_path() / head.substr(begin + 1, end - begin - 1);
}

std::string how_to_open_collection(const fs::path& path) {
  const auto first = first_in_collection(path);
  std::error_code fault;
  const auto list = first && fs::is_regular_file(*first, fault) ? numbered_list_of(*first) : std::nullopt;
  return fmt::format(
      "a ParaView collection, which lists the files of time steps, is not read; a pattern opens "
      "them as steps: '{}'",
      list ? printable(list->pattern.string()) : "NAME_*.vti");
}

}  // namespace

std::string how_to_convert(const std::filesystem::path& path) {
  const std::string extension = extension_of(path.has_filename() ? path : path.parent_path());
  for (const OtherFormat& format : formats) {
    for (const std::string& known : words(format.extensions)) {
      if (extension != known) continue;
      return fmt::format(
          "{} is not read; a .npy file is, which this writes: python3 -c 'import {}; n.save(\"volume.npy\", "
          "{})' {}",
          format.what, format.import, format.array, path.string());
    }
  }
  for (const OtherVtk& kind : vtk_kinds)
    if (const auto known = words(kind.extensions); std::ranges::find(known, extension) != known.end())
      return fmt::format("VTK's {} ({}) is not read: {}", extension, kind.what, kind.how);
  return extension == ".pvd" || extension == ".series" ? how_to_open_collection(path) : "";
}

}  // namespace crest
