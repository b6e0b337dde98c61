// "XML file formats" of the VTK User's Guide: an array is [bytes][data], or, compressed, [blocks][bytes of a
// block] [bytes of the last one, or 0][compressed bytes of each block][data].
#include "render/readers/vti_data.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <numeric>

#include "presets/error.h"
#include "render/readers/base64.h"
#include "render/readers/binary_fields.h"
#include "render/readers/reopened_file.h"
#include "render/volume/convert.h"

namespace crest {
namespace {

class RawBytes : public VtiBytes {
 public:
  RawBytes(const std::filesystem::path& path, std::uint64_t offset) : file_(path, offset) {}
  std::size_t read(std::span<std::byte> out) override {
    return std::size_t(file_.sgetn(reinterpret_cast<char*>(out.data()), std::streamsize(out.size())));
  }
  void skip(std::uint64_t count) override { file_.skip(count); }
  std::optional<std::uint64_t> left() const override { return file_.left(); }

 private:
  ReopenedFile file_;
};

class Base64Bytes : public VtiBytes {
 public:
  explicit Base64Bytes(std::unique_ptr<std::streambuf> text) : text_(std::move(text)), reader_(*text_) {}
  std::size_t read(std::span<std::byte> out) override { return reader_.read(out); }
  void skip(std::uint64_t count) override {
    std::byte over[4096];
    while (count > 0) {
      const std::size_t part = std::min<std::uint64_t>(count, sizeof over);
      if (reader_.read(std::span(over).first(part)) < part) return;
      count -= part;
    }
  }

 private:
  std::unique_ptr<std::streambuf> text_;
  Base64Reader reader_;
};

/// What both kinds of arrays have.
struct VtiArray {
  std::string name;
  std::unique_ptr<VtiBytes> bytes;
  VtiCoding coding;
  ScalarType type = ScalarType::float32;
  std::uint64_t promised = 0;
};

[[noreturn]] void throw_length(const VtiArray& array, std::uint64_t held) {
  throw Error(fmt::format("{}: its extent promises {} bytes of the array, and the array has {}", array.name,
                          array.promised, held));
}

void fill(const VtiArray& array, std::span<std::byte> out, const char* what) {
  if (const std::size_t got = array.bytes->read(out); got < out.size())
    throw Error(fmt::format("{}: the array ends after {} of {} bytes{}", array.name, got, out.size(), what));
}

/// The next numbers of what says the array's lengths. No more is taken than the file has.
std::vector<std::uint64_t> take_lengths(const VtiArray& array, std::uint64_t count) {
  const std::size_t word = array.coding.header_bytes;
  std::vector<std::uint64_t> lengths;
  char bytes[8];
  const BinaryFields fields{{bytes, word}, array.coding.endian != std::endian::native};
  for (std::uint64_t i = 0; i < count; ++i) {
    fill(array, std::as_writable_bytes(std::span(bytes, word)), " of its lengths");
    lengths.push_back(word == 8 ? fields.at<std::uint64_t>(0) : fields.at<std::uint32_t>(0));
  }
  return lengths;
}

/// A part of the array may not show that its file is cut.
void require_left(const VtiArray& array, std::uint64_t bytes, const char* what) {
  if (const auto left = array.bytes->left(); left && *left < bytes)
    throw Error(fmt::format("{}: the array ends after {} of {} bytes{}", array.name, *left, bytes, what));
}

void to_machine_order(const VtiArray& array, std::span<std::byte> bytes) {
  if (array.coding.endian != std::endian::native) swap_bytes(bytes, size_of(array.type));
}

class PlainArray : public ByteStream {
 public:
  explicit PlainArray(VtiArray array) : array_(std::move(array)) {
    const std::uint64_t held = take_lengths(array_, 1)[0];
    if (held != array_.promised) throw_length(array_, held);
    require_left(array_, held, "");
  }
  void read(std::uint64_t first, std::span<std::byte> out) override {
    array_.bytes->skip(first - at_);
    at_ = first;
    const std::size_t got = array_.bytes->read(out);
    at_ += got;
    if (got < out.size())
      throw Error(fmt::format("{}: the array ends after {} of {} bytes", array_.name, at_, array_.promised));
    to_machine_order(array_, out);
  }

