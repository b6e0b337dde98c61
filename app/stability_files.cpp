#include "app/stability_files.h"

#include "app/report/page.h"
#include "presets/atomic_file.h"
#include "presets/json.h"

namespace crest {

using stability::Row;

Json stability_json(const std::vector<Row>& rows, const std::string& renderer) {
  Json json = {{"renderer", renderer}, {"rows", Json::array()}};
  for (const Row& row : rows) {
    Json item = {{"group", row.group},
                 {"case", row.claim.name},
                 {"quantity", row.claim.quantity},
                 {"truth", name_of(row.claim.truth)},
                 {"bound", row.claim.bound},
                 {"measured", row.measured},
                 {"verdict", name_of(row.verdict)},
                 {"worst_at", row.at},
                 {"pixels_not_finite", row.not_finite},
                 {"pixels_covered", row.covered},
                 {"pixels_grazing", row.left_out}};
    if (row.claim.limit)
      item["limit"] = {{"bound", row.claim.limit->bound},
                       {"why", row.claim.limit->why},
                       {"warnings", row.claim.limit->warnings}};
    json["rows"].push_back(std::move(item));
  }
  return json;
}

void write_stability(const std::vector<Row>& rows, const Json& table, const std::filesystem::path& folder) {
  Json page = table;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!rows[i].picture.pixels.empty())
      page["rows"][i]["picture"] = data_address(rows[i].picture, glm::vec3(0));
  write_file_atomically(folder / "stability.json", table.dump(2) + "\n");
  write_page(folder / "stability.html", "Stiff and extreme cases", web_file("stability.html"),
             web_file("stability.js"), page);
}

}  // namespace crest
