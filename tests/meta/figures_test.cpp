// Laws of the figures: each stands in docs/ under the commands that draw it.
#include "tests/meta/sources.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace {
using namespace tribunal::meta;

const fs::path docs = root / "docs";

std::set<std::string> set_of_matches(const std::string& text, const std::string& pattern) {
  const auto found = matches(text, pattern);
  return {found.begin(), found.end()};
}

TEST(Figures, AreDrawnShownAndSmall) {
  const std::string page = read(docs / "figures.md");
  const auto shown = set_of_matches(page, R"(\]\(figures/([^)]+)\))");
  const auto drawn = set_of_matches(page, R"(--picture (\S+))");
  EXPECT_EQ(shown, drawn);
  std::set<std::string> there;
  for (const auto& entry : fs::directory_iterator(docs / "figures")) {
    there.insert(entry.path().filename().string());
    EXPECT_LT(entry.file_size(), 500'000U) << entry.path();
  }
  EXPECT_EQ(there, shown);
  EXPECT_GE(there.size(), 10U);
}

}  // namespace
