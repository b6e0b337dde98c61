#include "render/gl/program_cache.h"

#include "presets/error.h"
#include "render/gl/program.h"

namespace crest::gl {

GLuint ProgramCache::program(std::string_view vertex, std::string_view fragment,
                             const std::vector<std::string>& defines) {
  Variant& variant = variants_[{std::string(fragment), defines}];
  if (!variant.current) {
    try {
      variant.program = build_program(vertex, fragment, defines, folder_);
    } catch (const Error& error) {
      if (!variant.program) throw;
      error_ = error.what();
    }
    variant.current = true;
  }
  return variant.program.id();
}

void ProgramCache::reload() {
  error_.clear();
  for (auto& [name, variant] : variants_) variant.current = false;
}

}  // namespace crest::gl
