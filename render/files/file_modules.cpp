#include "render/files/file_modules.h"

#include <dlfcn.h>
#include <fmt/core.h>
#include <sys/auxv.h>

#include "presets/error.h"

namespace crest {
namespace fs = std::filesystem;
namespace {

/// The program's own, also where no /proc is mounted.
fs::path own_file() {
  std::error_code fault;
  fs::path file = fs::read_symlink("/proc/self/exe", fault);
  if (fault) file = fs::canonical(reinterpret_cast<const char*>(::getauxval(AT_EXECFN)), fault);
  if (fault) throw Error("where Crest lies cannot be found out: /proc is not mounted");
  return file;
}

/// Where the modules and the reader lie, from the place of the program or of the reader: as installed, else
/// as built. (The run path does not do, since AddressSanitizer's dlopen has another one.)
fs::path render_folder() {
  std::error_code fault;
  const fs::path root = own_file().parent_path().parent_path();
  for (const fs::path& folder : {root / "lib" / "crest", root / "crest", root / "render"})
    if (fs::exists(folder / "crest-reader", fault)) return folder;
  return root / "lib" / "crest";
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

fs::path reader_program() { return render_folder() / "crest-reader"; }

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
