#include "render/classify/cell_boxes.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>

namespace crest {
namespace {

/// A bit a cell, in rows along x of whole words: 64 cells at once are as fast as one.
class BitGrid {
 public:
  using Word = std::uint64_t;

  BitGrid(const std::vector<std::uint8_t>& cells, glm::ivec3 dims, bool shown)
      : width_(std::size_t(dims.x)),
        words_((width_ + 63) / 64),
        slice_(words_ * std::size_t(dims.y)),
        bits_(slice_ * std::size_t(dims.z)) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      if ((cells[i] != 0) == shown)
        bits_[i / width_ * words_ + i % width_ / 64] |= Word(1) << (i % width_ % 64);
  }

  /// Sets all cells beside one that is set, across edges and corners, too. Calls visit(cell) for each that
  /// was not, and tells whether there were any.
  template <class Visit>
  bool grow(const Visit& visit) {
    const std::vector<Word> before = bits_;
    std::vector<Word> along_x(bits_.size());
    for (std::size_t i = 0; i < bits_.size(); ++i) {
      const Word left = i % words_ > 0 ? bits_[i - 1] >> 63 : 0;
      const Word right = i % words_ + 1 < words_ ? bits_[i + 1] << 63 : 0;
      along_x[i] = bits_[i] | bits_[i] << 1 | bits_[i] >> 1 | left | right;
    }
    spread(along_x, words_, slice_, bits_);
    const std::vector<Word> along_y = bits_;
    spread(along_y, slice_, bits_.size(), bits_);
    bool any = false;
    for (std::size_t i = 0; i < bits_.size(); ++i)
      for (Word fresh = bits_[i] & ~before[i]; fresh != 0; fresh &= fresh - 1) {
        const std::size_t x = i % words_ * 64 + std::size_t(std::countr_zero(fresh));
        if (x >= width_) break;
        visit(i / words_ * width_ + x);
        any = true;
      }
    return any;
  }

 private:
  /// Each word with those one `stride` before and behind it, in blocks of so many words.
  static void spread(const std::vector<Word>& from, std::size_t stride, std::size_t block,
                     std::vector<Word>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const std::size_t at = i % block;
      to[i] = from[i] | (at >= stride ? from[i - stride] : 0) | (at + stride < block ? from[i + stride] : 0);
    }
  }

  std::size_t width_, words_, slice_;  ///< of a row in cells and in words, of a slice in words
  std::vector<Word> bits_;
};

}  // namespace

std::vector<CellBox> occupied_boxes(const std::vector<std::uint8_t>& cells, glm::ivec3 dims) {
  const glm::ivec3 blocks = (dims + block_side - 1) / block_side;
  const CellBox nothing{dims, glm::ivec3(-1)};
  std::vector<CellBox> boxes(std::size_t(blocks.x) * std::size_t(blocks.y) * std::size_t(blocks.z), nothing);
  const std::uint8_t* cell = cells.data();
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y) {
      CellBox* row = &boxes[std::size_t((z / block_side * blocks.y + y / block_side) * blocks.x)];
      for (int x = 0; x < dims.x; ++x, ++cell) {
        if (!*cell) continue;
        CellBox& box = row[x / block_side];
        box.first = glm::min(box.first, glm::ivec3(x, y, z));
        box.last = glm::max(box.last, glm::ivec3(x, y, z));
      }
    }
  std::erase_if(boxes, [](const CellBox& box) { return box.last.x < 0; });
  return boxes;
}

std::vector<std::int8_t> distances(const std::vector<std::uint8_t>& cells, glm::ivec3 dims) {
  std::vector<std::int8_t> result(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    result[i] = cells[i] ? greatest_distance : -greatest_distance;
  for (const bool shown : {true, false}) {
    BitGrid near(cells, dims, shown);
    int distance = 1;
    const auto store = [&](std::size_t cell) { result[cell] = std::int8_t(shown ? -distance : distance); };
    while (distance < greatest_distance && near.grow(store)) ++distance;
  }
  return result;
}

}  // namespace crest
