// presets/preset.schema.json against what is read and written, and the manual's table against it.
#include "presets/preset_schema.h"

#include <gtest/gtest.h>

#include <random>

#include "json_schema.h"
#include "presets/preset_file.h"
#include "tests/app/program.h"
#include "tests/json.h"
#include "tests/paths.h"
#include "tests/presets/random_preset.h"

namespace crest::test {
namespace {

nlohmann::json schema() { return parse_json(content_of(source_folder() / "presets" / "preset.schema.json")); }

TEST(PresetSchema, IsMadeFromTheFields) {
  EXPECT_EQ(content_of(source_folder() / "presets" / "preset.schema.json"), preset_schema())
      << "crest list schema > presets/preset.schema.json";
}

TEST(PresetSchema, HoldsForTheLibraryAndForRandomPresets) {
  const nlohmann::json rules = schema();
  for (const LibraryPreset& entry : library())
    EXPECT_EQ(schema_faults(parse_json(std::string(entry.text)), rules), std::vector<std::string>{})
        << entry.name;
  std::mt19937 random(41);
  for (int trial = 0; trial < 200; ++trial)
    EXPECT_EQ(schema_faults(parse_json(write_preset(random_preset(random))), rules),
              std::vector<std::string>{});
}

// What the schema refuses Crest refuses, too.
TEST(PresetSchema, RefusesWhatIsWrong) {
  const nlohmann::json rules = schema();
  const auto preset = [](const std::string& more) {
    return R"({"transfer_function": {"points": [{"value": 0, "opacity": 0.5}]})" + more + "}";
  };
  EXPECT_TRUE(schema_faults(parse_json(preset("")), rules).empty());
  for (const char* more : {R"(, "version": 2)", R"(, "format": "x")", R"(, "rendering": {"step": 0})",
                           R"(, "rendering": {"mode": "NONE"})", R"(, "camera": {"fov_y_degrees": 180})",
                           R"(, "rendering": {"background": [0, 0]})", R"(, "name": 3)"}) {
    EXPECT_FALSE(schema_faults(parse_json(preset(more)), rules).empty()) << more;
    EXPECT_THROW(parse_preset(preset(more), "x"), std::exception) << more;
  }
  EXPECT_FALSE(schema_faults(parse_json(R"({"transfer_function": {}})"), rules).empty());
}

/// Each field's name, below `object`.
void names_in(const nlohmann::json& object, std::vector<std::string>& names) {
  if (!object.contains("properties")) return;
  for (const auto& [name, property] : object["properties"].items()) {
    names.push_back(name);
    names_in(property, names);
    if (property.contains("items")) names_in(property["items"], names);
  }
}

TEST(PresetSchema, EachFieldStandsInTheManual) {
  const std::string table = content_of(source_folder() / "docs/manual/preset.md");
  std::vector<std::string> names;
  names_in(schema(), names);
  EXPECT_GT(names.size(), 50u);
  for (const std::string& name : names) EXPECT_NE(table.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace crest::test
