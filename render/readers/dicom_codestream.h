#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace crest {

/// What a compressed image says of itself. DICOM says the same in its own elements, which may be wrong.
struct Codestream {
  enum class Kind { jpeg, jpeg_ls, jpeg_2000 };
  Kind kind;
  unsigned bits = 0, samples = 0;
  bool is_signed = false;               ///< JPEG 2000 alone says it
  std::uint64_t columns = 0, rows = 0;  ///< rows: 0 where it says them later
};

/// Of JPEG (ITU-T T.81, B.2.2), JPEG-LS (T.87, C.2.2) and JPEG 2000 (T.800, A.5.1). Nothing of others, and
/// where there is no such header.
std::optional<Codestream> read_codestream(std::span<const std::byte> bytes);

}  // namespace crest
