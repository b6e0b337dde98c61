#include "render/readers/voxel_data.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>
#include <span>

#include "presets/error.h"
#include "render/readers/text_voxels.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t block_size = std::size_t(1) << 18;
constexpr std::uint64_t greatest_inflation = 1032;  ///< of the deflate format, in bytes out for one in

std::uint64_t bytes_from(const std::string& name, const fs::path& path, std::uint64_t offset) {
  std::error_code fault;
  const std::uint64_t size = fs::file_size(path, fault);
  if (fault) throw Error(fmt::format("{}: its voxels are in {}, which cannot be read", name, path.string()));
  return size > offset ? size - offset : 0;
}

[[noreturn]] void throw_short(const std::string& name, const VoxelData& data, std::uint64_t promised,
                              std::uint64_t held, std::string_view unit) {
  const std::string where = data.files.size() == 1 ? data.files[0].filename().string()
                                                   : fmt::format("its {} files", data.files.size());
  throw Error(fmt::format("{}: the header promises {} {} of voxels, and {} has {}", name, promised, unit,
                          where, held));
}

/// A zlib or gzip stream (or several gzip members) that is read from within a file.
class Inflater {
 public:
  Inflater(const fs::path& path, std::uint64_t offset) : file_(path, std::ios::binary), in_(block_size) {
    constexpr int zlib_or_gzip = 15 + 32;
    file_.seekg(std::streamoff(offset));
    if (inflateInit2(&stream_, zlib_or_gzip) != Z_OK) throw Error("zlib could not be started");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Fills `out` as far as the stream goes; what it could not tells `fault`.
  std::size_t read(std::span<char> out) {
    stream_.next_out = reinterpret_cast<Bytef*>(out.data());
    stream_.avail_out = uInt(out.size());
    while (stream_.avail_out > 0 && !ended_ && fault_.empty()) step();
    return out.size() - stream_.avail_out;
  }
  const std::string& fault() const { return fault_; }

 private:
  bool refill() {
    if (stream_.avail_in > 0) return true;
    file_.read(in_.data(), std::streamsize(in_.size()));
    stream_.next_in = reinterpret_cast<Bytef*>(in_.data());
    stream_.avail_in = uInt(file_.gcount());
    return stream_.avail_in > 0;
  }

  void step() {
    if (!refill()) {
      fault_ = "the compressed data ends early";
      return;
    }
    const int result = inflate(&stream_, Z_NO_FLUSH);
    if (result == Z_STREAM_END) {
      constexpr Bytef gzip_magic = 0x1f;
      ended_ = !refill() || *stream_.next_in != gzip_magic || inflateReset(&stream_) != Z_OK;
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      fault_ = fmt::format("the compressed data is damaged ({})", stream_.msg ? stream_.msg : "no detail");
    }
  }

  std::ifstream file_;
  std::vector<char> in_;
  z_stream stream_{};
  bool ended_ = false;
  std::string fault_;
};

/// The values of one file that are kept, counted from its first one.
struct Part {
  const fs::path& file;
  std::uint64_t values, first, taken;
};

/// Compressed data that is far longer than the voxels is not inflated to find where they begin.
constexpr std::uint64_t longest_skip = std::uint64_t(1) << 24;

void read_raw(const std::string& name, const VoxelData& data, const Part& part, std::size_t value_size,
              std::vector<std::byte>& out) {
  const std::uint64_t bytes = part.values * value_size, kept = part.taken * value_size;
  const std::uint64_t begin =
      data.at_file_end ? bytes_from(name, part.file, 0) - bytes : data.offset + data.skip;
  std::ifstream file(part.file, std::ios::binary);
  file.seekg(std::streamoff(begin + part.first * value_size));
  const std::size_t done = out.size();
  out.resize(done + kept);
  if (!file.read(reinterpret_cast<char*>(out.data() + done), std::streamsize(kept)))
    throw Error(fmt::format("{}: {} could not be read to its end", name, part.file.string()));
}

/// What a file inflates to, in bytes; more than `most` is not counted.
std::uint64_t inflated_size(const VoxelData& data, const fs::path& file, std::uint64_t most) {
  Inflater inflater(file, data.offset);
  std::vector<char> block(block_size);
  std::uint64_t held = 0;
  std::size_t got = 0;
  do {
    held += got = inflater.read(block);
  } while (got == block.size() && held <= most);
  return held;
}

void read_deflated(const std::string& name, const VoxelData& data, const Part& part, std::size_t value_size,
                   std::vector<std::byte>& out) {
  const std::uint64_t bytes = part.values * value_size;
  std::uint64_t skip = data.skip;
  if (data.at_file_end) {
    const std::uint64_t whole = inflated_size(data, part.file, bytes + longest_skip);
    if (whole > bytes + longest_skip)
      throw Error(fmt::format("{}: too much compressed data lies before its voxels", name));
    skip = whole > bytes ? whole - bytes : 0;
  }
  const std::uint64_t promised = skip + bytes;
  const std::uint64_t begin = skip + part.first * value_size, end = begin + part.taken * value_size;
  Inflater inflater(part.file, data.offset);
  std::vector<char> block(block_size);
  std::uint64_t held = 0;
  std::size_t got = 0;
  do {
    got = inflater.read(block);
    const std::uint64_t from = std::max(held, begin), to = std::min(held + got, end);
    if (from < to) {
      const auto* inflated = reinterpret_cast<const std::byte*>(block.data());
      out.insert(out.end(), inflated + (from - held), inflated + (to - held));
    }
    held += got;
  } while (got == block.size() && held <= promised + block_size);
  if (!inflater.fault().empty())
    throw Error(fmt::format("{}: {} after {} of {} bytes", name, inflater.fault(), held, promised));
  if (held < promised) throw_short(name, data, promised, held, "bytes");
}

void read_text(const std::string& name, const VoxelData& data, const Part& part, ScalarType type,
               std::uint64_t before, std::vector<std::byte>& out) {
  std::ifstream file(part.file, std::ios::binary);
  file.seekg(std::streamoff(data.offset));
  WordStream text(file, data.first_line);
  read_numbers(name, text, {type, part.values, part.first, part.taken}, out, before);
}

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char small = char(c | 0x20);
  return small >= 'a' && small <= 'f' ? small - 'a' + 10 : -1;
}

