#include "tests/ui/harness.h"

#include <cmath>

#include "ui/keys.h"
#include "ui/transfer_function_editor.h"

namespace crest::test {
namespace {

constexpr float frame_seconds = 1.0F / 60;
constexpr int unused_keys = 400;  // beyond those that GLFW has

}  // namespace

Volume bump_volume(int n) {
  Volume volume;
  volume.name = "bump";
  volume.grid.dims = glm::ivec3(n);
  const double middle = (n - 1) / 2.0;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const double x = (i - middle) / middle, y = (j - middle) / middle, z = (k - middle) / middle;
        volume.values.floats().push_back(float(100 * (1 - (x * x + y * y + z * z) / 3)));
      }
  volume.values.floats()[0] = 0;
  volume.values.floats()[1] = 100;
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return volume;
}

std::vector<ControlPoint> points_of(std::initializer_list<std::pair<double, double>> places) {
  std::vector<ControlPoint> points;
  for (const auto& [value, opacity] : places) {
    ControlPoint point;
    point.value = value;
    point.opacity = opacity;
    points.push_back(point);
  }
  return points;
}

TransferFunction tf_of(std::initializer_list<std::pair<double, double>> places) {
  TransferFunction tf;
  tf.points = points_of(places);
  return tf;
}

Studio::Studio() {
  ImGui::CreateContext();
  apply_style(1);
  ImGuiIO& io = ImGui::GetIO();
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.DisplaySize = {1720, 1160};
  io.DeltaTime = frame_seconds;
  // As the GLFW backend numbers them
  for (int named = ImGuiKey_Tab; named <= ImGuiKey_KeyPadEnter; ++named)
    io.KeyMap[named] = unused_keys + named;
  for (const auto& [named, code] : {std::pair{ImGuiKey_Tab, key::tab},
                                    {ImGuiKey_LeftArrow, key::left},
                                    {ImGuiKey_RightArrow, key::right},
                                    {ImGuiKey_UpArrow, key::up},
                                    {ImGuiKey_DownArrow, key::down},
                                    {ImGuiKey_PageUp, key::page_up},
                                    {ImGuiKey_PageDown, key::page_down},
                                    {ImGuiKey_Home, key::home},
                                    {ImGuiKey_End, key::end},
                                    {ImGuiKey_Insert, key::insert},
                                    {ImGuiKey_Delete, key::del},
                                    {ImGuiKey_Backspace, key::backspace},
                                    {ImGuiKey_Space, int(' ')},
                                    {ImGuiKey_Enter, key::enter},
                                    {ImGuiKey_Escape, key::escape},
                                    {ImGuiKey_A, int('A')},
                                    {ImGuiKey_C, int('C')},
                                    {ImGuiKey_V, int('V')},
                                    {ImGuiKey_X, int('X')},
                                    {ImGuiKey_Y, int('Y')},
                                    {ImGuiKey_Z, int('Z')}})
    io.KeyMap[named] = code;
  io.MousePos = {-1000, -1000};
  tf().points = points_of({{0, 0}, {20, 0.2}, {50, 0.8}, {70, 0.1}, {100, 0.5}});
  inputs.volume = &volume;
  document.volume_source = "bump.nrrd";
  frames(3);
}

Studio::~Studio() { ImGui::DestroyContext(); }

StudioRequests Studio::frame() {
  inputs.resolved = volume.values.empty() ? tf() : resolve(tf(), volume.statistics.range, 1);
  peaks_ = find_peaks(inputs.resolved);
  inputs.peaks = peaks_;
  surfaces_ = shown_peaks(peaks_);
  inputs.surfaces = surfaces_;
  ImGui::NewFrame();
  requests = studio_frame(document, *state, inputs);
  ImGui::Render();
  return requests;
}

void Studio::frames(int count) {
  for (int i = 0; i < count; ++i) frame();
}

ImVec2 Studio::center_of(const std::string& item) const {
  const auto found = state->widgets.items.find(item);
  if (found == state->widgets.items.end()) {
    ADD_FAILURE() << "there is no item " << item;
    return {-1000, -1000};
  }
  const auto& [low, high] = found->second;
  return {(low.x + high.x) / 2, (low.y + high.y) / 2};
}

void Studio::move_to(ImVec2 place) {
  ImGui::GetIO().MousePos = place;
  frame();
}

void Studio::press(int button) {
  ImGui::GetIO().MouseDown[button] = true;
  frame();
}

void Studio::release(int button) {
  ImGui::GetIO().MouseDown[button] = false;
  frame();
}

void Studio::click(ImVec2 place, int button) {
  move_to(place);
  press(button);
  release(button);
  frames(30);  // longer than a double click
}

StudioRequests Studio::press_on(const std::string& item) {
  move_to(center_of(item));
  press();
  release();
  return requests;
}

void Studio::double_click(ImVec2 place) {
  move_to(place);
  press();
  release();
  press();
  release();
  frame();
}

void Studio::drag(ImVec2 from, ImVec2 to, int button) {
  move_to(from);
  press(button);
  move_to({(from.x + to.x) / 2, (from.y + to.y) / 2});
  move_to(to);
  release(button);
  frames(30);
}

void Studio::wheel(float notches) {
  ImGui::GetIO().MouseWheel = notches;
  frame();
  ImGui::GetIO().MouseWheel = 0;
  frame();
}

StudioRequests Studio::key(int code) {
  ImGui::GetIO().KeysDown[code] = true;
  const StudioRequests result = frame();
  ImGui::GetIO().KeysDown[code] = false;
  frame();
  return result;
}

StudioRequests Studio::ctrl(char letter, bool shift) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = true;
  io.KeyShift = shift;
  const StudioRequests result = key(letter);
  io.KeyCtrl = io.KeyShift = false;
  frame();
  return result;
}

void Studio::type(const std::string& field, std::string_view text) {
  click(field);
  ctrl('A');
  for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  key_of(ImGuiKey_Enter);
  frames(2);
}

ValueRange Studio::visible() const { return state->editor.visible.value_or(axis_range(tf(), inputs.volume)); }

double Studio::pixel_value() const {
  const auto& [low, high] = state->widgets.items.at("plot");
  return visible().width() / double(high.x - low.x);
}

ImVec2 Studio::place_of(double value, double opacity) const {
  const auto& [low, high] = state->widgets.items.at("plot");
  const double x = double(low.x) + (value - visible().min) / pixel_value();
  const double unit = state->editor.opacity_axis.unit_of(opacity);
  return {float(x), high.y - float(unit) * (high.y - low.y)};
}

ImVec2 Studio::place_of(std::size_t point) const {
  return place_of(tf().points[point].value, tf().points[point].opacity);
}

}  // namespace crest::test
