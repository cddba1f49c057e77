// Laws of the pages: what users can name stands in docs/, and every page is found.
#include "tests/meta/sources.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {
using namespace tribunal::meta;

struct Entry {
  std::string name;  // as users type it
  std::string text;  // of the file that defines it
};

/// The first string behind the mark, in each file that has the mark.
std::vector<Entry> entries_of(const Entries& of) {
  std::vector<Entry> entries;
  for (const Source& source : sources_of(of.folder)) {
    const std::size_t mark = source.text.find(of.mark);
    if (mark == std::string::npos) continue;
    const std::size_t begin = source.text.find('"', mark) + 1;
    entries.push_back({source.text.substr(begin, source.text.find('"', begin) - begin), source.text});
  }
  return entries;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string in_backquotes(const std::string& name) { return "`" + name + "`"; }

/// The cells of the table rows that have the name in their first one.
std::vector<std::vector<std::string>> rows_of(const std::string& page, const std::string& name) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| ", 0) != 0 || !has(line, in_backquotes(name))) continue;
    const auto cells = matches(line, "\\| ?([^|]*?) ?(?=\\|)");
    if (has(cells[0], in_backquotes(name))) rows.push_back(cells);
  }
  return rows;
}

TEST(Docs, EntriesStandOnTheirPages) {
  for (const Entries& of : all_entries) {
    const std::string page = read(root / of.page), list = read(root / of.list);
    const auto entries = entries_of(of);
    EXPECT_GE(entries.size(), 3U) << of.folder;
    if (fs::path(of.list).extension() == ".def") {
      EXPECT_EQ(entries.size(), matches(list, "\n[A-Z_]+\\((\\w+)\\)").size()) << of.list;
    }
    for (const Entry& entry : entries)
      EXPECT_TRUE(has(page, in_backquotes(entry.name))) << of.page << " lacks " << in_backquotes(entry.name);
  }
}

/// What is listed otherwise: names by the file that has them.
TEST(Docs, OtherNamesStandOnTheirPages) {
  struct Names {
    std::string_view file, pattern, page;
    std::string suffix;
  };
  const std::array all{
      Names{"algorithms/refiners.cpp", "Refiner\\{\\.name = \"([^\"]+)\"", "docs/algorithms.md", ""},
      Names{"datasets/external/gulf_shores.cpp", "\\.name = \"([^\"]+)\"", "docs/datasets.md", ""},
      Names{"algorithms/peers/list.def", "\nPEER\\((\\w+)\\)", "docs/plugins.md", ".so"},
  };
  for (const auto& [file, pattern, page, suffix] : all) {
    const auto names = matches(read(root / file), std::string(pattern));
    EXPECT_GE(names.size(), 3U) << file;
    for (const std::string& name : names)
      EXPECT_TRUE(has(read(root / page), in_backquotes(name + suffix))) << page << " lacks " << name + suffix;
  }
}

/// Their rows tell which keys they read and name the parameters that are theirs alone.
TEST(Docs, ExperimentsAreTold) {
  const std::string page = read(root / experiments.page);
  for (const auto& [name, text] : entries_of(experiments)) {
    const auto rows = rows_of(page, name);
    ASSERT_EQ(rows.size(), 1U) << experiments.page << " has no row for " << name;
    ASSERT_EQ(rows[0].size(), 4U) << name;
    const auto set = matches(text, "\\.reads = \\{([^}]*)\\}");
    ASSERT_EQ(set.size(), 1U) << name;
    const auto reads = [&](const std::string& key) { return has(set[0], "." + key + " = true"); };
    std::string keys;
    const auto add = [&](const std::string& key) { keys += (keys.empty() ? "" : ", ") + key; };
    if (reads("backend")) add("backend");
    if (reads("dataset")) add("dataset");
    if (reads("dataset") || reads("n")) add("n");
    if (reads("bits")) add("bits");
    if (reads("seed")) add("seed");
    if (reads("order")) add("order, order_seed");
    EXPECT_EQ(rows[0][1], keys) << name;
    for (const std::string& parameter : matches(text, "Parameter \\w+\\{\\s*\\.name = \"([^\"]+)\""))
      EXPECT_TRUE(has(rows[0][2], in_backquotes(parameter))) << name << " has a parameter " << parameter;
  }
}