 private:
  VtiArray array_;
  std::uint64_t at_ = 0;
};

class BlockArray : public ByteStream {
 public:
  explicit BlockArray(VtiArray array) : array_(std::move(array)) {
    constexpr std::uint64_t most_blocks = std::uint64_t(1) << 32;
    const std::uint64_t promised = array_.promised, blocks = take_lengths(array_, 1)[0];
    if (blocks == 0 || blocks > most_blocks || blocks > promised) throw_length(array_, 0);
    const auto sizes = take_lengths(array_, 2);
    const std::uint64_t last = sizes[1];
    block_bytes_ = sizes[0];
    const bool fits =  // so none overflows
        block_bytes_ > 0 && last <= block_bytes_ && blocks == (promised - 1) / block_bytes_ + 1;
    const std::uint64_t held = fits ? (blocks - 1) * block_bytes_ + (last > 0 ? last : block_bytes_) : 0;
    if (!fits || held != promised) throw_length(array_, held);
    packed_ = take_lengths(array_, blocks);
    for (const std::uint64_t length : packed_)
      if (length > compressBound(std::min(block_bytes_, promised)))
        throw Error(fmt::format("{}: the array's compressed data is damaged", array_.name));
    require_left(array_, std::reduce(packed_.begin(), packed_.end()), " of its blocks");
  }
  void read(std::uint64_t first, std::span<std::byte> out) override {
    for (std::size_t done = 0; done < out.size();) {
      go_to((first + done) / block_bytes_);
      const std::size_t from = (first + done) % block_bytes_,
                        count = std::min(block_.size() - from, out.size() - done);
      std::ranges::copy(std::span(block_).subspan(from, count), out.begin() + std::ptrdiff_t(done));
      done += count;
    }
    to_machine_order(array_, out);  // a value may lie across two blocks
  }

 private:
  void go_to(std::uint64_t block) {
    if (block + 1 == next_) return;
    for (; next_ < block; ++next_) array_.bytes->skip(packed_[next_]);
    std::vector<std::byte> packed(packed_[block]);
    fill(array_, packed, " of a block");
    block_.resize(std::min(block_bytes_, array_.promised - block * block_bytes_));
    uLongf got = block_.size();
    const int result = uncompress(reinterpret_cast<Bytef*>(block_.data()), &got,
                                  reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (result != Z_OK || got != block_.size())
      throw Error(fmt::format("{}: the array's compressed data is damaged in block {} of {}", array_.name,
                              block + 1, packed_.size()));
    next_ = block + 1;
  }

  VtiArray array_;
  std::uint64_t block_bytes_ = 0;
  std::vector<std::uint64_t> packed_;  ///< bytes of each block
  std::uint64_t next_ = 0;             ///< block in the file
  std::vector<std::byte> block_;       ///< the one before it
};

}  // namespace

std::unique_ptr<VtiBytes> raw_vti_bytes(const std::filesystem::path& file, std::uint64_t offset) {
  return std::make_unique<RawBytes>(file, offset);
}

std::unique_ptr<VtiBytes> base64_vti_bytes(std::unique_ptr<std::streambuf> text) {
  return std::make_unique<Base64Bytes>(std::move(text));
}

std::unique_ptr<ByteStream> open_vti_array(const std::string& name, std::unique_ptr<VtiBytes> bytes,
                                           const VtiCoding& coding, ScalarType type, std::uint64_t promised) {
  VtiArray array{name, std::move(bytes), coding, type, promised};
  if (coding.compressed) return std::make_unique<BlockArray>(std::move(array));
  return std::make_unique<PlainArray>(std::move(array));
}

}  // namespace crest
