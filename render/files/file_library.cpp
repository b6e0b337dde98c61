#include "render/files/file_library.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include "presets/error.h"

namespace crest {
namespace {

/// It lies where the program's run path says; once loaded it stays.
const FileLibrary& load() {
  void* library = dlopen("libcrest_files.so", RTLD_NOW | RTLD_LOCAL);
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
