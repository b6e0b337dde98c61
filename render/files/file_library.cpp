#include "render/files/file_library.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include "presets/error.h"

namespace crest {
namespace {

/// Where it lies, from the program's place: as installed, else as built. The run path does not do, since
/// AddressSanitizer's dlopen has another one.
std::filesystem::path library_file() {
  std::error_code fault;
  const auto root = std::filesystem::read_symlink("/proc/self/exe", fault).parent_path().parent_path();
  const auto installed = root / "lib" / "crest" / "libcrest_files.so";
  return std::filesystem::exists(installed, fault) ? installed : root / "render" / "libcrest_files.so";
}

/// Once loaded it stays.
const FileLibrary& load() {
  const auto file = library_file();
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
