#include "presets/preset_changes.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/fields.h"
#include "presets/names.h"
#include "presets/point_changes.h"

namespace crest {
namespace {

std::string text_of(double value) { return fmt::format("{}", value == 0 ? 0.0 : value); }
std::string text_of(int value) { return fmt::format("{}", value); }
std::string text_of(bool value) { return value ? "on" : "off"; }
std::string text_of(const glm::dvec3& v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }
template <NamedEnum T>
std::string text_of(T value) {
  return std::string(name_of(value));
}

/// The file's name of a field, as words.
std::string words_of(std::string name) {
  constexpr std::pair<std::string_view, std::string_view> others[] = {
      {"root_filter", "filter of surfaces"},
      {"bc_b", "B of the filter"},
      {"bc_c", "C of the filter"},
      {"s_k", "s_k"},
      {"illumination", "blend mode"},
      {"unit", "unit of the distance"},
      {"early_termination", "early end of rays"}};
  for (const auto& [field, words] : others)
    if (name == field) return std::string(words);
  std::ranges::replace(name, '_', ' ');
  return name;
}

struct Setting {
  std::string name;
  std::string text;        ///< differs where the values do
  bool is_switch = false;  ///< "on" or "off"
  bool is_spoken = true;   ///< the text is worth reading
};

template <class T>
Setting setting_of(const char* name, const T& value) {
  constexpr bool is_vector = std::same_as<T, glm::dvec3>;
  return {words_of(name), text_of(value), std::same_as<T, bool>, !is_vector};
}
Setting setting_of(const char* name, const std::optional<ClipBox>& box) {
  return {words_of(name), box ? text_of(box->min) + text_of(box->max) : "none", false, false};
}
Setting setting_of(const char* name, const std::optional<Filter>& filter) {
  return {words_of(name), filter ? text_of(*filter) : "that of the samples"};
}

std::string camera_change(const std::optional<Camera>& before, const std::optional<Camera>& after) {
  if (!after) return "Show the whole volume";
  const Projection from = before ? before->projection : Projection::perspective;
  if (after->projection == from) return "Move the camera";
  return fmt::format("Switch to {} projection", name_of(after->projection));
}

/// All fields but points, as text; those of a struct in it with the rest.
template <Fielded T>
void list_settings(const T& values, std::vector<Setting>& list) {
  visit_fields(values, [&](const char* name, const auto& field, const FieldRule&) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (std::same_as<Field, std::vector<ControlPoint>>)
      return;
    else if constexpr (Fielded<Field>)
      list_settings(field, list);
    else
      list.push_back(setting_of(name, field));
  });
}

std::string sentence_of(const Setting& before, const Setting& after) {
  if (after.is_switch) return fmt::format("Switch {} {}", after.name, after.text);
  if (after.is_spoken) return fmt::format("Change {} from {} to {}", after.name, before.text, after.text);
  if (before.text == "none") return fmt::format("Set the {}", after.name);
  if (after.text == "none") return fmt::format("Remove the {}", after.name);
  return fmt::format("Change the {}", after.name);
}

template <Fielded T>
void add_settings(std::vector<std::string>& sentences, const T& before, const T& after) {
  std::vector<Setting> from, to;
  list_settings(before, from);
  list_settings(after, to);
  for (std::size_t i = 0; i < to.size(); ++i)
    if (from[i].text != to[i].text) sentences.push_back(sentence_of(from[i], to[i]));
}

void add_texts(std::vector<std::string>& sentences, const Preset& before, const Preset& after) {
  if (before.name != after.name)
    sentences.push_back(after.name.empty() ? "Remove the name" : fmt::format("Name it {}", after.name));
  if (before.notes != after.notes) sentences.emplace_back("Change the notes");
  if (before.tags != after.tags) sentences.emplace_back("Change the tags");
}

void add_transfer_function(std::vector<std::string>& sentences, TransferFunction before,
                           const TransferFunction& after) {
  if (before.domain != after.domain) {
    // Its values were all rewritten, and so was the plateau's width
    sentences.push_back(fmt::format("Convert to {} values", name_of(after.domain)));
    if (before.points.size() == after.points.size()) return;
    before.domain = after.domain;
  } else {
    for (std::string& sentence : point_changes(before, after)) sentences.push_back(std::move(sentence));
  }
  add_settings(sentences, before, after);
}

}  // namespace

std::vector<std::string> preset_changes(const Preset& before, const Preset& after) {
  std::vector<std::string> sentences;
  add_texts(sentences, before, after);
  add_transfer_function(sentences, before.transfer_function, after.transfer_function);
  add_settings(sentences, before.rendering, after.rendering);
  if (before.camera != after.camera) sentences.push_back(camera_change(before.camera, after.camera));
  return sentences;
}

}  // namespace crest
