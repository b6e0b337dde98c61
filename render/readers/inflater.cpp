#include "render/readers/inflater.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "presets/error.h"

namespace crest {

Inflater::Inflater(const std::filesystem::path& path, std::uint64_t offset)
    : file_(path, std::ios::binary), in_(std::size_t(1) << 18) {
  constexpr int zlib_or_gzip = 15 + 32;
  file_.seekg(std::streamoff(offset));
  if (inflateInit2(&stream_, zlib_or_gzip) != Z_OK) throw Error("zlib could not be started");
}

std::size_t Inflater::read(std::span<char> out) {
  constexpr std::size_t most_at_once = std::numeric_limits<uInt>::max();
  std::size_t done = 0;
  while (done < out.size() && !ended_ && fault_.empty()) {
    const std::size_t size = std::min(out.size() - done, most_at_once);
    stream_.next_out = reinterpret_cast<Bytef*>(out.data() + done);
    stream_.avail_out = uInt(size);
    while (stream_.avail_out > 0 && !ended_ && fault_.empty()) step();
    done += size - stream_.avail_out;
  }
  return done;
}

bool Inflater::refill() {
  if (stream_.avail_in > 0) return true;
  file_.read(in_.data(), std::streamsize(in_.size()));
  stream_.next_in = reinterpret_cast<Bytef*>(in_.data());
  stream_.avail_in = uInt(file_.gcount());
  return stream_.avail_in > 0;
}

void Inflater::step() {
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

}  // namespace crest
