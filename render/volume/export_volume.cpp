#include "render/volume/export_volume.h"

namespace crest {

ExportVolume export_volume(const Volume& volume) {
  ExportVolume result{.file = volume.file.path,
                      .name = volume.name,
                      .range = volume.statistics.range,
                      .dims = volume.grid.dims,
                      .spacing = volume.grid.spacing,
                      .origin = volume.grid.origin,
                      .raw = {}};
  if (volume.file.raw)
    result.raw = {.type = name_of(volume.file_type),
                  .big_endian = volume.file.raw->big_endian,
                  .offset = volume.file.raw->offset};
  return result;
}

}  // namespace crest
