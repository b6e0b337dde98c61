#include "render/volume/export_volume.h"

#include "render/volume/take_part.h"

namespace crest {

ExportVolume export_volume(const Volume& volume) {
  const Grid grid = full_grid(volume);  // other programs read all of the file
  ExportVolume result{.file = volume.file.path,
                      .name = volume.name,
                      .range = volume.statistics.range,
                      .dims = grid.dims,
                      .spacing = grid.spacing,
                      .origin = grid.origin,
                      .raw = {}};
  if (volume.file.raw)
    result.raw = {.type = name_of(volume.file_type),
                  .big_endian = volume.file.raw->big_endian,
                  .offset = volume.file.raw->offset};
  return result;
}

}  // namespace crest
