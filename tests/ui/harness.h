#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <string>
#include <string_view>

#include "presets/peaks.h"
#include "ui/studio.h"
#include "ui/studio_state.h"
#include "ui/style.h"

namespace crest::test {

/// A volume of n^3 points whose values are a bump from 0 to 100, evenly spread over the range.
Volume bump_volume(int n = 12);

/// Points from (value, opacity) pairs, white.
std::vector<ControlPoint> points_of(std::initializer_list<std::pair<double, double>> places);

TransferFunction tf_of(std::initializer_list<std::pair<double, double>> places);

/// The studio without a window: Dear ImGui is given a mouse and keys, and each frame is drawn into nothing.
/// Peaks are found between frames, as the program does.
class Studio : public ::testing::Test {
 protected:
  Studio();
  ~Studio() override;

  StudioRequests frame();
  void frames(int count);

  ImVec2 center_of(const std::string& item) const;
  bool has(const std::string& item) const { return state->widgets.items.contains(item); }
  void move_to(ImVec2 place);
  void press(int button = 0);
  void release(int button = 0);
  void click(ImVec2 place, int button = 0);
  void click(const std::string& item, int button = 0) { click(center_of(item), button); }
  StudioRequests press_on(const std::string& item);  ///< what a click asks for, in its last frame
  void double_click(ImVec2 place);
  void drag(ImVec2 from, ImVec2 to, int button = 0);
  void wheel(float notches);
  StudioRequests key(int code);  ///< down and up
  StudioRequests key_of(ImGuiKey named) { return key(ImGui::GetIO().KeyMap[named]); }
  StudioRequests ctrl(char letter, bool shift = false);
  /// Types into a number field, in place of what it shows, and presses Enter.
  void type(const std::string& field, std::string_view text);

  /// Where a point of the transfer function is drawn.
  ImVec2 place_of(std::size_t point) const;
  ImVec2 place_of(double value, double opacity) const;
  ValueRange visible() const;
  double pixel_value() const;  ///< how much value one pixel of the plot is
  TransferFunction& tf() { return document.preset.transfer_function; }
  const TransferFunction& tf() const { return document.preset.transfer_function; }

  Document document;
  Volume volume = bump_volume();
  StudioInputs inputs;
  StudioStatePtr state = make_studio_state();
  StudioRequests requests;  ///< of the last frame

 private:
  std::vector<Peak> peaks_, surfaces_;
};

}  // namespace crest::test
