#include "render/readers/voxel_stream.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <vector>

#include "presets/error.h"
#include "render/readers/inflater.h"
#include "render/readers/text_voxels.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// One of a header's files: which bytes of voxels it holds.
struct VoxelFile {
  const std::string& name;
  const VoxelData& data;
  const fs::path& path;
  std::uint64_t bytes = 0;
};

class RawStream : public ByteStream {
 public:
  explicit RawStream(const VoxelFile& voxels)
      : voxels_(voxels),
        file_(voxels.path, std::ios::binary),
        begin_(voxels.data.at_file_end ? bytes_from(voxels.name, voxels.path, 0) - voxels.bytes
                                       : voxels.data.offset + voxels.data.skip) {}
  void read(std::uint64_t first, std::span<std::byte> out) override {
    file_.seekg(std::streamoff(begin_ + first));
    if (!file_.read(reinterpret_cast<char*>(out.data()), std::streamsize(out.size())))
      throw Error(fmt::format("{}: {} could not be read to its end", voxels_.name, voxels_.path.string()));
  }
  bool finish() override { return bytes_from(voxels_.name, voxels_.path, begin_) > voxels_.bytes; }

 private:
  VoxelFile voxels_;
  std::ifstream file_;
  std::uint64_t begin_;
};

constexpr std::size_t block_size = std::size_t(1) << 18;

/// What a file inflates to, in bytes; more than `most` is not counted.
std::uint64_t inflated_size(const VoxelFile& voxels, std::uint64_t most) {
  Inflater inflater(voxels.path, voxels.data.offset);
  std::vector<char> block(block_size);
  std::uint64_t held = 0;
  std::size_t got = 0;
  do {
    held += got = inflater.read(block);
  } while (got == block.size() && held <= most);
  return held;
}

/// Bytes before the voxels in the inflated stream.
std::uint64_t bytes_before(const VoxelFile& voxels) {
  if (!voxels.data.at_file_end) return voxels.data.skip;
  const std::uint64_t most = voxels.bytes + longest_skip, whole = inflated_size(voxels, most);
  if (whole > most)
    throw Error(fmt::format("{}: too much compressed data lies before its voxels", voxels.name));
  return whole > voxels.bytes ? whole - voxels.bytes : 0;
}

class DeflatedStream : public ByteStream {
 public:
  explicit DeflatedStream(const VoxelFile& voxels)
      : voxels_(voxels), skip_(bytes_before(voxels)), inflater_(voxels.path, voxels.data.offset) {}
  void read(std::uint64_t first, std::span<std::byte> out) override {
    pass_over(skip_ + first);
    const std::size_t got = inflater_.read({reinterpret_cast<char*>(out.data()), out.size()});
    held_ += got;
    if (got < out.size()) fail();
  }
  /// To its checksum, but no further where it goes on.
  bool finish() override {
    const std::uint64_t promised = skip_ + voxels_.bytes;
    pass_over(promised);
    std::vector<char> block(block_size);
    const std::size_t more = inflater_.read(block);
    held_ += more;
    if (!inflater_.fault().empty()) fail();
    return more > 0;
  }

 private:
  void pass_over(std::uint64_t end) {
    std::vector<char> block(std::min<std::uint64_t>(block_size, end - held_));
    while (held_ < end) {
      const std::size_t size = std::min<std::uint64_t>(block.size(), end - held_);
      const std::size_t got = inflater_.read(std::span(block).first(size));
      held_ += got;
      if (got < size) fail();
    }
  }
  [[noreturn]] void fail() const {
    const std::uint64_t promised = skip_ + voxels_.bytes;
    if (inflater_.fault().empty()) throw_short(voxels_.name, voxels_.data, promised, held_, "bytes");
    throw Error(fmt::format("{}: {} after {} of {} bytes", voxels_.name, inflater_.fault(), held_, promised));
  }

  VoxelFile voxels_;
  std::uint64_t skip_;
  Inflater inflater_;
  std::uint64_t held_ = 0;  ///< inflated so far
};

