#include "ui/raw_form.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>

#include "render/files/time_steps.h"
#include "ui/number_field.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr float label_width = 104, field_width = 84, picture_side = 280;
constexpr double largest_offset = 1e15;  ///< in bytes, exact as a double

void label(const char* text) {
  field_label(text);
  ImGui::SameLine(scaled(label_width));
}

void size_fields(WidgetState& widgets, glm::ivec3& size) {
  label("Size");
  constexpr const char* names[] = {"##raw x", "##raw y", "##raw z"};
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine();
    if (axis > 0) field_label("x");
    // Without a size to begin with, one is typed
    if (axis == 0 && ImGui::IsWindowAppearing() && size == glm::ivec3(0)) open_next_field(widgets, names[0]);
    integer_field(widgets, names[axis], size[axis], 0, std::numeric_limits<int>::max(), scaled(field_width));
  }
}

void type_fields(WidgetState& widgets, RawLayout& layout) {
  constexpr std::array<std::string_view, 10> types{"uint8", "int8",   "uint16", "int16",   "uint32",
                                                   "int32", "uint64", "int64",  "float32", "float64"};
  label("Type");
  if (int type = int(layout.type); choice(widgets, "##raw type", type, types, scaled(120)))
    layout.type = ScalarType(type);
  constexpr std::array<std::string_view, 2> orders{"little", "big"};
  label("Endianness");
  ImGui::BeginDisabled(size_of(layout.type) == 1);
  if (int order = layout.big_endian; choice(widgets, "##raw endian", order, orders, scaled(120)))
    layout.big_endian = order == 1;
  ImGui::EndDisabled();
  tip("Which byte of a number is first: most files are little");
}

void place_fields(WidgetState& widgets, RawLayout& layout) {
  label("Offset");
  const auto why_not = [&](const NumberEdit& edit) -> std::string {
    const double offset = edit(double(layout.offset));
    if (offset != double(std::int64_t(std::clamp(offset, -1.0, largest_offset))))
      return fmt::format("{} is not a whole number of bytes", exact_text(offset));
    return why_outside(offset, {.min = 0, .max = largest_offset});
  };
  if (const auto edit =
          number_entry(widgets, "##raw offset", fmt::format("{}", layout.offset), why_not, scaled(120)))
    layout.offset = std::uint64_t((*edit)(double(layout.offset)));
  ImGui::SameLine();
  ImGui::TextDisabled("bytes before the voxels");
  label("Spacing");
  constexpr const char* names[] = {"##raw spacing x", "##raw spacing y", "##raw spacing z"};
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine();
    if (axis > 0) field_label("x");
    number_field(widgets, names[axis], layout.spacing[axis], positive, scaled(field_width));
  }
}

std::string layout_text(const RawLayout& layout) {
  return fmt::format("{} x {} x {} of {}", layout.size.x, layout.size.y, layout.size.z, name_of(layout.type));
}

/// What is in the file stays; how it is spaced is the person's.
void take(OpeningState& opening, const RawLayout& layout) {
  const glm::dvec3 spacing = opening.layout.spacing;
  opening.layout = layout;
  opening.layout.spacing = spacing;
}

void fit_line(StudioState& state, const RawFit& fit) {
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + scaled(430));
  ImGui::PushStyleColor(ImGuiCol_Text, fit.fits ? palette().good : palette().warning);
  ImGui::TextUnformatted(fit.text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  for (std::size_t i = 0; i < fit.mends.size(); ++i) {
    const RawLayout& mend = fit.mends[i];
    const bool is_depth = mend.size != state.opening.layout.size;
    const std::string text = is_depth ? fmt::format("{} slices", mend.size.z)
                                      : fmt::format("skip the first {} bytes", mend.offset);
    if (i > 0) ImGui::SameLine();
    if (ImGui::Button(text.c_str())) take(state.opening, mend);
    note_item(state.widgets, fmt::format("raw mend/{}", i));
  }
}

void list_of_guesses(StudioState& state) {
  OpeningState& opening = state.opening;
  ImGui::TextDisabled(opening.guesses.empty() ? "No usual size fits the file's length" : "Sizes that fit");
  if (opening.guesses.empty()) return;
  ImGui::BeginChild("guesses", {scaled(430), 5.5F * ImGui::GetTextLineHeightWithSpacing()}, true);
  for (std::size_t i = 0; i < opening.guesses.size(); ++i) {
    const RawGuess& guess = opening.guesses[i];
    const RawLayout& now = opening.layout;
    const bool is_now =
        guess.layout.size == now.size && guess.layout.type == now.type && guess.layout.offset == now.offset;
    if (ImGui::Selectable(fmt::format("{}##{}", layout_text(guess.layout), i).c_str(), is_now,
                          ImGuiSelectableFlags_DontClosePopups))
      take(opening, guess.layout);
    note_item(state.widgets, fmt::format("raw guess/{}", i));
    ImGui::SameLine(scaled(230));
    ImGui::TextDisabled("%s", guess.why.c_str());
  }
  ImGui::EndChild();
}

void slice(const RawPicture& picture, glm::ivec3 size) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float side = scaled(picture_side);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + side, low.y + side}, palette().plot);
  if (picture.texture != 0) {
    const float scale = side / float(std::max({picture.size.x, picture.size.y, 1}));
    const ImVec2 shown{float(picture.size.x) * scale, float(picture.size.y) * scale};
    const ImVec2 at{low.x + (side - shown.x) / 2, low.y + (side - shown.y) / 2};
    list.AddImage(reinterpret_cast<ImTextureID>(picture.texture), at, {at.x + shown.x, at.y + shown.y});
  }
  ImGui::Dummy({side, side});
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + side);
  if (picture.error.empty() && picture.texture != 0)
    ImGui::TextDisabled("Slice %d of %d, values %s to %s", size.z / 2 + 1, size.z,
                        short_text(picture.range.min).c_str(), short_text(picture.range.max).c_str());
  else
    ImGui::TextDisabled("%s", picture.error.empty() ? "The middle slice" : picture.error.c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace

void begin_raw_form(OpeningState& opening, const Opening& asked) {
  opening.layout = layout_of(asked.choice.query);
  opening.guesses = likely_layouts(first_file(asked.choice.path), asked.file_bytes);
  const Query& query = asked.choice.query;
  if (query.contains("size") || opening.guesses.empty()) return;
  // What the query says is no guess
  RawLayout guess = opening.guesses.front().layout;
  if (query.contains("type")) guess.type = opening.layout.type;
  if (query.contains("endian")) guess.big_endian = opening.layout.big_endian;
  if (query.contains("offset")) guess.offset = opening.layout.offset;
  take(opening, guess);
}

bool raw_form(StudioState& state, const Opening& asked, StudioRequests& requests) {
  RawLayout& layout = state.opening.layout;
  ImGui::TextDisabled("Raw voxels do not say how they lie in the file.");
  ImGui::Spacing();
  ImGui::BeginGroup();
  size_fields(state.widgets, layout.size);
  type_fields(state.widgets, layout);
  place_fields(state.widgets, layout);
  ImGui::Spacing();
  const RawFit fit = fit_of(layout, asked.file_bytes);
  fit_line(state, fit);
  ImGui::Spacing();
  list_of_guesses(state);
  ImGui::EndGroup();
  ImGui::SameLine(0, scaled(16));
  ImGui::BeginGroup();
  slice(asked.picture, layout.size);
  ImGui::EndGroup();
  requests.preview_raw = layout;
  return fit.fits;
}

}  // namespace crest
