#include "render/files/file_modules.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include "presets/error.h"

namespace crest {
namespace {

/// Where the modules and the reader lie, from the place of the program or of the reader: as installed, else
/// as built. (The run path does not do, since AddressSanitizer's dlopen has another one.)
std::filesystem::path render_folder() {
  std::error_code fault;
  const auto root = std::filesystem::read_symlink("/proc/self/exe", fault).parent_path().parent_path();
  for (const auto& installed : {root / "lib" / "crest", root / "crest"})
    if (std::filesystem::exists(installed / "crest-reader", fault)) return installed;
  return root / "render";
}

/// Once loaded it stays.
template <class Module>
const Module& load(const char* file, const char* entry) {
  void* library = dlopen((render_folder() / file).c_str(), RTLD_NOW | RTLD_LOCAL);
  void* symbol = library ? dlsym(library, entry) : nullptr;
  if (!symbol)
    throw Error(fmt::format("the library that reads and writes files cannot be loaded: {}", dlerror()));
  return *reinterpret_cast<const Module* (*)()>(symbol)();
}

}  // namespace

std::filesystem::path reader_program() { return render_folder() / "crest-reader"; }

const VolumeModule& dicom_module() {
  static const auto& module = load<VolumeModule>("libcrest_dicom_files.so", "crest_dicom_module");
  return module;
}

const VolumeModule& page_module() {
  static const auto& module = load<VolumeModule>("libcrest_page_files.so", "crest_page_module");
  return module;
}

const ImageModule& image_module() {
  static const ImageModule& module = load<ImageModule>("libcrest_image_files.so", "crest_image_module");
  return module;
}

}  // namespace crest
