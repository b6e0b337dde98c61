#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace crest {

/// A zlib or gzip stream (or several gzip members) that is read from within a file.
class Inflater {
 public:
  Inflater(const std::filesystem::path& path, std::uint64_t offset);
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Fills `out` as far as the stream goes, and returns how far; what it could not tells `fault`.
  std::size_t read(std::span<char> out);
  const std::string& fault() const { return fault_; }

 private:
  bool refill();
  void step();

  std::ifstream file_;
  std::vector<char> in_;
  z_stream stream_{};
  bool ended_ = false;
  std::string fault_;
};

}  // namespace crest
