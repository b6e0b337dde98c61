#include "render/files/file_request.h"

#include "render/files/header_text.h"

namespace crest {

void FileRequest::require_memory(glm::u64vec3 dims, std::uint64_t bytes_per_point) const {
  crest::require_memory(name(), dims, bytes_per_point, reading.memory);
  if (expect) expect(dims.x * dims.y * dims.z * (sizeof(float) + bytes_per_point));
}

std::string extension_of(const std::filesystem::path& path) { return lower(path.extension().string()); }

}  // namespace crest
