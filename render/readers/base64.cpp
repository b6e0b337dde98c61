#include "render/readers/base64.h"

#include <cstdint>

namespace crest {
namespace {

int value_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

std::vector<std::byte> decode_base64(std::string_view text, std::size_t count) {
  constexpr int group = 4;
  std::vector<std::byte> out;
  out.reserve(count);
  std::uint32_t bits = 0;
  int taken = 0, padding = 0;
  for (const char c : text) {
    if (out.size() >= count) break;
    if (c == ' ' || (c >= '\t' && c <= '\r')) continue;
    const int value = value_of(c);
    if (value < 0 && c != '=') break;
    padding += value < 0;
    bits = bits << 6 | std::uint32_t(value < 0 ? 0 : value);
    if (++taken < group) continue;
    for (int byte = 0; byte < 3 - padding && out.size() < count; ++byte)
      out.push_back(std::byte(bits >> (16 - 8 * byte) & 0xff));
    bits = 0;
    taken = padding = 0;
  }
  return out;
}

}  // namespace crest
