#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/paths.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> documents() {
  const fs::path root = crest::test::source_folder();
  std::vector<fs::path> found{root / "README.md", root / "CONTRIBUTING.md"};
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

std::string content_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// As Markdown's readers make it of a heading: "How long the steps are" is how-long-the-steps-are.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
      anchor += char(std::tolower(static_cast<unsigned char>(c)));
    else if (c == ' ')
      anchor += '-';
  }
  return anchor;
}

std::set<std::string> anchors_in(const std::string& text) {
  std::set<std::string> anchors;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t level = line.find_first_not_of('#');
    if (level > 0 && level != line.npos && line[level] == ' ')
      anchors.insert(anchor_of(line.substr(level + 1)));
  }
  return anchors;
}

/// What stands in "](...)".
std::vector<std::string> links_in(const std::string& text) {
  std::vector<std::string> links;
  for (std::size_t at = text.find("]("); at != text.npos; at = text.find("](", at + 2)) {
    const std::string link = text.substr(at + 2, text.find(')', at) - at - 2);
    if (link.find_first_of(" \n") == link.npos) links.push_back(link);
  }
  return links;
}

TEST(Documents, LinksLeadSomewhere) {
  std::size_t links = 0;
  for (const fs::path& document : documents()) {
    for (const std::string& link : links_in(content_of(document))) {
      if (link.find("://") != link.npos) continue;
      ++links;
      const std::size_t hash = std::min(link.find('#'), link.size());
      const fs::path file = hash == 0 ? document : document.parent_path() / link.substr(0, hash);
      ASSERT_TRUE(fs::exists(file)) << document << " leads to " << link;
      if (hash == link.size()) continue;
      EXPECT_TRUE(anchors_in(content_of(file)).contains(link.substr(hash + 1))) << document << ": " << link;
    }
  }
  EXPECT_GT(links, 40U);
}

TEST(Documents, EachPageOfTheManualIsInItsList) {
  const fs::path manual = crest::test::source_folder() / "docs" / "manual";
  const std::string index = content_of(manual / "index.md");
  for (const auto& entry : fs::directory_iterator(manual)) {
    const std::string name = entry.path().filename().string();
    if (name == "index.md") continue;
    EXPECT_NE(index.find("](" + name + ")"), index.npos) << name;
  }
}

}  // namespace
