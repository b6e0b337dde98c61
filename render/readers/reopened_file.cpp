#include "render/readers/reopened_file.h"

#include <algorithm>

#include "render/readers/open_file.h"

namespace crest {

ReopenedFile::ReopenedFile(std::filesystem::path path, std::uint64_t offset)
    : path_(std::move(path)), size_(std::filesystem::file_size(path_)), at_(std::min(offset, size_)) {}

void ReopenedFile::skip(std::uint64_t count) {
  const std::uint64_t here = std::min(count, in_block());
  gbump(int(here));
  at_ += std::min(count - here, size_ - at_);
}

std::size_t ReopenedFile::take(char* out, std::size_t count) {
  std::ifstream file = open_file(path_, at_);
  file.read(out, std::streamsize(std::min<std::uint64_t>(count, size_ - at_)));
  const auto taken = std::size_t(file.gcount());
  at_ += taken;
  return taken;
}

ReopenedFile::int_type ReopenedFile::underflow() {
  block_.resize(block_bytes);
  const std::size_t taken = take(block_.data(), block_.size());
  setg(block_.data(), block_.data(), block_.data() + taken);
  return taken > 0 ? traits_type::to_int_type(*gptr()) : traits_type::eof();
}

/// What is longer than a block is read where it is wanted.
std::streamsize ReopenedFile::xsgetn(char* out, std::streamsize count) {
  const auto here = std::streamsize(std::min(std::uint64_t(count), in_block())), rest = count - here;
  std::copy_n(gptr(), here, out);
  gbump(int(here));
  if (rest < std::streamsize(block_bytes)) return here + std::streambuf::xsgetn(out + here, rest);
  return here + std::streamsize(take(out + here, std::size_t(rest)));
}

}  // namespace crest
