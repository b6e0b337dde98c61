#include "render/volume/query.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "presets/error.h"
#include "presets/nearest_word.h"

namespace crest {
namespace {

template <class T>
std::optional<T> parse(std::string_view text) {
  T value{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

Query parse_query(std::string_view name, std::string_view text) {
  Query query;
  if (text.empty()) return query;
  for (const std::string_view part : split(text, '&')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos || equals == 0) {
      throw Error(fmt::format("{}: \"{}\" in the query is not key=value", name, part));
    }
    const std::string key(part.substr(0, equals));
    if (!query.emplace(key, part.substr(equals + 1)).second) {
      throw Error(fmt::format("{}: \"{}\" is in the query twice", name, key));
    }
  }
  return query;
}

void require_known_keys(std::string_view name, const Query& query, std::string_view known) {
  const auto keys = split(known, ',');
  for (const auto& [key, value] : query) {
    bool found = false;
    for (const std::string_view k : keys) found = found || k == key;
    if (!found)
      throw Error(fmt::format("{}: it has no \"{}\"; its keys are {}{}", name, key, fmt::join(keys, ", "),
                              did_you_mean(key, keys)));
  }
}

std::optional<double> to_number(std::string_view text) {
  const auto value = parse<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> to_integer(std::string_view text) { return parse<std::int64_t>(text); }

std::optional<glm::dvec3> to_vector(std::string_view text, char separator) {
  const auto parts = split(text, separator);
  if (parts.size() != 3) return std::nullopt;
  glm::dvec3 vector;
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = to_number(parts[std::size_t(axis)]);
    if (!value) return std::nullopt;
    vector[axis] = *value;
  }
  return vector;
}

double number_in(std::string_view name, const Query& query, std::string_view key, double fallback, double min,
                 double max) {
  const auto found = query.find(key);
  if (found == query.end()) return fallback;
  const auto value = to_number(found->second);
  if (!value || *value < min || *value > max) {
    throw Error(fmt::format("{}: {}={} is not a number in [{}, {}]", name, key, found->second, min, max));
  }
  return *value;
}

std::int64_t integer_in(std::string_view name, const Query& query, std::string_view key,
                        std::int64_t fallback, std::int64_t min, std::int64_t max) {
  const auto found = query.find(key);
  if (found == query.end()) return fallback;
  const auto value = to_integer(found->second);
  if (!value || *value < min || *value > max) {
    throw Error(
        fmt::format("{}: {}={} is not a whole number in [{}, {}]", name, key, found->second, min, max));
  }
  return *value;
}

}  // namespace crest
