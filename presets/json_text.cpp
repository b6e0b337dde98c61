#include "presets/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "presets/error.h"

namespace crest {
namespace {

constexpr std::size_t most_levels = 64;
constexpr std::size_t most_keys = 1000;

/// Follows the parser through the text: knows the path, and refuses what would harm those who read it.
class Guard {
 public:
  bool operator()(int, nlohmann::detail::parse_event_t event, Json& value) {
    using Event = nlohmann::detail::parse_event_t;
    switch (event) {
      case Event::key:
        add_key(value.get_ref<const std::string&>());
        break;
      case Event::object_start:
        open(false);
        break;
      case Event::array_start:
        open(true);
        break;
      case Event::object_end:
      case Event::array_end:
        levels.pop_back();
        [[fallthrough]];
      case Event::value:
        if (!levels.empty()) ++levels.back().index;
        break;
    }
    return true;
  }

  std::string path() const {
    std::string text;
    for (const Level& level : levels) {
      if (level.is_array)
        text += fmt::format("[{}]", level.index);
      else
        text = join_path(text, level.key);
    }
    return text;
  }

 private:
  struct Level {
    bool is_array;
    std::size_t index = 0;
    std::string key = {};
    std::set<std::string> keys = {};
  };

  void open(bool is_array) {
    if (levels.size() == most_levels)
      throw Error(fmt::format("nested more than {} levels deep", most_levels));
    levels.push_back({is_array});
  }

  void add_key(const std::string& key) {
    Level& level = levels.back();
    level.key = key;
    if (!level.keys.insert(key).second) throw Error(fmt::format("{}: appears twice", path()));
    if (level.keys.size() > most_keys)
      throw Error(fmt::format("{}: one object has more than {} keys", path(), most_keys));
  }

  std::vector<Level> levels;
};

std::string without_exception_name(std::string_view what) {
  const std::size_t end = what.find("] ");
  return std::string(end == std::string_view::npos ? what : what.substr(end + 2));
}

std::string scalar_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void print_inline(const Json& json, std::string& out) {
  if (!json.is_structured()) {
    out += scalar_text(json);
    return;
  }
  out += json.is_array() ? "[" : "{";
  bool first = true;
  for (const auto& item : json.items()) {
    if (!first) out += ", ";
    first = false;
    if (json.is_object()) out += scalar_text(item.key()) + ": ";
    print_inline(item.value(), out);
  }
  out += json.is_array() ? "]" : "}";
}

bool has_structure(const Json& json) {
  return std::any_of(json.begin(), json.end(), [](const Json& element) { return element.is_structured(); });
}

void print_spread(const Json& json, std::size_t indent, std::string& out) {
  const bool spread = (json.is_object() && !json.empty()) || (json.is_array() && has_structure(json));
  if (!spread) return print_inline(json, out);
  out += json.is_array() ? "[" : "{";
  bool first = true;
  for (const auto& item : json.items()) {
    out += first ? "\n" : ",\n";
    first = false;
    out.append(indent + 2, ' ');
    if (json.is_array()) {
      print_inline(item.value(), out);
    } else {
      out += scalar_text(item.key()) + ": ";
      print_spread(item.value(), indent + 2, out);
    }
  }
  out += "\n";
  out.append(indent, ' ');
  out += json.is_array() ? "]" : "}";
}

}  // namespace

Json parse_json(std::string_view text) {
  Guard guard;
  try {
    return Json::parse(text, std::ref(guard));
  } catch (const Json::parse_error& error) {
    throw Error(without_exception_name(error.what()));
  } catch (const Json::out_of_range& error) {
    throw Error(fmt::format("{}: {}", guard.path(), without_exception_name(error.what())));
  }
}

std::string print_json(const Json& json) {
  std::string text;
  print_spread(json, 0, text);
  return text + "\n";
}

std::string summary_of(const Json& json) {
  if (json.is_structured() && json.size() > 4)
    return json.is_array() ? fmt::format("an array of {}", json.size()) : "an object";
  std::string text = scalar_text(json);
  if (text.size() <= 40) return text;
  text.resize(40);
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
  if (!text.empty() && (static_cast<unsigned char>(text.back()) & 0x80)) text.pop_back();
  return text + "...";
}

std::string join_path(std::string_view object, std::string_view key) {
  return object.empty() ? std::string(key) : fmt::format("{}.{}", object, key);
}

}  // namespace crest
