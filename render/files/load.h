#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/files/file_request.h"
#include "render/volume/volume.h"

namespace crest {

/// One kind of volume that load_volume reads, for `crest list formats`.
struct VolumeFormat {
  std::string_view name, extensions, summary;  ///< extensions with their dots, separated by spaces
};
std::vector<VolumeFormat> volume_formats();

/// Whether there is something for load_volume to read: a file, a folder, or something built in.
bool is_volume_there(const std::string& source);

/// Reads a volume: a file, a folder (DICOM series or image stack), or "builtin:NAME?key=value&...".
/// A query may follow a file's name: "head.raw?size=64x64x93&type=int16&spacing=3.2,3.2,1.5&endian=little",
/// "?component=0" or "?frame=0" to take one of an RGB or 4D file, and "?crop=" or "?stride=" to take a part
/// of its points (grid_part.h). A "*" in a file's name stands for the numbers of a list of files
/// (time_steps.h), of which "?frame=0" takes the first. Spacing is made positive; one that is 0 or not finite
/// becomes 1, and the note says so. Throws Error: what is wrong with which file; ChoiceNeeded (open_choice.h)
/// where the query must say more. Of several series in a folder the one with the most images is read, unless
/// `reading` asks: then it is a choice. Lengths are checked before it is read, and that it takes no more
/// memory than it may. Files that need a library are read by a program of their own (read_beside.h), so that
/// what a damaged one does to that library is an error too.
Volume load_volume(const std::string& source, const Reading& reading = {});

}  // namespace crest
