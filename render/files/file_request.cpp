#include "render/files/file_request.h"

#include "render/files/header_text.h"

namespace crest {

void FileRequest::require_memory(const MemoryNeed& need) const {
  crest::require_memory(name(), need, reading.memory);
  if (expect) expect(*bytes_of(need));
}

FileRequest FileRequest::reading_also(std::uint64_t bytes) const {
  FileRequest more = *this;
  if (!expect) return more;
  more.expect = [before = expect, bytes](std::uint64_t others) { before(bytes + others); };
  more.expect(0);
  return more;
}

std::string extension_of(const std::filesystem::path& path) { return lower(path.extension().string()); }

}  // namespace crest
