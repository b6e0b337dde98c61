#include "render/vdls/quadtree.h"

#include <algorithm>
#include <array>
#include <optional>

namespace crest {
namespace {

class Builder {
 public:
  Builder(std::span<const std::uint32_t> counts, int leaves, int leaf_side, int threshold)
      : counts_(counts), leaves_(leaves), leaf_side_(leaf_side), threshold_(threshold) {}

  std::vector<ScreenNode> build() {
    keep(combine({0, 0}, leaves_));
    return std::move(nodes_);
  }

 private:
  /// The square of `side` leaves as one node, or nothing where it stays divided: its parts are then kept.
  std::optional<ScreenNode> combine(glm::ivec2 leaf, int side) {
    const ScreenNode whole{leaf * leaf_side_, side * leaf_side_, 0};
    if (side == 1) {
      const std::size_t index = std::size_t(leaf.y) * std::size_t(leaves_) + std::size_t(leaf.x);
      return ScreenNode{whole.begin, whole.side, int(counts_[index])};
    }
    const int half = side / 2;
    const std::array brothers{combine(leaf, half), combine({leaf.x + half, leaf.y}, half),
                              combine({leaf.x, leaf.y + half}, half), combine(leaf + half, half)};
    if (std::ranges::all_of(brothers, [](const auto& node) { return node.has_value(); })) {
      const auto layers = [](const auto& node) { return node->layers; };
      const auto [least, most] = std::ranges::minmax(brothers, {}, layers);
      if (most->layers - least->layers <= threshold_)
        return ScreenNode{whole.begin, whole.side, most->layers};
    }
    for (const auto& node : brothers) keep(node);
    return std::nullopt;
  }

  void keep(const std::optional<ScreenNode>& node) {
    if (node && node->layers > 0) nodes_.push_back(*node);
  }

  std::span<const std::uint32_t> counts_;
  int leaves_, leaf_side_, threshold_;
  std::vector<ScreenNode> nodes_;
};

}  // namespace

std::vector<ScreenNode> screen_quadtree(std::span<const std::uint32_t> counts, int leaves, int leaf_side,
                                        int threshold) {
  return Builder(counts, leaves, leaf_side, threshold).build();
}

}  // namespace crest
