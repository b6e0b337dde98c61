#include "render/files/other_formats.h"

#include <fmt/core.h>

#include <string_view>

#include "render/files/file_request.h"
#include "render/files/header_text.h"

namespace crest {
namespace {

struct OtherFormat {
  std::string_view extensions, what, import, array;  ///< `array`: a Python expression
};

constexpr OtherFormat formats[] = {
    {".npz", "an archive of NumPy arrays", "numpy as n, sys", "n.load(sys.argv[1])[\"NAME\"]"},
    {".h5 .hdf5 .he5 .hdf", "an HDF5 file", "h5py, numpy as n, sys", "h5py.File(sys.argv[1])[\"DATASET\"]"},
    {".zarr", "a Zarr array", "zarr, numpy as n, sys", "n.squeeze(zarr.open(sys.argv[1])[\"0\"])"}};

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
  return "";
}

}  // namespace crest
