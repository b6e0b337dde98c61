#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
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
  static const std::regex heading("(^|\n)#+ ([^\n]+)");
  std::set<std::string> anchors;
  for (std::sregex_iterator at(text.begin(), text.end(), heading), end; at != end; ++at)
    anchors.insert(anchor_of((*at)[2]));
  return anchors;
}

TEST(Documents, LinksLeadSomewhere) {
  static const std::regex link(R"(\]\(([^)#\s]*)(#([^)\s]+))?\))");
  std::size_t links = 0;
  for (const fs::path& document : documents()) {
    const std::string text = content_of(document);
    for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
      const std::string target = (*at)[1], anchor = (*at)[3];
      if (target.find("://") != target.npos) continue;
      ++links;
      const fs::path file = target.empty() ? document : document.parent_path() / target;
      ASSERT_TRUE(fs::exists(file)) << document << " leads to " << target;
      if (anchor.empty()) continue;
      EXPECT_TRUE(anchors_in(content_of(file)).contains(anchor))
          << document << ": " << target << "#" << anchor;
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
