#include "render/gl/program_cache.h"

#include <algorithm>
#include <chrono>

#include "presets/error.h"
#include "render/gl/program.h"
#include "render/gl/program_files.h"

namespace crest::gl {

GLuint ProgramCache::program(std::string_view vertex, std::string_view fragment,
                             const std::vector<std::string>& defines) {
  const std::pair name{std::string(fragment), defines};
  auto found = variants_.find(name);
  if (found == variants_.end()) {  // one that does not compile takes no other one's place
    found = variants_.emplace(name, Variant{read_or_build(vertex, fragment, defines), true, ++uses_}).first;
    if (variants_.size() > most_programs) drop_oldest();
  }
  Variant& variant = found->second;
  variant.last_use = ++uses_;
  if (!variant.current) try {
      variant.current = true;
      variant.program = read_or_build(vertex, fragment, defines);
    } catch (const Error& error) {
      error_ = error.what();
    }
  return variant.program.id();
}

void ProgramCache::drop_oldest() {
  variants_.erase(std::ranges::min_element(variants_, {}, [](const auto& v) { return v.second.last_use; }));
}

ProgramHandle ProgramCache::read_or_build(std::string_view vertex, std::string_view fragment,
                                          const std::vector<std::string>& defines) {
  const ProgramSource source = load_program(vertex, fragment, defines, folder_);
  const std::string text = source.vertex.text + source.fragment.text;
  if (ProgramHandle program = read_program(binary_folder_, text)) return program;
  ProgramHandle program = build_program(source);
  ++compiled_;
  std::erase_if(writing_, [](const auto& one) {
    return !one.valid() || one.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  writing_.push_back(write_program(binary_folder_, text, program.id()));
  return program;
}

void ProgramCache::reload() {
  error_.clear();
  for (auto& [name, variant] : variants_) variant.current = false;
}

}  // namespace crest::gl
