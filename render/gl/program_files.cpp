#include "render/gl/program_files.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <cstring>
#include <system_error>
#include <utility>
#include <vector>

#include "render/files/folder_cache.h"

namespace crest::gl {
namespace {

bool has_binaries() {
  GLint formats = 0;
  glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
  return formats > 0;
}

std::filesystem::path file_of(const std::filesystem::path& folder, const std::string& source) {
  std::string key = source;
  for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION})
    key += fmt::format("\n{}", reinterpret_cast<const char*>(glGetString(name)));
  return folder / fmt::format("{:016x}.program", XXH64(key.data(), key.size(), 0));
}

}  // namespace

// The driver's format, then its bytes.
ProgramHandle read_program(const std::filesystem::path& folder, const std::string& source) {
  if (folder.empty() || !has_binaries()) return {};
  const auto content = read_cached(file_of(folder, source), program_files_bytes);
  GLenum format = 0;
  if (!content || content->size() < sizeof format) return {};
  std::memcpy(&format, content->data(), sizeof format);
  ProgramHandle program(glCreateProgram());
  glProgramBinary(program.id(), format, content->data() + sizeof format,
                  GLsizei(content->size() - sizeof format));
  GLint linked = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  return linked ? std::move(program) : ProgramHandle();
}

std::future<void> write_program(const std::filesystem::path& folder, const std::string& source,
                                GLuint program) {
  if (folder.empty() || !has_binaries()) return {};
  GLint length = 0;
  glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
  if (length <= 0) return {};
  GLenum format = 0;
  std::string content(sizeof format + std::size_t(length), '\0');
  glGetProgramBinary(program, length, &length, &format, content.data() + sizeof format);
  std::memcpy(content.data(), &format, sizeof format);
  content.resize(sizeof format + std::size_t(length));
  try {
    return std::async(std::launch::async, [file = file_of(folder, source), content = std::move(content)] {
      write_cached(file, content, program_files_bytes);
    });
  } catch (const std::system_error&) {  // no thread
    return {};
  }
}

}  // namespace crest::gl
