#include "ui/start_page.h"

#include "presets/preset_file.h"
#include "tests/ui/harness.h"
#include "ui/examples.h"

namespace crest::test {
namespace {

class StartPage : public Studio {
 protected:
  StartPage() {
    inputs.volume = nullptr;
    document.volume_source.clear();
    inputs.recent = {"/scans/head.nrrd?component=0", "builtin:gyroid", "/p/mine.json"};
    frames(3);
  }
};

TEST_F(StartPage, StandsInPlaceOfTheViewsWhileNoVolumeIsOpen) {
  EXPECT_FALSE(has("view0"));
  EXPECT_TRUE(requests.shows_start_page);
  EXPECT_EQ(requests.view_pixels[0], glm::ivec2(0));
  inputs.loading = "/scans/head.nrrd";
  frames(2);
  EXPECT_TRUE(has("view0")) << "while the first one is read";
  EXPECT_FALSE(has("example/0"));
  inputs.loading.clear();
  inputs.volume = &volume;
  frames(2);
  EXPECT_TRUE(has("view0"));
  EXPECT_FALSE(requests.shows_start_page);
}

TEST_F(StartPage, AnExampleIsOneClick) {
  for (std::size_t i = 0; i < examples().size(); ++i) {
    const StudioRequests asked = press_on("example/" + std::to_string(i));
    EXPECT_EQ(asked.open_volume, examples()[i].volume);
    EXPECT_EQ(asked.open_preset, examples()[i].preset);
    EXPECT_NO_THROW(load_preset(examples()[i].preset));
    frames(30);
  }
}

TEST_F(StartPage, RecentVolumesAndPresetsAreOneClick) {
  EXPECT_EQ(press_on("recent/0").open_volume, "/scans/head.nrrd?component=0");
  frames(30);
  EXPECT_EQ(press_on("recent/1").open_volume, "builtin:gyroid");
  frames(30);
  const StudioRequests preset = press_on("recent/2");
  EXPECT_EQ(preset.open_preset, "/p/mine.json");
  EXPECT_FALSE(preset.open_volume);
}

TEST_F(StartPage, OpensTheFileDialogs) {
  click("start/Open volume...");
  EXPECT_TRUE(has("file name"));
  EXPECT_EQ(state->file_dialog.purpose, FilePurpose::open_volume);
  click("cancel file");
  click("start/Open preset...");
  EXPECT_EQ(state->file_dialog.purpose, FilePurpose::open_preset);
}

TEST_F(StartPage, CardsKeepWithinANarrowWindow) {
  ImGui::GetIO().DisplaySize = {1024, 700};
  frames(3);
  const float right = state->widgets.items.at("example/1").second.x;
  EXPECT_LT(right, 1024 * 0.65F);
  EXPECT_GT(center_of("example/2").y, center_of("example/0").y) << "the third in a second row";
}

TEST_F(StartPage, AVolumeIsClosedFromTheMenu) {
  inputs.volume = &volume;
  document.volume_source = "bump.nrrd";
  frames(2);
  click("menu/Volume");
  EXPECT_TRUE(press_on("Close volume").close_volume);
}

}  // namespace
}  // namespace crest::test
