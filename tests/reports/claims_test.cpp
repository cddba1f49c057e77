// Claim files: all that ship are sound, and what is wrong with one is said with its place.
#include "reports/claim.hpp"
#include "reports/embedded.hpp"
#include "reports/judges/list.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tribunal::reports {
namespace {

constexpr const char* sound = R"(id = "X1"
title = "A title"
statement = "Something holds."
source = "somebody 1990"
expected = "refuted"
[rule]
judge = "expected-tau"
sigmas = 4
[[quick]]
experiment = "scopes"
n = 6
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::string complaint(const std::string& text) {
  try {
    parse_claim(text, "X1.toml");
  } catch (const ClaimError& error) {
    return error.what();
  }
  return "none";
}

TEST(Claims, all_registered_ones_parse_under_the_name_of_their_file) {
  const std::vector<Claim> claims = registered_claims();
  EXPECT_GE(claims.size(), 12U);
  std::set<std::string> ids;
  for (const Claim& claim : claims) {
    EXPECT_EQ(claim.id + ".toml", claim.file);
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    EXPECT_TRUE(claim.tiers.contains("quick")) << claim.id;
    EXPECT_NE(find_judge(claim.rule.judge), nullptr);
    EXPECT_LE(claim.title.size(), 30U) << "a title is a few words: " << claim.id;
  }
}

TEST(Claims, every_judge_serves_a_claim_and_has_a_name_of_its_own) {
  std::set<std::string> used;
  for (const Claim& claim : registered_claims()) used.insert(claim.rule.judge);
  std::set<std::string> names;
  for (const Judge& judge : judges()) {
    EXPECT_TRUE(names.insert(std::string(judge.name)).second) << judge.name;
    EXPECT_TRUE(used.contains(std::string(judge.name))) << judge.name;
    EXPECT_FALSE(judge.summary.empty());
  }
}

TEST(Claims, a_tier_is_a_campaigns_table) {
  const Claim claim = parse_claim(sound, "X1.toml");
  EXPECT_EQ(claim.expected, Verdict::refuted);
  const toml::table& quick = claim.tier("quick");
  ASSERT_NE(quick.get_as<toml::array>("cells"), nullptr);
  const toml::table& cell = *quick.get_as<toml::array>("cells")->get_as<toml::table>(0);
  EXPECT_EQ(cell["n"].value<int>(), 6);
  EXPECT_EQ(cell.source().begin.line, 9U);  // messages about cells keep their line
  EXPECT_EQ(&claim.tier("full"), &quick);   // no full tier: the quick one stands in
}

TEST(Claims, complaints_name_file_line_and_column) {
  EXPECT_EQ(complaint(sound), "none");
  EXPECT_EQ(complaint(replaced(sound, "source =", "sauce =")), "X1.toml:4:1: unknown key \"sauce\"");
  EXPECT_EQ(complaint(replaced(sound, "\"expected-tau\"", "\"Solomon\"")),
            "X1.toml:7:9: no judge is named \"Solomon\"");
  EXPECT_EQ(complaint(replaced(sound, "sigmas", "sigma")),
            "X1.toml:8:1: judge \"expected-tau\" has no parameter \"sigma\"");
  EXPECT_EQ(complaint(replaced(sound, "sigmas = 4", "sigmas = \"4\"")),
            "X1.toml:8:10: \"sigmas\" has the wrong type");
  EXPECT_EQ(complaint(replaced(sound, "\"refuted\"", "\"maybe\"")),
            "X1.toml:5:12: expected is \"reproduced\" or \"refuted\", not \"maybe\"");
  EXPECT_EQ(complaint(replaced(sound, "title = \"A title\"\n", "")), "X1.toml:1:1: missing key \"title\"");
  EXPECT_EQ(complaint(replaced(sound, "\"somebody 1990\"", "1990")),
            "X1.toml:4:10: \"source\" is a text that is not empty");
  EXPECT_EQ(complaint(replaced(sound, "judge = \"expected-tau\"\nsigmas = 4",
                               "judge = \"growth-model\"\nlaw = \"N\"")),
            "X1.toml:6:1: judge \"growth-model\" needs \"counters\"");
}

TEST(Claims, bad_toml_and_bad_tiers_are_complained_of) {
  EXPECT_EQ(complaint(replaced(sound, "n = 6", "n = = 6")).substr(0, 13), "X1.toml:11:5:");
  EXPECT_NE(complaint(replaced(sound, "[[quick]]", "[quick]")).find("list of cell tables"),
            std::string::npos);
  EXPECT_NE(complaint(replaced(sound, "[[quick]]", "[[full]]")).find("missing key \"quick\""),
            std::string::npos);
  EXPECT_NE(complaint("").find("missing key"), std::string::npos);
  EXPECT_NE(complaint("\xFF\xFE").find("X1.toml:1:"), std::string::npos);
}

TEST(Embedded, files_are_whole) {
  for (const EmbeddedFile& file : embedded_claims()) {
    EXPECT_TRUE(file.text.starts_with("id = ")) << file.name;
    EXPECT_EQ(file.text.back(), '\n') << file.name;
  }
  EXPECT_EQ(embedded_page().size(), 2U);
  for (const EmbeddedFile& file : embedded_charting()) {
    EXPECT_GT(file.text.size(), 10000U) << file.name;
    EXPECT_EQ(file.text.find("</script"), std::string_view::npos)
        << file.name << " would end its own element";
  }
}

}  // namespace
}  // namespace tribunal::reports
