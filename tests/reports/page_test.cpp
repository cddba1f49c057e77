// The page: well formed, deterministic, harmless, offline.
#include "reports/page/page.hpp"

#include "reports/embedded.hpp"
#include "tests/reports/rows.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tribunal::reports {
namespace {

constexpr const char* hostile = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'&\xFF";

struct Fixture {
  std::vector<bench::Row> rows;
  std::vector<Tried> trials;
  nlohmann::json manifest = {{"build", {{"commit", "0123456789abcdef"}, {"dirty", false}}}, {"schema", 1}};

  Fixture() {
    for (std::uint64_t seed = 1; seed <= 25; ++seed)
      for (const std::uint64_t n : {100, 1000})
        rows.push_back(run_row("green-sibson", n, seed,
                               {{"tau", 5 * static_cast<double>(n) + static_cast<double>(seed)},
                                {"triangles", 10},
                                {"dimension", 2}}));
    bench::Row failed = run_row("green-sibson", 100, 99, {});
    failed.cell.backend = "double";
    failed.outcome = "loop";
    failed.reason = "walk did not end";
    failed.command = "tribunal cell";
    rows.push_back(failed);
    bench::Row map =
        run_row("sign-map", 0, 1, {{"wrong", 1}, {"false_zero", 1}, {"inverted", 0}, {"false_nonzero", 0}});
    map.cell.parameters = {{"figure", "2a"}};
    map.texts = {{"signs", "+[3]0[1]"}, {"exact", "+[4]"}};
    rows.push_back(map);
    std::vector<bench::Row> taus(rows.begin(), rows.begin() + 50);
    const Claim claim = claim_of("mean-below-bound", {{"bound", "tau"}});
    trials.push_back({claim, try_claim(claim, taus), "tribunal claims test"});
  }

  [[nodiscard]] std::string html() const { return page({manifest, rows, trials}); }
};

/// The page without the charting libraries, which are others' text.
std::string own_part(std::string html) {
  for (const EmbeddedFile& library : embedded_charting()) {
    const auto at = html.find(library.text);
    if (at != std::string::npos) html.erase(at, library.text.size());
  }
  return html;
}

/// Follows the tags of HTML as this page writes it (attributes quoted, no omitted end tags). Returns the
/// first fault.
std::string unbalanced(const std::string& html) {
  const std::set<std::string> empty{"meta", "img", "rect", "path", "line", "!DOCTYPE"};
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at)) {
    const bool closing = html[at + 1] == '/';
    const std::size_t from = at + (closing ? 2 : 1);
    const std::string name = html.substr(from, html.find_first_of(" />\n", from) - from);
    std::size_t end = from;
    for (bool quoted = false; html[end] != '>' || quoted; ++end) quoted ^= html[end] == '"';
    if (closing) {
      if (open.empty() || open.back() != name)
        return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    } else if (!empty.contains(name) && html[end - 1] != '/') {
      open.push_back(name);
    }
    at = end;
    if (!closing && (name == "script" || name == "style")) at = html.find("</" + name, at);
  }
  return open.empty() ? "" : open.back() + " stays open";
}

TEST(Page, is_well_formed) { EXPECT_EQ(unbalanced(own_part(Fixture().html())), ""); }

TEST(Page, same_input_same_bytes) { EXPECT_EQ(Fixture().html(), Fixture().html()); }

TEST(Page, says_what_the_rows_say) {
  const std::string html = Fixture().html();
  EXPECT_NE(html.find("<strong>1 failed</strong> of 1"), std::string::npos);
  EXPECT_NE(html.find("walk did not end"), std::string::npos);
  EXPECT_NE(html.find("1 false zeros, 0 inverted"), std::string::npos);
  EXPECT_NE(html.find("tribunal claims test"), std::string::npos);
  EXPECT_NE(html.find("commit 0123456789ab"), std::string::npos);
  EXPECT_NE(html.find("data:image/png;base64,"), std::string::npos);
}

TEST(Page, fetches_nothing) {
  const std::string html = own_part(Fixture().html());
  for (const char* address : {"http://", "https://", "//cdn", "@import", "url(", "<link", "<iframe"})
    EXPECT_EQ(html.find(address), std::string::npos) << address;
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
}

