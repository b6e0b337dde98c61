#include "render/readers/with_gdcm.h"

#include <fmt/core.h>

#include <new>

#include "presets/error.h"
#include "render/files/header_text.h"

namespace crest {

void with_gdcm(const std::string& name, const std::function<bool()>& work) {
  std::string why;
  try {
    if (work()) return;
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: reading it takes more memory than there is", name));
  } catch (const std::exception& e) {
    why = ": " + one_line(e.what());
  }
  throw Error(fmt::format("{}: the DICOM file is damaged, or coded in a way that is not read{}", name, why));
}

}  // namespace crest
