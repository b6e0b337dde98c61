#include "render/volume/take_part.h"

namespace crest {

void take_part(Volume& volume, const GridPart& part) {
  volume.grid.dims = glm::ivec3(part.dims());
  if (part.is_whole()) return;
  volume.grid.origin += volume.grid.spacing * glm::dvec3(part.first);
  volume.grid.spacing *= glm::dvec3(part.stride);
  volume.part = part;
  volume.note = part_text(part) + (volume.note.empty() ? "" : "; ") + volume.note;
}

Grid full_grid(const Volume& volume) {
  if (!volume.part) return volume.grid;
  Grid grid{glm::ivec3(volume.part->full), volume.grid.spacing / glm::dvec3(volume.part->stride), {}};
  grid.origin = volume.grid.origin - grid.spacing * glm::dvec3(volume.part->first);
  return grid;
}

}  // namespace crest
