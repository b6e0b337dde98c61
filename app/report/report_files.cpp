#include "app/report/report_files.h"

#include <fmt/core.h>

#include "app/output_folder.h"
#include "app/report/page.h"
#include "app/report/report_json.h"
#include "app/report/report_pictures.h"
#include "presets/atomic_file.h"
#include "presets/json.h"

namespace crest {

Json write_report(const Report& report, const std::filesystem::path& folder) {
  make_folder(folder / "images");
  const auto pictures = write_pictures(report, folder);
  const Json json = report_json(report);
  write_file_atomically(folder / "report.json", print_json(json));
  write_file_atomically(folder / "report.csv", report_csv(report));
  Json page = json;
  for (const std::string& name : pictures) page["pictures"][name] = data_address(folder / name);
  write_page(folder / "report.html", fmt::format("Error against run time: {}", report.scene.volume->name),
             web_file("report.html"), web_file("report.js"), page);
  return json;
}

}  // namespace crest
