#include "app/load_with_progress.h"

#include <fmt/core.h>

#include <filesystem>

#include "app/progress.h"
#include "render/files/load.h"

namespace crest {

Volume load_with_progress(const std::string& source) {
  ProgressBar bar;
  const std::string path = source.substr(0, source.find('?'));
  const std::string doing = fmt::format("reading {}", std::filesystem::path(path).filename().string());
  Reading reading;
  reading.progress = [&](double share) { bar.show(share, doing); };
  return load_volume(source, reading);
}

}  // namespace crest
