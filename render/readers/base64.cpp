#include "render/readers/base64.h"

namespace crest {
namespace {

int value_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

std::size_t Base64Reader::read(std::span<std::byte> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (left_ == 0 && !next_group()) return i;
    out[i] = std::byte(bits_ >> 16 & 0xff);
    bits_ <<= 8;
    --left_;
  }
  return out.size();
}

/// False where the text ends, or holds what is no such digit.
bool Base64Reader::next_group() {
  constexpr int digits = 4;
  while (left_ == 0) {  // padding alone is a group, too
    left_ = 3;
    bits_ = 0;
    for (int taken = 0; taken < digits;) {
      const int next = text_.sbumpc();
      const char c = char(next);
      if (c == ' ' || (c >= '\t' && c <= '\r')) continue;
      const int value = value_of(c);
      if (next == std::char_traits<char>::eof() || (value < 0 && c != '=')) return left_ = 0, false;
      if (value < 0) --left_;
      bits_ = bits_ << 6 | std::uint32_t(value < 0 ? 0 : value);
      ++taken;
    }
    if (left_ < 0) left_ = 0;
  }
  return true;
}

}  // namespace crest
