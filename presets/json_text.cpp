#include "presets/json_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <vector>

#include "presets/error.h"
#include "presets/json.h"
#include "presets/printable.h"

namespace crest {
namespace {

constexpr std::size_t most_levels = 64;
constexpr std::size_t most_keys = 1000;

std::string without_exception_name(std::string_view what) {
  const std::size_t end = what.find("] ");
  return std::string(end == std::string_view::npos ? what : what.substr(end + 2));
}

/// Reads a text without keeping it: knows the path, and refuses what would harm those who read it. (A filter
/// on the parser proper would do the same, but takes time quadratic in an array's length.)
class Guard final : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(Json::number_integer_t) override { return value(); }
  bool number_unsigned(Json::number_unsigned_t) override { return value(); }
  bool number_float(Json::number_float_t, const std::string&) override { return value(); }
  bool string(std::string&) override { return value(); }
  bool binary(Json::binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return open(false); }
  bool start_array(std::size_t) override { return open(true); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& key) override {
    Level& level = levels.back();
    level.key = key;
    if (!level.keys.insert(key).second) throw Error(path() + ": appears twice");
    if (level.keys.size() > most_keys)
      throw Error(fmt::format("{}: one object has more than {} keys", path(), most_keys));
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
    const bool number_overflow = dynamic_cast<const Json::out_of_range*>(&error) != nullptr;
    throw Error((number_overflow ? path() + ": " : "") + without_exception_name(error.what()));
  }

 private:
  struct Level {
    bool is_array;
    std::size_t index = 0;
    std::string key = {};
    std::set<std::string> keys = {};
  };

  bool open(bool is_array) {
    if (levels.size() == most_levels)
      throw Error(fmt::format("nested more than {} levels deep", most_levels));
    levels.push_back({is_array});
    return true;
  }
  bool close() {
    levels.pop_back();
    return value();
  }
  /// A value has ended.
  bool value() {
    if (!levels.empty()) ++levels.back().index;
    return true;
  }

  std::string path() const {
    std::string text;
    for (const Level& level : levels)
      text = level.is_array ? fmt::format("{}[{}]", text, level.index) : join_path(text, level.key);
    return text;
  }

  std::vector<Level> levels;
};

/// Controls that JSON need not escape, but a terminal obeys, stand in strings alone.
std::string escaped(const std::string& json) {
  std::string out;
  for (std::string_view rest = json; !rest.empty();) {
    const Character c = first_character(rest);
    if (c.bytes > 0 && c.number >= 0x7f && is_control(c.number))
      out += fmt::format("\\u{:04x}", c.number);
    else
      out += rest.substr(0, std::max<std::size_t>(c.bytes, 1));
    rest.remove_prefix(std::max<std::size_t>(c.bytes, 1));
  }
  return out;
}

std::string scalar_text(const Json& json) {
  return escaped(json.dump(-1, ' ', false, Json::error_handler_t::replace));
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
  if (const std::size_t zero = text.find('\0'); zero != text.npos)  // the parser would take it for the end
    throw Error(fmt::format("parse error at byte {}: it is zero, which no JSON has", zero + 1));
  Guard guard;
  Json::sax_parse(text, &guard);
  return Json::parse(text);
}

std::string print_json(const Json& json) {
  std::string text;
  print_spread(json, 0, text);
  return text + "\n";
}

std::string pretty(const Json& json) {
  return escaped(json.dump(2, ' ', false, Json::error_handler_t::replace));
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
