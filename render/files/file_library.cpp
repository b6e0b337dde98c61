#include "render/files/file_library.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include "presets/error.h"

namespace crest {
namespace {

/// It lies beside the program's folder: the run path does not do, since AddressSanitizer's dlopen has another
/// one. Once loaded it stays.
const FileLibrary& load() {
  std::error_code fault;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", fault);
  const auto file = program.parent_path().parent_path() / "render" / "libcrest_files.so";
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* symbol = library ? dlsym(library, "crest_file_library") : nullptr;
  if (!symbol)
    throw Error(fmt::format("the library that reads and writes files cannot be loaded: {}", dlerror()));
  return *reinterpret_cast<const FileLibrary* (*)()>(symbol)();
}

}  // namespace

const FileLibrary& file_library() {
  static const FileLibrary& library = load();
  return library;
}

}  // namespace crest
