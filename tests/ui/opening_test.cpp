#include "tests/ui/harness.h"

namespace crest::test {
namespace {

class Opening_ : public Studio {
 protected:
  void ask(OpenChoice choice, std::uint64_t file_bytes = 0) {
    opening.choice = std::move(choice);
    opening.file_bytes = file_bytes;
    inputs.opening = &opening;
    frames(3);
  }
  Opening opening;
};

class ChoiceOfOptions : public Opening_ {};
/// A volume of 64 MB, and so many bytes for it.
class PartForm : public Opening_ {
 protected:
  void ask_part(std::uint64_t memory, Query query = {}) {
    OpenChoice choice{ChoiceKind::part, "/data/big.nrrd", std::move(query), 0, {}};
    choice.need = {part_from_query("big", choice.query, {400, 400, 400}), 1};
    choice.memory = memory;
    ask(std::move(choice));
  }
};
class RawForm : public Opening_ {
 protected:
  void ask_raw(const char* path, std::uint64_t bytes, Query query = {}) {
    ask({ChoiceKind::raw_layout, path, std::move(query), 0, {}}, bytes);
  }
  RawLayout layout() const { return state->opening.layout; }
};

TEST_F(ChoiceOfOptions, ADoubleClickOpensTheSeries) {
  ask({ChoiceKind::series, "/scans", {}, 2, {{"1.2", "T1, 30 images"}, {"1.3", "T2, 20 images"}}});
  ASSERT_TRUE(has("option/1"));
  std::optional<std::string> opened;
  move_to(center_of("option/1"));
  for (const bool down : {true, false, true, false}) {
    down ? press() : release();
    if (requests.open_volume) opened = requests.open_volume;
  }
  EXPECT_EQ(opened, "/scans?series=1.3");
}

TEST_F(ChoiceOfOptions, ArrowsAndEnterChoose) {
  ask({ChoiceKind::component, "a.nrrd", {{"frame", "2"}}, 3, {}});
  key_of(ImGuiKey_DownArrow);
  key_of(ImGuiKey_DownArrow);
  key_of(ImGuiKey_DownArrow);  // there is no fourth
  EXPECT_EQ(key_of(ImGuiKey_Enter).open_volume, "a.nrrd?component=2&frame=2");
}

TEST_F(ChoiceOfOptions, EnterPressesTheButtonThatHasTheFocus) {
  ask({ChoiceKind::component, "a.nrrd", {}, 3, {}});
  key_of(ImGuiKey_Tab);
  frames(2);
  const StudioRequests asked = key_of(ImGuiKey_Enter);
  EXPECT_TRUE(asked.cancel_opening);
  EXPECT_FALSE(asked.open_volume);
}

TEST_F(ChoiceOfOptions, ArrowsGoOnFromAnOptionThatWasClicked) {
  ask({ChoiceKind::component, "a.nrrd", {}, 3, {}});
  click("option/1");
  key_of(ImGuiKey_UpArrow);
  EXPECT_EQ(key_of(ImGuiKey_Enter).open_volume, "a.nrrd?component=0");
}

TEST_F(ChoiceOfOptions, OfManyFramesTheNumberIsTyped) {
  ask({ChoiceKind::frame, "film.nrrd", {}, 500, {}});
  EXPECT_FALSE(has("option/0"));
  type("##option", "321");
  key_of(ImGuiKey_RightArrow);
  EXPECT_EQ(press_on("open chosen").open_volume, "film.nrrd?frame=322");
}

TEST_F(ChoiceOfOptions, EscapeOpensNothing) {
  ask({ChoiceKind::component, "a.nrrd", {}, 3, {}});
  const StudioRequests asked = key_of(ImGuiKey_Escape);
  EXPECT_TRUE(asked.cancel_opening);
  EXPECT_FALSE(asked.open_volume);
  inputs.opening = nullptr;
  frames(2);
  EXPECT_FALSE(has("open chosen"));
}

TEST_F(ChoiceOfOptions, TheQuestionAboutUnsavedChangesComesFirst) {
  ask({ChoiceKind::component, "a.nrrd", {}, 3, {}});
  inputs.unsaved_changes = inputs.close_requested = true;
  frame();
  inputs.close_requested = false;
  for (int i = 0; i < 6; ++i) {
    frame();
    EXPECT_FALSE(has("open chosen"));
  }
  click("Stay");
  EXPECT_TRUE(has("open chosen"));
  EXPECT_EQ(key_of(ImGuiKey_Enter).open_volume, "a.nrrd?component=0");
}

TEST_F(ChoiceOfOptions, AWindowThatIsOpenStaysOpen) {
  click("menu/View");
  click("Settings...");
  ask({ChoiceKind::component, "a.nrrd", {}, 3, {}});
  EXPECT_TRUE(has("theme/light"));
  EXPECT_FALSE(has("open chosen"));
  click("close settings");
  EXPECT_FALSE(has("theme/light"));
  EXPECT_TRUE(has("open chosen"));
}

TEST_F(PartForm, TheStrideThatFitsIsOneKeyAway) {
  ask_part(3'000'000);
  EXPECT_TRUE(has("part fits"));
  EXPECT_EQ(key_of(ImGuiKey_Enter).open_volume, "/data/big.nrrd?stride=3");
}

TEST_F(PartForm, WhatDoesNotFitIsNotOpened) {
  ask_part(3'000'000);
  type("##stride", "2");
  EXPECT_TRUE(has("part refused"));
  EXPECT_FALSE(press_on("open chosen").open_volume);
  type("##stride", "4");
  EXPECT_EQ(press_on("open chosen").open_volume, "/data/big.nrrd?stride=4");
}

TEST_F(PartForm, ABoxInTheMiddleIsTwoClicksAway) {
  ask_part(10'000'000, {{"frame", "2"}});
  click("part box");
  EXPECT_EQ(press_on("open chosen").open_volume, "/data/big.nrrd?crop=100:300,100:300,100:300&frame=2");
}

TEST_F(PartForm, TypedNumbersMakeTheBox) {
  ask_part(10'000'000);
  type("##box x0", "10");
  type("##box x1", "5");
  EXPECT_TRUE(has("part refused"));
  EXPECT_FALSE(press_on("open chosen").open_volume);
  type("##box x1", "50");
  EXPECT_EQ(press_on("open chosen").open_volume, "/data/big.nrrd?crop=10:50,100:300,100:300");
}

TEST_F(PartForm, WhatNoStrideMakesFitIsStillAsked) {
  ask_part(5);
  EXPECT_TRUE(has("part refused"));
  EXPECT_FALSE(key_of(ImGuiKey_Enter).open_volume);
  EXPECT_TRUE(key_of(ImGuiKey_Escape).cancel_opening);
}

TEST_F(RawForm, WhatTheNameSaysIsOneKeyAway) {
  ask_raw("/data/foot_64x32x16.raw", 2 * 64 * 32 * 16);
  EXPECT_EQ(layout().size, glm::ivec3(64, 32, 16));
  ASSERT_TRUE(requests.preview_raw);
  EXPECT_EQ(requests.preview_raw->type, ScalarType::uint16);
  EXPECT_EQ(key_of(ImGuiKey_Enter).open_volume, "/data/foot_64x32x16.raw?size=64x32x16&type=uint16");
}

TEST_F(RawForm, WhatTheQuerySaysIsNotGuessed) {
  ask_raw("/data/foot_64x32x16.raw", 2 * 64 * 32 * 16 + 10,
          {{"type", "int16"}, {"endian", "big"}, {"offset", "10"}});
  EXPECT_EQ(layout().type, ScalarType::int16);
  EXPECT_TRUE(layout().big_endian);
  EXPECT_EQ(layout().offset, 10U);
}

TEST_F(RawForm, TypedNumbersMakeTheQuery) {
  ask_raw("v.raw", 1000);
  type("##raw x", "7");
  type("##raw y", "6");
  type("##raw z", "5");
  EXPECT_FALSE(press_on("open chosen").open_volume);  // 210 bytes
  type("##raw offset", "790");
  type("##raw spacing z", "2.5");
  EXPECT_EQ(requests.preview_raw->offset, 790U);
  EXPECT_EQ(press_on("open chosen").open_volume, "v.raw?offset=790&size=7x6x5&spacing=1,1,2.5&type=uint8");
}

TEST_F(RawForm, WhatDoesNotFitIsMendedByAClick) {
  ask_raw("v.raw", 1280, {{"size", "8x8x8"}, {"type", "uint16"}});
  click("raw mend/0");
  EXPECT_EQ(layout().size, glm::ivec3(8, 8, 10));
  EXPECT_FALSE(has("raw mend/0"));
}

TEST_F(RawForm, ASizeThatFitsIsTakenWithAClick) {
  ask_raw("v.raw", 64 * 64 * 64);
  ASSERT_TRUE(has("raw guess/1"));
  click("raw guess/1");
  EXPECT_EQ(layout().size, state->opening.guesses[1].layout.size);
  click("raw guess/0");
  EXPECT_EQ(layout().size, glm::ivec3(64));
}

TEST_F(RawForm, EscapeClosesAListAlone) {
  ask_raw("v.raw", 27);
  click("##raw type");
  ASSERT_TRUE(has("##raw type/uint16"));
  EXPECT_FALSE(key_of(ImGuiKey_Escape).cancel_opening);
  frames(2);
  EXPECT_FALSE(has("##raw type/uint16"));
  EXPECT_TRUE(key_of(ImGuiKey_Escape).cancel_opening);
}

TEST_F(RawForm, EscapeInAFieldIsAboutTheField) {
  ask_raw("v.raw", 27);
  click("##raw x");
  EXPECT_FALSE(key_of(ImGuiKey_Escape).cancel_opening);
  EXPECT_TRUE(key_of(ImGuiKey_Escape).cancel_opening);
}

}  // namespace
}  // namespace crest::test
