#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/keys.h"
#include "ui/studio.h"

namespace crest {

// All that a person can tell the studio to do by a word or a key: the menus, the keys, the list of keys and
// the command palette read this one table.

/// What an action works on.
struct ActionContext {
  Document& document;
  StudioState& state;
  const StudioInputs& inputs;
  StudioRequests& requests;
};

/// The headings that actions stand under; the first ones are the menus.
enum class Section { volume, preset, edit, view, help, curve, compare, panels };
inline constexpr int menu_count = 5, section_count = 8;
std::string_view title_of(Section section);

/// When an action's key counts, as long as no menu and no window that asks something is open.
enum class KeyWhen {
  always,
  not_typing,  ///< while no text is typed
  untouched,   ///< and nothing is held; it closes a field in which nothing was typed yet
  at_rest      ///< and no button of the mouse either
};

struct Action {
  std::string name{};  ///< as people read it; no other in the table has it
  Section section = Section::volume;
  KeyChord key{}, other_key{};
  KeyWhen when = KeyWhen::always;
  bool takes_typed = false;  ///< a number that is being typed counts as finished
  bool separated = false;    ///< by a line from what is before it in its menu
  std::string tip{};
  /// What it would do at present, to be read behind the name; may be empty.
  std::function<std::string(const ActionContext&)> detail{};
  /// Why it cannot be done at present; empty while it can.
  std::function<std::string(const ActionContext&)> why_not{};
  std::function<bool(const ActionContext&)> checked{};  ///< of a switch
  /// Returns whether it changed the document.
  std::function<bool(const ActionContext&)> run{};
  /// Of a list, in place of `run`: what there is to choose from at present. Their names are their own.
  std::function<std::vector<Action>(const ActionContext&)> entries{};
  std::string lead{};     ///< of a list: stands before its entries' names where those stand alone
  std::string if_none{};  ///< of a list without entries; where it is empty the list is then not shown
};

/// The table, in the order of the menus.
std::span<const Action> actions();

/// One of the table; throws std::out_of_range where there is none.
const Action& action_named(std::string_view name);
/// "Ctrl+S": of one of the table.
std::string key_text_of(std::string_view name);
std::string key_text_of(const Action& action);

std::string why_not(const Action& action, const ActionContext& context);
/// Action::why_not of what needs a volume.
std::string needs_volume(const ActionContext& context);
/// "Undo: move 3 points".
std::string title_of(const Action& action, const ActionContext& context);

/// Runs what has its key pressed. Returns whether that changed the document.
bool shortcuts(const ActionContext& context);
/// Whether the key of an action is pressed for which a text that is being typed counts as finished.
bool takes_typed_text();

/// The table's parts.
void add_file_actions(std::vector<Action>& table);
void add_edit_actions(std::vector<Action>& table);
void add_view_actions(std::vector<Action>& table);
void add_compare_actions(std::vector<Action>& table);
void add_window_actions(std::vector<Action>& table);

}  // namespace crest
