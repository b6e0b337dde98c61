// "XML file formats" of the VTK User's Guide: an array is [bytes][data], or, compressed, [blocks][bytes of a
// block] [bytes of the last one, or 0][compressed bytes of each block][data].
#include "render/readers/vti_data.h"

#include <fmt/core.h>
#include <zlib.h>

#include <fstream>
#include <functional>

#include "presets/error.h"
#include "render/readers/base64.h"
#include "render/readers/binary_fields.h"

namespace crest {
namespace {

/// The bytes [0, count) from the array's begin on, or as many as there are.
using Begin = std::function<std::vector<std::byte>(std::uint64_t count)>;

[[noreturn]] void throw_length(const std::string& name, std::uint64_t held, std::uint64_t promised) {
  throw Error(fmt::format("{}: its extent promises {} bytes of the array, and the array has {}", name,
                          promised, held));
}

std::uint64_t length_at(const std::vector<std::byte>& bytes, std::size_t i, const VtiCoding& coding) {
  const BinaryFields fields{{reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                            coding.endian != std::endian::native};
  const std::size_t offset = i * coding.header_bytes;
  return coding.header_bytes == 8 ? fields.at<std::uint64_t>(offset) : fields.at<std::uint32_t>(offset);
}

std::vector<std::byte> at_least(const std::string& name, const Begin& begin, std::uint64_t count) {
  std::vector<std::byte> bytes = begin(count);
  if (bytes.size() < count)
    throw Error(fmt::format("{}: the array ends after {} of {} bytes", name, bytes.size(), count));
  return bytes;
}

std::vector<std::byte> inflate_blocks(const std::string& name, const Begin& begin, const VtiCoding& coding,
                                      std::uint64_t promised) {
  constexpr std::uint64_t most_blocks = std::uint64_t(1) << 32;
  const std::size_t word = coding.header_bytes;
  const std::uint64_t blocks = length_at(at_least(name, begin, word), 0, coding);
  if (blocks == 0 || blocks > most_blocks || blocks > promised) throw_length(name, 0, promised);
  const std::vector<std::byte> header = at_least(name, begin, (3 + blocks) * word);
  const std::uint64_t block = length_at(header, 1, coding), last = length_at(header, 2, coding);
  const bool fits = block > 0 && last <= block && blocks == (promised - 1) / block + 1;  // so none overflows
  const std::uint64_t held = fits ? (blocks - 1) * block + (last > 0 ? last : block) : 0;
  if (!fits || held != promised) throw_length(name, held, promised);
  std::uint64_t packed = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t length = length_at(header, 3 + i, coding);
    if (length > compressBound(std::min(block, promised)))
      throw Error(fmt::format("{}: the array's compressed data is damaged", name));
    packed += length;
  }
  const std::vector<std::byte> all = at_least(name, begin, header.size() + packed);
  std::vector<std::byte> out(promised);
  std::uint64_t from = header.size();
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t length = length_at(header, 3 + i, coding),
                        want = std::min(block, promised - i * block);
    uLongf got = want;
    const int result = uncompress(reinterpret_cast<Bytef*>(out.data() + i * block), &got,
                                  reinterpret_cast<const Bytef*>(all.data() + from), length);
    if (result != Z_OK || got != want)
      throw Error(
          fmt::format("{}: the array's compressed data is damaged in block {} of {}", name, i + 1, blocks));
    from += length;
  }
  return out;
}

std::vector<std::byte> read_array(const std::string& name, const Begin& begin, const VtiCoding& coding,
                                  std::uint64_t promised) {
  if (coding.compressed) return inflate_blocks(name, begin, coding, promised);
  const std::uint64_t held = length_at(at_least(name, begin, coding.header_bytes), 0, coding);
  if (held != promised) throw_length(name, held, promised);
  std::vector<std::byte> bytes = at_least(name, begin, coding.header_bytes + promised);
  bytes.erase(bytes.begin(), bytes.begin() + std::ptrdiff_t(coding.header_bytes));
  return bytes;
}

std::vector<std::byte> bytes_at(const std::filesystem::path& path, std::uint64_t offset,
                                std::uint64_t count) {
  const std::uint64_t size = std::filesystem::file_size(path);
  std::vector<std::byte> bytes(std::min(count, size > offset ? size - offset : 0));
  std::ifstream file(path, std::ios::binary);
  file.seekg(std::streamoff(offset));
  file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
  bytes.resize(std::size_t(file.gcount()));
  return bytes;
}

}  // namespace

std::vector<std::byte> read_vti_base64(const std::string& name, std::string_view text,
                                       const VtiCoding& coding, std::uint64_t promised) {
  return read_array(
      name, [&](std::uint64_t count) { return decode_base64(text, count); }, coding, promised);
}

std::vector<std::byte> read_vti_raw(const std::string& name, const std::filesystem::path& path,
                                    std::uint64_t offset, const VtiCoding& coding, std::uint64_t promised) {
  return read_array(
      name, [&](std::uint64_t count) { return bytes_at(path, offset, count); }, coding, promised);
}

std::uint64_t find_vti_raw(const std::string& name, const std::filesystem::path& path, std::uint64_t offset,
                           const VtiCoding& coding, std::uint64_t promised) {
  const Begin begin = [&](std::uint64_t count) { return bytes_at(path, offset, count); };
  const std::uint64_t held = length_at(at_least(name, begin, coding.header_bytes), 0, coding);
  if (held != promised) throw_length(name, held, promised);
  const std::uint64_t first = offset + coding.header_bytes, end = std::filesystem::file_size(path);
  if (end - first < promised)
    throw Error(fmt::format("{}: the array ends after {} of {} bytes", name, end - first, promised));
  return first;
}

}  // namespace crest
