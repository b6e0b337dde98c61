#include "app/options.h"

#include <algorithm>
#include <sstream>

#include "app/completions.h"
#include "app/config_file.h"
#include "app/option_help.h"
#include "presets/error.h"
#include "presets/json.h"
#include "program.h"
#include "tests/paths.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;

class OptionsOfTheProgram : public ProgramTest {
 protected:
  nlohmann::json commands() const { return nlohmann::json::parse(output_of({"list", "options", "--json"})); }
};

TEST_F(OptionsOfTheProgram, HelpFitsAScreen) {
  std::istringstream help(output_of({"--help"}));
  int lines = 0;
  for (std::string line; std::getline(help, line); ++lines) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_LE(lines, 30);
}

TEST_F(OptionsOfTheProgram, HelpOfACommandHasEachOptionOfTheTable) {
  const auto table = commands();
  ASSERT_GE(table.size(), 11U);
  for (const auto& command : table) {
    const std::string help = output_of({command["name"], "--help"});
    for (const auto& option : command["options"])
      for (const auto& name : option["names"])
        EXPECT_NE(help.find(name.get<std::string>()), std::string::npos) << command["name"] << name;
  }
}

TEST_F(OptionsOfTheProgram, TheManualHasThisTable) {
  EXPECT_EQ(content_of(source_folder() / "docs" / "manual" / "options.md"), output_of({"list", "options"}))
      << "build/app/crest list options > docs/manual/options.md";
}

/// What bash offers for a line, sorted, by the completions that the program prints.
class BashCompletions : public ProgramTest {
 protected:
  Words offered(const Words& words) const {
    write("completions", output_of({"list", "completions", "--for", "bash"}));
    std::string line;
    for (const std::string& word : words) line += " '" + word + "'";
    write("ask", "source ./completions\nCOMP_WORDS=(crest" + line +
                     ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_crest 2>/dev/null\nprintf '%s\\n' "
                     "\"${COMPREPLY[@]}\"\n");
    const Outcome outcome = run_shell("bash ask");
    std::istringstream lines(outcome.out);
    Words offers;
    for (std::string offer; std::getline(lines, offer);)
      if (!offer.empty()) offers.push_back(offer);
    std::ranges::sort(offers);
    return offers;
  }
};

TEST_F(BashCompletions, OfferWhatFits) {
  EXPECT_EQ(offered({"re"}), (Words{"render", "report"}));
  EXPECT_EQ(offered({"render", "--mode", "PEAK"}), (Words{"PEAK_ONLY", "PEAK_XOR_DVR"}));
  EXPECT_EQ(offered({"render", "x", "--tu"}), Words{"--turntable"});
  EXPECT_EQ(offered({"compare", "x", "--tu"}), Words{});
  EXPECT_EQ(offered({"--preset", "dir"}), Words{"dirac-shell"});
  EXPECT_EQ(offered({"export", "oni"}), Words{"onion"});
  EXPECT_EQ(offered({"render", "x", "--preset", "comp"}), Words{"completions"}) << "a file";
}

}  // namespace
}  // namespace crest::test