class DecimalStream : public ByteStream {
 public:
  /// `before`: values in the files before this one.
  DecimalStream(const VoxelFile& voxels, ScalarType type, std::uint64_t before)
      : value_size_(size_of(type)),
        file_(voxels.path, std::ios::binary),
        words_(file_, voxels.data.first_line),
        numbers_(voxels.name, words_, type, voxels.bytes / size_of(type), before) {
    file_.seekg(std::streamoff(voxels.data.offset));
  }
  void read(std::uint64_t first, std::span<std::byte> out) override {
    numbers_.skip(first / value_size_ - numbers_.taken());
    numbers_.read(out);
  }
  bool finish() override {
    numbers_.finish();
    std::string_view word;
    return words_.next(word);
  }

 private:
  std::size_t value_size_;
  std::ifstream file_;
  WordStream words_;
  NumberReader numbers_;
};

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char small = char(c | 0x20);
  return small >= 'a' && small <= 'f' ? small - 'a' + 10 : -1;
}

class HexadecimalStream : public ByteStream {
 public:
  explicit HexadecimalStream(const VoxelFile& voxels)
      : voxels_(voxels), file_(voxels.path, std::ios::binary) {
    file_.seekg(std::streamoff(voxels.data.offset));
  }
  void read(std::uint64_t first, std::span<std::byte> out) override {
    while (digits_ < 2 * first) next_digit();
    for (std::byte& byte : out) {
      const int high = next_digit();
      byte = std::byte(high * 16 + next_digit());
    }
  }
  bool finish() override {
    while (digits_ < 2 * voxels_.bytes) next_digit();
    return !(file_ >> std::ws).eof();
  }

 private:
  int next_digit() {
    for (char c; file_.get(c);) {
      const int digit = digit_of(c);
      if (digit < 0 && std::isspace(static_cast<unsigned char>(c))) continue;
      if (digit < 0)
        throw Error(
            fmt::format("{}: its voxels hold what is no hexadecimal digit, after {}", voxels_.name, digits_));
      ++digits_;
      return digit;
    }
    throw_short(voxels_.name, voxels_.data, 2 * voxels_.bytes, digits_, "hexadecimal digits");
  }

  VoxelFile voxels_;
  std::ifstream file_;
  std::uint64_t digits_ = 0;
};

std::unique_ptr<ByteStream> open_stream(const VoxelFile& voxels, ScalarType type, std::uint64_t before) {
  switch (voxels.data.encoding) {
    case Encoding::raw:
      break;
    case Encoding::deflate:
      return std::make_unique<DeflatedStream>(voxels);
    case Encoding::decimal:
      return std::make_unique<DecimalStream>(voxels, type, before);
    case Encoding::hexadecimal:
      return std::make_unique<HexadecimalStream>(voxels);
  }
  return std::make_unique<RawStream>(voxels);
}

}  // namespace

VoxelStream::VoxelStream(std::string name, const VoxelData& data, ScalarType type, std::uint64_t values)
    : name_(std::move(name)), data_(data), type_(type), share_(share_of(name_, data, values)) {}

/// Files of text that are passed over are checked too.
void VoxelStream::open(std::uint64_t file) {
  while (next_ <= file) {
    close();
    if (data_.encoding != Encoding::decimal) next_ = file;
    stream_ = open_stream({name_, data_, data_.files[next_], share_ * size_of(type_)}, type_, next_ * share_);
    ++next_;
  }
}

void VoxelStream::read(std::uint64_t first, std::span<std::byte> out) {
  const std::size_t value_size = size_of(type_);
  while (!out.empty()) {
    const std::uint64_t file = first / share_, from = first % share_;
    open(file);
    const std::uint64_t count = std::min<std::uint64_t>(share_ - from, out.size() / value_size);
    stream_->read(from * value_size, out.first(count * value_size));
    out = out.subspan(count * value_size);
    first += count;
  }
}

/// The open file is the one before the next.
void VoxelStream::close() {
  if (stream_ && stream_->finish() && !goes_on_) goes_on_ = data_.files[next_ - 1];
  stream_.reset();
}

std::optional<fs::path> VoxelStream::finish() {
  if (data_.encoding == Encoding::decimal) open(data_.files.size() - 1);
  close();
  return goes_on_;
}

}  // namespace crest
