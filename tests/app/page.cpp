#include "page.h"
#include "tests/json.h"

#include <gtest/gtest.h>

#include <regex>

namespace crest::test {

nlohmann::json expect_standalone_page(const std::string& page) {
  EXPECT_EQ(page.find("{{"), page.npos) << "a mark was not filled in";
  // No address but of XML's namespaces
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(https?://(?!www\.w3\.org/))")));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(<(link|script|img)[^>]*(src|href)=)")));
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t at = page.find(begin);
  if (at == page.npos) {
    ADD_FAILURE() << "the page has no data";
    return {};
  }
  const std::size_t from = at + begin.size();
  return test::parse_json(page.substr(from, page.find("</script>", from) - from));
}

}  // namespace crest::test
