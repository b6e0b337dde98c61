#include "render/readers/voxel_data.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>
#include <span>

#include "presets/error.h"

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

/// Hands the inflated voxels on in blocks, and makes sure that there are `voxel_bytes` of them.
template <class Sink>
void inflate_all(const std::string& name, const VoxelData& data, std::uint64_t voxel_bytes, Sink sink) {
  const std::uint64_t promised = data.skip + voxel_bytes;
  std::uint64_t held = 0;
  std::vector<char> block(block_size);
  for (const fs::path& path : data.files) {
    Inflater inflater(path, data.offset);
    std::size_t got = 0;
    do {
      got = inflater.read(block);
      const std::uint64_t before = held < data.skip ? std::min<std::uint64_t>(data.skip - held, got) : 0;
      sink(std::span<const char>(block).first(got).subspan(before));
      held += got;
    } while (got == block.size() && held <= promised + block_size);
    if (!inflater.fault().empty()) {
      throw Error(fmt::format("{}: {} after {} of {} bytes", name, inflater.fault(), held, promised));
    }
  }
  if (held < promised) throw_short(name, data, promised, held, "bytes");
}

std::uint64_t count_numbers(const fs::path& path, std::uint64_t offset) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(std::streamoff(offset));
  std::vector<char> block(block_size);
  std::uint64_t count = 0;
  bool within = false;
  while (file.read(block.data(), std::streamsize(block.size())), file.gcount() > 0) {
    for (const char c : std::span(block).first(std::size_t(file.gcount()))) {
      const bool separator = std::isspace(static_cast<unsigned char>(c)) || c == ',';
      count += !separator && !within;
      within = !separator;
    }
  }
  return count;
}

}  // namespace

void require_room(const std::string& name, const VoxelData& data, std::uint64_t values,
                  std::uint64_t value_size) {
  std::uint64_t held = 0;
  for (const fs::path& path : data.files) held += bytes_from(name, path, data.offset);
  const std::uint64_t bytes = values * value_size + data.skip;
  switch (data.encoding) {
    case Encoding::raw:
      if (held < bytes) throw_short(name, data, bytes, held, "bytes");
      break;
    case Encoding::deflate:
      if (held < bytes / greatest_inflation) throw_short(name, data, bytes, held, "bytes (compressed)");
      break;
    case Encoding::decimal:
      if (held < values * 2 - 1) throw_short(name, data, values, held, "numbers as text");
      break;
    case Encoding::hexadecimal:
      if (held < bytes * 2) throw_short(name, data, bytes * 2, held, "hexadecimal digits");
      break;
  }
}

void require_all(const std::string& name, const VoxelData& data, std::uint64_t values,
                 std::uint64_t value_size) {
  if (data.encoding == Encoding::deflate) inflate_all(name, data, values * value_size, [](auto) {});
  if (data.encoding == Encoding::decimal) {
    std::uint64_t held = 0;
    for (const fs::path& path : data.files) held += count_numbers(path, data.offset);
    if (held < values) throw_short(name, data, values, held, "numbers");
  }
}

void inflate_voxels(const std::string& name, const VoxelData& data, std::span<std::byte> out) {
  std::size_t done = 0;
  inflate_all(name, data, out.size(), [&](std::span<const char> block) {
    const std::size_t size = std::min(block.size(), out.size() - done);
    if (size > 0) std::memcpy(out.data() + done, block.data(), size);
    done += size;
  });
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
