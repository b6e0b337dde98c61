#pragma once

#include <algorithm>
#include <cstring>
#include <string_view>

namespace crest {

/// The numbers of a binary header, of either byte order. Offsets must lie within it.
struct BinaryFields {
  std::string_view bytes;
  bool swapped = false;  ///< against the machine's order

  template <class T>
  T at(std::size_t offset) const {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes.data() + offset, sizeof(T));
    if (swapped) std::reverse(raw, raw + sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }
};

}  // namespace crest
