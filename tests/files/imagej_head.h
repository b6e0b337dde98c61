#pragma once

#include <array>
#include <initializer_list>
#include <string>

#include "tests/files/files.h"

namespace crest::test {

/// What ImageJ writes before the pixels of a file over 4 GB: the directory of one image of 16 bits, whose
/// strip is said to be `strip_bytes` long.
inline std::string imagej_head(int width, int height, std::endian order, const std::string& description,
                               double strip_bytes) {
  const bool big = order == std::endian::big;
  std::string out = big ? std::string("MM\0*", 4) : std::string("II*\0", 4);
  using enum ScalarType;
  const auto put = [&](double value, ScalarType type) { append_value(out, value, type, order); };
  constexpr std::size_t entries = 10, directory = 8, text_at = directory + 2 + 12 * entries + 4;
  const double pixels_at = double((text_at + description.size() + 2) / 2 * 2);
  put(directory, uint32);
  put(entries, uint16);
  for (const auto& [tag, type, count, value] :
       std::initializer_list<std::array<double, 4>>{{256, 4, 1, double(width)},
                                                    {257, 4, 1, double(height)},
                                                    {258, 3, 1, 16},
                                                    {259, 3, 1, 1},
                                                    {262, 3, 1, 1},
                                                    {270, 2, double(description.size() + 1), double(text_at)},
                                                    {273, 4, 1, pixels_at},
                                                    {277, 3, 1, 1},
                                                    {278, 4, 1, double(height)},
                                                    {279, 4, 1, strip_bytes}}) {
    put(tag, uint16);
    put(type, uint16);
    put(count, uint32);
    put(value, type == 3 ? uint16 : uint32);
    if (type == 3) put(0, uint16);
  }
  put(0, uint32);
  out += description;
  out.resize(std::size_t(pixels_at), '\0');
  return out;
}

}  // namespace crest::test
