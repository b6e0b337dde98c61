#pragma once

#include <cstdint>
#include <filesystem>
#include <streambuf>
#include <vector>

namespace crest {

/// A file's bytes from `offset` on, as they are asked for. The file is open only while a block of them is
/// taken, so that thousands can be read side by side. Throws Error where it cannot be opened.
class ReopenedFile : public std::streambuf {
 public:
  ReopenedFile(std::filesystem::path path, std::uint64_t offset);
  /// Passes over so many bytes, or all that are left.
  void skip(std::uint64_t count);
  std::uint64_t left() const { return in_block() + (size_ - at_); }
  static constexpr std::size_t block_bytes = std::size_t(1) << 14;

 protected:
  int_type underflow() override;
  std::streamsize xsgetn(char* out, std::streamsize count) override;

 private:
  std::uint64_t in_block() const { return std::uint64_t(egptr() - gptr()); }
  std::size_t take(char* out, std::size_t count);

  std::filesystem::path path_;
  std::uint64_t size_, at_;  ///< of the file; what is taken next
  std::vector<char> block_;
};

}  // namespace crest