/// Each in a row, and those with segments in the paragraph about domains.
TEST(Docs, DatasetsAreTold) {
  const std::string page = read(root / datasets.page);
  const auto paragraph = matches(page, "\n(\\*\\*Domains\\.\\*\\*(?:[^\n]+\n)+)");
  ASSERT_EQ(paragraph.size(), 1U);
  std::size_t with_segments = 0;
  for (const auto& [name, text] : entries_of(datasets)) {
    EXPECT_EQ(rows_of(page, name).size(), 1U) << name;
    const bool has_segments = has(text, "    .graph = ");
    with_segments += has_segments;
    EXPECT_EQ(has(paragraph[0], in_backquotes(name)), has_segments) << name;
  }
  EXPECT_GE(with_segments, 10U);
}

/// With their defaults, where the page has a table of them.
TEST(Docs, ParametersAreTold) {
  struct Parameters {
    std::string_view file, page;
    bool with_default;
  };
  const std::array all{
      Parameters{"algorithms/constrained/parameters.hpp", "docs/constrained.md", true},
      Parameters{"algorithms/data_dependent/parameters.hpp", "docs/data-dependent.md", true},
      Parameters{"algorithms/flips/parameters.hpp", "docs/flips.md", true},
      Parameters{"algorithms/planar/green_sibson.cpp", "docs/algorithms.md", false},
      Parameters{"algorithms/planar/green_sibson_minmax.cpp", "docs/flips.md", false},
      Parameters{"algorithms/planar/greedy_naive.cpp", "docs/greedy.md", false},
      Parameters{"algorithms/refinement/chew_parameters.hpp", "docs/refinement.md", true},
      Parameters{"algorithms/refinement/chew_parameters.hpp", "docs/adaptive.md", true},
      Parameters{"algorithms/refinement/adaptive_parameters.hpp", "docs/adaptive.md", true},
      Parameters{"algorithms/stretching/parameters.hpp", "docs/stretched.md", true},
  };
  const std::regex parameter(R"re(\bParameter( \w+)?\{\s*\.name = "([^"]+)",\s*\.summary =\s*"[^"]*",\s*)re"
                             R"re(\.standard = (?:"([^"]+)")?)re");
  for (const auto& [file, name_of_page, with_default] : all) {
    const std::string text = read(root / file), page = read(root / name_of_page);
    std::size_t found = 0;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), parameter); at != std::sregex_iterator();
         ++at) {
      ++found;
      const std::string name = (*at)[2], standard = (*at)[3];
      EXPECT_TRUE(has(page, in_backquotes(name)) || has(page, "--set " + name + "="))
          << name_of_page << " lacks " << name;
      if (!with_default) continue;
      const auto rows = rows_of(page, name);
      ASSERT_EQ(rows.size(), 1U) << name_of_page << " has no row for " << name;
      ASSERT_EQ(rows[0].size(), 4U) << name_of_page << ": " << name;
      if (standard.empty()) continue;  // a constant by its name
      EXPECT_EQ(rows[0][3], standard) << name_of_page << ": the default of " << name;
    }
    EXPECT_EQ(found, matches(text, "(\\bParameter(?: \\w+)?\\{)").size()) << file;
    EXPECT_GE(found, 1U) << file;
  }
}

TEST(Docs, EveryPageIsInTheIndex) {
  const auto linked = matches(read(root / "docs/README.md"), R"(\]\(([^)/]+\.md)\))");
  std::size_t pages = 0;
  for (const auto& entry : fs::directory_iterator(root / "docs")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".md" || name == "README.md") continue;
    ++pages;
    EXPECT_EQ(std::count(linked.begin(), linked.end(), name), 1) << name;
  }
  EXPECT_EQ(pages, linked.size());
  EXPECT_GE(pages, 15U);
  EXPECT_TRUE(has(read(root / "README.md"), "](docs/README.md)"));
}

TEST(Docs, LinksLeadSomewhere) {
  std::vector<fs::path> pages;
  for (const fs::path& folder : {root, root / "docs"})
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".md") pages.push_back(entry.path());
  std::size_t links = 0;
  for (const fs::path& page : pages) {
    const std::string prose = std::regex_replace(read(page), std::regex("```[^`]*```"), "");
    for (const std::string& link : matches(prose, R"(\]\(([^)#: ]+)(?:#[^)]*)?\))")) {
      ++links;
      EXPECT_TRUE(fs::exists(page.parent_path() / link)) << page << " links to " << link;
    }
  }
  EXPECT_GE(links, 40U);
}

}  // namespace