void read_hexadecimal(const std::string& name, const VoxelData& data, const Part& part,
                      std::size_t value_size, std::vector<std::byte>& out) {
  std::ifstream file(part.file, std::ios::binary);
  file.seekg(std::streamoff(data.offset));
  const std::uint64_t digits = 2 * part.values * value_size;
  const std::uint64_t begin = part.first * value_size, end = begin + part.taken * value_size;
  std::uint64_t held = 0;
  int high = 0;
  for (char c; held < digits && file.get(c);) {
    const int digit = digit_of(c);
    if (digit < 0 && std::isspace(static_cast<unsigned char>(c))) continue;
    if (digit < 0)
      throw Error(fmt::format("{}: its voxels hold what is no hexadecimal digit, after {}", name, held));
    const std::uint64_t byte = held++ / 2;
    if (held % 2 == 0 && byte >= begin && byte < end) out.push_back(std::byte(high * 16 + digit));
    high = digit;
  }
  if (held < digits) throw_short(name, data, digits, held, "hexadecimal digits");
}

/// Of `values`, how many are in each file.
std::uint64_t share_of(const std::string& name, const VoxelData& data, std::uint64_t values) {
  const std::uint64_t files = data.files.size();
  if (files > 0 && values % files == 0) return values / files;
  throw Error(
      fmt::format("{}: {} numbers of voxels cannot be in {} files of one length", name, values, files));
}

}  // namespace

void require_room(const std::string& name, const VoxelData& data, std::uint64_t values,
                  std::uint64_t value_size) {
  constexpr std::uint64_t most = std::uint64_t(1) << 60;  // which leaves room for digits, and to add
  const std::uint64_t share = share_of(name, data, values), files = data.files.size();
  const auto share_bytes = checked_product(share, value_size);
  const std::uint64_t bytes = std::min(share_bytes.value_or(most), most) + std::min(data.skip, most);
  if (bytes > most / files || data.offset > most)
    throw Error(fmt::format("{}: its header promises voxels beyond any file's end", name));
  std::uint64_t held = 0;
  for (const fs::path& path : data.files) held += bytes_from(name, path, data.at_file_end ? 0 : data.offset);
  switch (data.encoding) {
    case Encoding::raw:
      for (const fs::path& path : data.files) {
        if (bytes_from(name, path, data.at_file_end ? 0 : data.offset) < bytes)
          throw_short(name, data, bytes * files, held, "bytes");
      }
      break;
    case Encoding::deflate:
      if (data.skip > share * value_size + longest_skip) {
        throw Error(
            fmt::format("{}: its voxels begin after {} bytes of compressed data, and are {} themselves", name,
                        data.skip, share * value_size));
      }
      if (held < bytes * files / greatest_inflation)
        throw_short(name, data, bytes * files, held, "bytes (compressed)");
      break;
    case Encoding::decimal:
      if (held < values * 2 - 1) throw_short(name, data, values * 2 - 1, held, "characters");
      break;
    case Encoding::hexadecimal:
      if (held < bytes * files * 2) throw_short(name, data, bytes * files * 2, held, "hexadecimal digits");
      break;
  }
}

std::vector<std::byte> read_stored(const std::string& name, const VoxelData& data, ScalarType type,
                                   std::uint64_t values, std::uint64_t first, std::uint64_t taken) {
  const std::uint64_t share = share_of(name, data, values);
  std::vector<std::byte> out;
  out.reserve(taken * size_of(type));
  for (std::size_t f = 0; f < data.files.size(); ++f) {
    const std::uint64_t begin = f * share, end = begin + share;
    const std::uint64_t from = std::clamp(first, begin, end), to = std::clamp(first + taken, begin, end);
    const Part part{data.files[f], share, from - begin, to - from};
    if (data.encoding == Encoding::decimal) read_text(name, data, part, type, begin, out);
    if (part.taken == 0) continue;
    if (data.encoding == Encoding::raw) read_raw(name, data, part, size_of(type), out);
    if (data.encoding == Encoding::deflate) read_deflated(name, data, part, size_of(type), out);
    if (data.encoding == Encoding::hexadecimal) read_hexadecimal(name, data, part, size_of(type), out);
  }
  return out;
}

std::string read_head(const fs::path& path, std::size_t size, bool inflate) {
  std::string head(size, '\0');
  std::size_t got = 0;
  if (inflate) {
    got = Inflater(path, 0).read(head);
  } else {
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), std::streamsize(size));
    got = std::size_t(file.gcount());
  }
  head.resize(got);
  return head;
}

}  // namespace crest
