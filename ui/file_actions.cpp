#include <utility>

#include "presets/exchange/color_maps.h"
#include "presets/preset_file.h"
#include "render/volume/builtin.h"
#include "ui/actions.h"
#include "ui/questions.h"
#include "ui/studio_state.h"

// The actions of the menus Volume and Preset.

namespace crest {
namespace {

auto asks_for(FilePurpose purpose) {
  return [purpose](const ActionContext& c) {
    ask_for_file(c.state, c.document, purpose);
    return false;
  };
}

std::vector<Action> recent(const ActionContext& c, bool presets) {
  std::vector<Action> entries;
  for (const std::string& file : c.inputs.recent)
    if (is_preset_name(file) == presets)
      entries.push_back({.name = file, .run = [file, presets](const ActionContext& context) {
                           StudioRequests& requests = context.requests;
                           (presets ? requests.open_preset : requests.open_volume) = file;
                           return false;
                         }});
  return entries;
}

std::vector<Action> builtin_volumes(const ActionContext&) {
  std::vector<Action> entries;
  for (const Builtin& builtin : builtins()) {
    const std::string name(builtin.name);
    entries.push_back(
        {.name = name, .tip = std::string(builtin.summary), .run = [name](const ActionContext& c) {
           c.requests.open_volume = "builtin:" + name;
           return false;
         }});
  }
  return entries;
}

std::vector<Action> library_presets(const ActionContext&) {
  std::vector<Action> entries;
  for (const LibraryPreset& preset : library()) {
    const std::string name(preset.name);
    entries.push_back({.name = name, .run = [name](const ActionContext& c) {
                         c.requests.open_preset = name;
                         return false;
                       }});
  }
  return entries;
}

/// The maps' colours on the points; those over 0..1 are laid over the points' range.
bool take_color_map(const ActionContext& c, const ColorMap& map) {
  TransferFunction& tf = c.document.preset.transfer_function;
  const ValueRange range = c.inputs.volume ? c.inputs.volume->statistics.range : ValueRange{};
  const TransferFunction before = std::exchange(tf, with_color_map(tf, map, range));
  return !(tf == before);
}

std::vector<Action> color_map_entries(const ActionContext& c) {
  static const std::vector<ColorMap> maps = color_maps();
  const bool is_normalized = c.document.preset.transfer_function.domain == Domain::normalized;
  std::vector<Action> entries;
  for (const ColorMap& map : maps) {
    const char* const how = map.distinct.empty() ? "\nlaid over the points; opacities stay"
                                                 : "\na colour for each peak; opacities stay";
    entries.push_back({.name = map.name, .tip = map.source + how});
    if (map.in_data_values && is_normalized) entries.back().why_not = needs_volume;
    entries.back().run = [&map](const ActionContext& context) { return take_color_map(context, map); };
  }
  return entries;
}

/// Each is of the TF as it was when the other volume was there, so that one can be tried after the other.
std::vector<Action> carry_entries(const ActionContext& c) {
  std::vector<Action> entries;
  if (!c.inputs.carry_over) return entries;
  const auto add = [&](const char* name, const char* tip, CarryBy by) {
    entries.push_back({.name = name, .tip = tip, .run = [by](const ActionContext& context) {
                         context.requests.carry = by;
                         return false;
                       }});
  };
  add("By histogram", "A value goes to that with as many voxels below it", CarryBy::histogram);
  entries.back().why_not = [](const ActionContext& context) {
    return context.inputs.carry_over->knows_values ? "" : "the values of one volume are not known";
  };
  add("By the same places",
      "By least squares: a value goes to what the volume has on average where the last one has the value.\n"
      "For two volumes of the same thing on the same grid",
      CarryBy::places);
  entries.back().why_not = [](const ActionContext& context) {
    return context.inputs.carry_over->same_grid ? "" : "the volumes have not the same number of points";
  };
  add("By range", "Least to least, greatest to greatest value", CarryBy::range);
  add("As values", "The same numbers", CarryBy::value);
  return entries;
}

bool fit_to_volume(const ActionContext& c) {
  TransferFunction& tf = c.document.preset.transfer_function;
  const TransferFunction before = std::exchange(tf, fitted(tf, c.inputs.volume->statistics.range));
  c.state.editor.visible.reset();
  return !(tf == before);
}

bool convert_to(const ActionContext& c, Domain domain) {
  TransferFunction& tf = c.document.preset.transfer_function;
  tf = in_domain(tf, domain, c.inputs.volume->statistics.range);
  c.state.editor.visible.reset();
  c.state.editor.new_peak_width.reset();
  return true;
}

std::string why_not_convert(const ActionContext& c, Domain domain) {
  if (c.document.preset.transfer_function.domain == domain) return "its values are that already";
  return needs_volume(c);
}

bool save(const ActionContext& c) {
  if (c.document.preset_path.empty())
    ask_for_file(c.state, c.document, FilePurpose::save_preset);
  else
    c.requests.save_preset = c.document.preset_path;
  return false;
}

void add_volume_actions(std::vector<Action>& table) {
  const auto add = [&](Action action) {
    action.section = Section::volume;
    table.push_back(std::move(action));
  };
  add({.name = "Open volume...",
       .key = ctrl_and('O'),
       .takes_typed = true,
       .run = asks_for(FilePurpose::open_volume)});
  add({.name = "Recent volumes",
       .entries = [](const ActionContext& c) { return recent(c, false); },
       .lead = "Open ",
       .if_none = "none yet"});
  add({.name = "Built-in", .entries = builtin_volumes, .lead = "Open builtin:"});
  add({.name = "Close volume", .why_not = needs_volume, .run = [](const ActionContext& c) {
         c.requests.close_volume = true;
         return false;
       }});
  add({.name = "Quit",
       .key = ctrl_and('Q'),
       .takes_typed = true,
       .separated = true,
       .run = [](const ActionContext& c) {
         c.state.quit_asked = true;
         return false;
       }});
}

void add_curve_actions(std::vector<Action>& table) {
  const auto add = [&](Action action) {
    action.section = Section::preset;
    table.push_back(std::move(action));
  };
  add({.name = "Colours", .separated = true, .entries = color_map_entries, .lead = "Colours: "});
  add({.name = "Carry over",
       .tip = "The curve made for the last volume, to this one",
       .entries = carry_entries,
       .lead = "Carry over: "});
  add({.name = "Fit to the volume's range", .why_not = needs_volume, .run = fit_to_volume});
  add({.name = "Convert to data values",
       .why_not = [](const ActionContext& c) { return why_not_convert(c, Domain::data); },
       .run = [](const ActionContext& c) { return convert_to(c, Domain::data); }});
  add({.name = "Convert to normalized values",
       .why_not = [](const ActionContext& c) { return why_not_convert(c, Domain::normalized); },
       .run = [](const ActionContext& c) { return convert_to(c, Domain::normalized); }});
}

}  // namespace

void add_file_actions(std::vector<Action>& table) {
  add_volume_actions(table);
  const auto add = [&](Action action) {
    action.section = Section::preset;
    table.push_back(std::move(action));
  };
  const auto opens = [](auto StudioState::*window) {
    return [window](const ActionContext& c) {
      (c.state.*window).asked = true;
      return false;
    };
  };
  add({.name = "New", .run = [](const ActionContext& c) {
         c.requests.new_preset = true;
         return false;
       }});
  add({.name = "Open preset...",
       .key = ctrl_shift_and('O'),
       .takes_typed = true,
       .tip = "One of Crest's own, or the transfer function of another program",
       .run = asks_for(FilePurpose::open_preset)});
  add({.name = "Recent presets",
       .entries = [](const ActionContext& c) { return recent(c, true); },
       .lead = "Open ",
       .if_none = "none yet"});
  add({.name = "From the library", .entries = library_presets, .lead = "Open preset "});
  add({.name = "Library...", .key = ctrl_and('L'), .run = opens(&StudioState::library)});
  add({.name = "Save", .key = ctrl_and('S'), .takes_typed = true, .separated = true, .run = save});
  add({.name = "Save as...",
       .key = ctrl_shift_and('S'),
       .takes_typed = true,
       .run = asks_for(FilePurpose::save_preset)});
  add({.name = "Export...",
       .key = ctrl_and('E'),
       .takes_typed = true,
       .tip = "For another program",
       .run = opens(&StudioState::export_dialog)});
  add({.name = "Import...",
       .tip = "The transfer function of another program; Open preset reads it, too",
       .run = asks_for(FilePurpose::open_preset)});
  add({.name = "Name and notes...", .run = opens(&StudioState::details)});
  add_curve_actions(table);
}

}  // namespace crest
