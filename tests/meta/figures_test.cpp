// Laws of the figures: each stands in docs/ under the commands that draw it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

const std::filesystem::path docs = std::filesystem::path(TRIBUNAL_SOURCE_DIR) / "docs";

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::set<std::string> found;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), regex); at != std::sregex_iterator(); ++at)
    found.insert((*at)[1]);
  return found;
}

TEST(Figures, AreDrawnShownAndSmall) {
  std::ifstream file(docs / "figures.md");
  std::ostringstream page;
  page << file.rdbuf();
  const auto shown = matches(page.str(), R"(\]\(figures/([^)]+)\))");
  const auto drawn = matches(page.str(), R"(--picture (\S+))");
  EXPECT_EQ(shown, drawn);
  std::set<std::string> there;
  for (const auto& entry : std::filesystem::directory_iterator(docs / "figures")) {
    there.insert(entry.path().filename().string());
    EXPECT_LT(entry.file_size(), 500'000U) << entry.path();
  }
  EXPECT_EQ(there, shown);
  EXPECT_GE(there.size(), 10U);
}

}  // namespace
