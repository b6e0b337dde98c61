#include "ui/clipboard.h"

#include <algorithm>

#include "presets/error.h"
#include "presets/points_text.h"

namespace crest {
namespace {

constexpr double beside = 0.02;  // of what is in sight: how far pasted points go out of the way

bool is_there(const TransferFunction& tf, const std::vector<ControlPoint>& points) {
  return std::ranges::any_of(points, [&](const ControlPoint& p) {
    return std::ranges::binary_search(tf.points, p.value, {}, &ControlPoint::value);
  });
}

}  // namespace

void copy_points(const TransferFunction& tf, const EditorState& editor) {
  if (editor.selection.empty()) return;
  TransferFunction copied;
  copied.domain = tf.domain;
  for (const std::size_t i : editor.selection) copied.points.push_back(tf.points[i]);
  ImGui::SetClipboardText(points_text(copied).c_str());
}

bool delete_points(TransferFunction& tf, EditorState& editor) {
  if (editor.selection.empty()) return false;
  erase_points(tf, editor.selection);
  editor.selection.clear();
  return true;
}

bool cut_points(TransferFunction& tf, EditorState& editor) {
  copy_points(tf, editor);
  return delete_points(tf, editor);
}

bool paste_points(TransferFunction& tf, EditorState& editor, ValueRange volume, ValueRange visible) {
  const char* const text = ImGui::GetClipboardText();
  TransferFunction pasted;
  try {
    pasted = in_domain(points_in(text ? text : ""), tf.domain, volume);
  } catch (const Error&) {
    editor.note = "The clipboard holds no points";
    return false;
  }
  constexpr int most_steps = 1000;
  for (int i = 0; i < most_steps && is_there(tf, pasted.points); ++i)
    for (ControlPoint& point : pasted.points) point.value += beside * visible.width();
  const std::size_t before = tf.points.size();
  std::vector<ControlPoint> all = tf.points;
  all.insert(all.end(), pasted.points.begin(), pasted.points.end());
  const Moved result = in_order(all);
  tf.points = result.points;
  editor.selection.clear();
  for (std::size_t i = before; i < all.size(); ++i) editor.selection.push_back(result.now_at[i]);
  std::ranges::sort(editor.selection);
  editor.type_value = true;
  return true;
}

}  // namespace crest
