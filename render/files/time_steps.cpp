#include "render/files/time_steps.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "render/files/load.h"
#include "render/files/natural_order.h"
#include "render/files/open_choice.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// What stands before and behind a number in a file's name.
struct Affixes {
  std::string_view before, behind;
  bool fit(std::string_view name) const {
    if (name.size() <= before.size() + behind.size()) return false;
    if (!name.starts_with(before) || !name.ends_with(behind)) return false;
    name.remove_prefix(before.size());
    name.remove_suffix(behind.size());
    return std::ranges::all_of(name, is_digit);
  }
};

/// Of the files of a folder, where it can be read.
std::vector<std::string> file_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failure;
  fs::directory_iterator entries(folder.empty() ? "." : folder, failure);
  for (; !failure && entries != fs::directory_iterator(); entries.increment(failure)) {
    std::error_code ignored;
    if (!entries->is_directory(ignored)) names.push_back(entries->path().filename().string());
  }
  return names;
}

}  // namespace

std::vector<fs::path> numbered_files(const fs::path& pattern) {
  const std::string name = pattern.filename().string();
  const std::size_t star = name.find('*');
  if (star == name.npos || name.find('*', star + 1) != name.npos) return {};
  const Affixes affixes{std::string_view(name).substr(0, star), std::string_view(name).substr(star + 1)};
  std::vector<std::string> names = file_names(pattern.parent_path());
  std::erase_if(names, [&](const std::string& one) { return !affixes.fit(one); });
  std::ranges::sort(names, natural_less);
  std::vector<fs::path> files;
  for (const std::string& one : names) files.push_back(pattern.parent_path() / one);
  return files;
}

std::optional<NumberedList> numbered_list_of(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::vector<std::string> names = file_names(file.parent_path());
  std::optional<NumberedList> best;
  for (std::size_t begin = 0; begin < name.size(); ++begin) {
    if (!is_digit(name[begin])) continue;
    std::size_t end = begin;
    while (end < name.size() && is_digit(name[end])) ++end;
    const Affixes affixes{std::string_view(name).substr(0, begin), std::string_view(name).substr(end)};
    const auto count =
        std::size_t(std::ranges::count_if(names, [&](const std::string& one) { return affixes.fit(one); }));
    if (count > 1 && (!best || count > best->count)) {
      std::string starred = name;
      best = NumberedList{file.parent_path() / starred.replace(begin, end - begin, "*"), count};
    }
    begin = end;
  }
  return best;
}

std::optional<FoundSource> find_source(const std::string& source) {
  const auto found = [](const std::string& name, std::string query) -> std::optional<FoundSource> {
    std::error_code ignored;
    if (fs::exists(name, ignored)) return FoundSource{name, std::move(query), {}};
    if (auto list = numbered_files(name); !list.empty())
      return FoundSource{name, std::move(query), std::move(list)};
    return std::nullopt;
  };
  if (auto whole = found(source, "")) return whole;
  for (std::size_t at = source.rfind('?'); at != std::string::npos && at > 0;
       at = source.rfind('?', at - 1)) {
    if (auto part = found(source.substr(0, at), source.substr(at + 1))) return part;
  }
  return std::nullopt;
}

fs::path first_file(const fs::path& path) {
  const auto found = find_source(path.string());
  return found && !found->list.empty() ? found->list.front() : path;
}

std::string source_of_step(const std::string& source, int step) {
  const auto found = find_source(source);
  const std::string path = found ? found->path.string() : source.substr(0, source.find('?'));
  const std::string text = found ? found->query : source.substr(std::min(path.size() + 1, source.size()));
  Query query = parse_query(path, text);
  query["frame"] = std::to_string(step);
  return source_of(path, query);
}

Volume load_first_step(const std::string& source, const Reading& reading) {
  try {
    return load_volume(source, reading);
  } catch (const ChoiceNeeded& needed) {
    if (needed.choice.kind != ChoiceKind::frame || !needed.choice.options.empty()) throw;
  }
  try {
    return load_volume(source_of_step(source, 0), reading);
  } catch (ChoiceNeeded& needed) {
    needed.choice.query.erase("frame");  // nobody chose it
    throw;
  }
}

ValueRange range_of_steps(const std::string& source, const Volume& volume, const Reading& reading) {
  std::optional<ValueRange> all = finite_range(volume);
  for (int step = 0; step < volume.frames; ++step) {
    if (step == volume.frame) continue;
    const auto range = finite_range(load_volume(source_of_step(source, step), reading));
    if (range) all = all ? joined(*all, *range) : *range;
  }
  return all.value_or(volume.statistics.range);
}

}  // namespace crest
