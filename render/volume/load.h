#pragma once

#include <string>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// One kind of volume that load_volume reads, for `crest list formats`.
struct VolumeFormat {
  std::string_view name, extensions, summary;
};
std::vector<VolumeFormat> volume_formats();

/// Reads a volume: a file, a folder (DICOM series or image stack), or "builtin:NAME?key=value&...".
/// A query may follow a file's name: "head.raw?size=64x64x93&type=int16&spacing=3.2,3.2,1.5&endian=little",
/// and "?component=0" or "?frame=0" to take one of an RGB or 4D file.
/// Throws Error: what is wrong with which file. Lengths are checked, and the memory it needs, before it is
/// read.
Volume load_volume(const std::string& source);

}  // namespace crest
