#pragma once

#include <map>
#include <utility>
#include <vector>

#include "render/classify/classification.h"
#include "render/gl/handle.h"
#include "render/raycaster/features.h"
#include "render/raycaster/occupancy.h"

namespace crest {

/// The macrocells of one volume, and which of them show something of one TF: each is made when it is first
/// asked for, and kept.
class MacrocellStore {
 public:
  /// Another volume, or another TF of the same one: what was made of the old is dropped.
  void forget_volume();
  void forget_tf();

  /// The share of the macrocells that may show something: of DVR and peaks, where these features are in.
  /// `blur` is as in Shown.
  double occupied_share(const Volume& volume, const Classification& classification,
                        const Rendering& rendering, const Features& features, const TableBlur& blur);

  /// For features.skipping and features.adaptive: a texel (R8UI) a macrocell. It is how many steps are joined
  /// into one, or 0 where features.skipping and nothing in it shows.
  GLuint texture(const Volume& volume, const Classification& classification, const Rendering& rendering,
                 const Features& features, const TableBlur& blur);
  /// The side of a macrocell, in cells of the grid.
  static int side(const Volume& volume) { return macrocell_side(volume.grid, volume.statistics); }

 private:
  /// What an occupancy depends on, beside the volume and the TF.
  struct Key {
    bool dvr, base_tf, peaks;
    TableBlur blur;
    FieldFilter dvr_filter, root_filter;
    bool operator==(const Key&) const = default;
  };
  struct Entry {
    Key key;
    Occupancy occupancy;
    std::map<std::pair<bool, bool>, gl::TextureHandle> textures;  ///< by whether skipping and adaptive are in
  };

  const Macrocells& macrocells(const Volume& volume, const FieldFilter& filter);
  Entry& entry(const Volume& volume, const Classification& classification, const Rendering& rendering,
               const Features& features, const TableBlur& blur);

  std::vector<std::pair<FieldFilter, Macrocells>> macrocells_;
  std::vector<Entry> entries_;
};

}  // namespace crest
