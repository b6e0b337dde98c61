#include "render/raycaster/macrocell_store.h"

#include <algorithm>
#include <cmath>

#include "render/raycaster/volume_texture.h"

namespace crest {

void MacrocellStore::forget_volume() {
  macrocells_.clear();
  entries_.clear();
}

void MacrocellStore::forget_tf() { entries_.clear(); }

const Macrocells& MacrocellStore::macrocells(const Volume& volume, const FieldFilter& filter) {
  const auto found = std::ranges::find(macrocells_, filter, [](const auto& pair) { return pair.first; });
  if (found != macrocells_.end()) return found->second;
  return macrocells_.emplace_back(filter, build_macrocells(volume, filter, side(volume))).second;
}

MacrocellStore::Entry& MacrocellStore::entry(const Volume& volume, const Classification& classification,
                                             const Rendering& rendering, const Features& features,
                                             const TableBlur& blur) {
  const Key key{features.dvr, features.base_tf,      features.peaks,
                blur,         dvr_filter(rendering), root_filter(rendering)};
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  if (found != entries_.end()) return *found;

  const auto field = [&](const FieldFilter& filter) { return field_range(filter, volume.statistics.range); };
  Shown dvr, surfaces;
  if (key.dvr) dvr = {key.base_tf ? &classification.base : &classification.tf, blur, nullptr};
  if (key.peaks) surfaces.surfaces = &classification.surfaces;
  Entry& made = entries_.emplace_back();
  made.key = key;
  if (key.dvr_filter == key.root_filter) {
    dvr.surfaces = surfaces.surfaces;
    made.occupancy = find_occupancy(macrocells(volume, key.dvr_filter), dvr, field(key.dvr_filter));
  } else {
    made.occupancy =
        either(find_occupancy(macrocells(volume, key.dvr_filter), dvr, field(key.dvr_filter)),
               find_occupancy(macrocells(volume, key.root_filter), surfaces, field(key.root_filter)));
  }
  return made;
}

double MacrocellStore::occupied_share(const Volume& volume, const Classification& classification,
                                      const Rendering& rendering, const Features& features,
                                      const TableBlur& blur) {
  return entry(volume, classification, rendering, features, blur).occupancy.share;
}

GLuint MacrocellStore::texture(const Volume& volume, const Classification& classification,
                               const Rendering& rendering, const Features& features, const TableBlur& blur) {
  Entry& shown = entry(volume, classification, rendering, features, blur);
  gl::TextureHandle& texture = shown.textures[{features.skipping, features.adaptive}];
  if (texture) return texture.id();
  const Macrocells& cells = macrocells(volume, shown.key.dvr_filter);
  std::vector<std::uint8_t> multiples(cells.count(), 1);
  if (features.adaptive) multiples = step_multiples(cells, std::sqrt(volume.statistics.variance));
  if (features.skipping)
    for (std::size_t i = 0; i < multiples.size(); ++i)
      if (!shown.occupancy.cells[i]) multiples[i] = 0;
  texture = upload_macrocells(cells.dims, multiples);
  return texture.id();
}

}  // namespace crest