TEST(Page, survives_hostile_strings_everywhere) {
  Fixture fixture;
  for (bench::Row& row : fixture.rows) {
    row.cell.backend = row.cell.task = row.cell.dataset = row.cell.order = hostile;
    row.outcome = row.reason = row.command = hostile;
    row.counters["triangles"] = 1;
  }
  fixture.rows.push_back(run_row("sign-map", 0, 1, {}));
  fixture.rows.back().cell.parameters = {{"figure", hostile}};
  fixture.rows.back().texts = {{"signs", hostile}, {"exact", hostile}};
  for (bench::Row row : Fixture().rows) {
    row.cell.dataset = hostile;
    fixture.rows.push_back(row);
  }
  Tried& trial = fixture.trials[0];
  trial.claim.id = trial.claim.title = trial.claim.statement = trial.claim.source = trial.command = hostile;
  trial.judgement.quantity = hostile;
  trial.judgement.lines = {hostile};
  trial.judgement.figures = {{hostile, {hostile}, {hostile}, {{hostile, Mark::points, {datum(1, 1)}}}}};
  fixture.manifest = {{hostile, hostile}, {"build", {{"commit", hostile}, {hostile, hostile}}}};
  const std::string html = own_part(fixture.html());
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_EQ(html.find("<img src=x"), std::string::npos);
  EXPECT_EQ(html.find('\xFF'), std::string::npos);
}

bench::Row timing_row(const char* backend, double wrong, std::vector<double> seconds) {
  bench::Row row = run_row("predicate-timing", 1000, 1, {{"queries", 1000}, {"wrong", wrong}});
  row.cell.backend = backend;
  row.cell.parameters = {{"predicate", "incircle"}, {"family", "degF"}};
  row.seconds = std::move(seconds);
  return row;
}

TEST(Page, shows_no_time_of_wrong_signs) {
  Fixture fixture;
  fixture.rows.push_back(timing_row("adroit", 0, {2e-6, 4e-6, 3e-6}));
  fixture.rows.push_back(timing_row("hasty", 250, {}));
  fixture.rows.push_back(timing_row("shy", 0, {}));
  fixture.rows.back().outcome = "out_of_domain";
  const std::string html = fixture.html();
  EXPECT_NE(html.find("<td>adroit</td><td class=\"number\">3.00</td>"), std::string::npos);
  EXPECT_NE(html.find("<td>hasty</td><td class=\"number\">!0.25</td>"), std::string::npos);
  EXPECT_NE(html.find("<td>shy</td><td class=\"absent\">refused</td>"), std::string::npos);
  EXPECT_EQ(unbalanced(own_part(html)), "");
}

TEST(Page, of_nothing_is_a_page_too) {
  const std::string html = page({nullptr, {}, {}});
  EXPECT_EQ(unbalanced(own_part(html)), "");
  EXPECT_NE(html.find("0 claims"), std::string::npos);
  EXPECT_NE(html.find("Every run ended ok"), std::string::npos);
}

TEST(Page, a_surprise_is_shouted) {
  Fixture fixture;
  EXPECT_EQ(fixture.html().find("against the registered expectation"), std::string::npos);
  fixture.trials[0].claim.expected = Verdict::refuted;
  EXPECT_NE(fixture.html().find("1 against the registered expectation"), std::string::npos);
}

TEST(Page, says_of_claims_that_were_not_tried_nothing_but_that) {
  const Fixture fixture;
  const Tried untried{claim_of("scope-identities"), try_claim(claim_of("scope-identities"), {}), ""};
  Tried tried = untried;
  tried.judgement.verdict = Verdict::reproduced;
  const auto says = [&](const std::vector<Tried>& trials, const char* what) {
    return page({fixture.manifest, fixture.rows, trials}).find(what) != std::string::npos;
  };
  EXPECT_FALSE(says({untried, untried}, "registered beforehand"));
  EXPECT_FALSE(says({untried}, "class=\"tile") || says({untried}, "class=\"claims"));
  EXPECT_TRUE(says({tried, untried}, "class=\"tile") && says({tried, untried}, "class=\"claims"));
  EXPECT_TRUE(says({untried}, "lack some of their cells: ") &&
              says({tried, untried}, "some of their cells: "));
  EXPECT_FALSE(says({tried, tried}, "some of their cells: "));
  EXPECT_TRUE(says({tried, untried}, "all that were tried as registered beforehand"));
  EXPECT_TRUE(says({tried, tried}, "<strong>all as registered beforehand"));
}

}  // namespace
}  // namespace tribunal::reports
