// Laws of the house: which room may include which, and that whatever stands in a listed folder is listed.
#include "tests/meta/sources.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {
using namespace tribunal::meta;

bool starts_with_any(const std::string& text, const std::vector<std::string>& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(), [&](const auto& p) { return text.rfind(p, 0) == 0; });
}

/// Examples are an outsider's, who has copied a header.
bool is_example(const Source& source) { return source.path.find("/examples/") != std::string::npos; }

TEST(Architecture, ArrowsRunDownwards) {
  const std::map<std::string, std::vector<std::string>> may_include{
      {"predicates", {"predicates/"}},
      {"algorithms", {"algorithms/", "predicates/", "datasets/random.hpp"}},
      {"datasets", {"datasets/", "predicates/"}},
      {"bench", {"bench/", "algorithms/", "datasets/", "predicates/"}},
      {"reports", {"reports/", "bench/row.hpp", "bench/statistics.hpp"}},
      {"cli", {"cli/", "reports/", "bench/", "algorithms/", "datasets/", "predicates/"}},
  };
  for (const std::string room : rooms) {
    std::size_t seen = 0;
    for (const Source& source : sources_of(room))
      for (const std::string& include : source.includes) {
        if (is_example(source)) continue;
        ++seen;
        EXPECT_TRUE(starts_with_any(include, may_include.at(room))) << source.path << " includes " << include;
        EXPECT_TRUE(fs::exists(root / include))
            << source.path << " includes " << include << ", which is not written from the root";
      }
    EXPECT_GT(seen, 0U) << room << " holds no includes: the test looks in the wrong place";
  }
}

/// A room's folder, and those that its files include; not those inside it or around it: a list at the top of
/// a room names what stands in it.
std::map<std::string, std::set<std::string>> arrows_between_rooms() {
  std::map<std::string, std::set<std::string>> arrows;
  const auto folder = [](const std::string& path) { return path.substr(0, path.rfind('/')); };
  const auto holds = [](const std::string& outer, const std::string& inner) {
    return inner == outer || inner.rfind(outer + "/", 0) == 0;
  };
  for (const std::string room : rooms)
    for (const Source& source : sources_of(room))
      for (const std::string& include : source.includes) {
        const std::string from = folder(source.path), to = folder(include);
        if (!is_example(source) && !holds(from, to) && !holds(to, from)) arrows[from].insert(to);
      }
  return arrows;
}

/// Rooms that include no other are put aside, and so on; circles are left.
TEST(Architecture, RoomsFormNoCircles) {
  auto arrows = arrows_between_rooms();
  ASSERT_GE(arrows.size(), 15U);
  for (bool less = true; less;) {
    less = false;
    for (auto& [from, to] : arrows)
      less |= std::erase_if(to, [&](const std::string& room) {
                const auto found = arrows.find(room);
                return found == arrows.end() || found->second.empty();
              }) > 0;
  }
  for (const auto& [from, to] : arrows)
    for (const std::string& room : to)
      ADD_FAILURE() << from << " -> " << room << " is part of a circle or leads to one";
}

TEST(Architecture, TheCheckerSharesNoCodeWithWhatItChecks) {
  for (const Source& source : sources_of("algorithms/verify"))
    for (const std::string& include : source.includes)
      EXPECT_TRUE(
          starts_with_any(include, {"algorithms/verify/", "predicates/sign.hpp", "predicates/point.hpp"}))
          << source.path << " includes " << include;
}

/// What outsiders can do without this project's code, examples and peers do.
TEST(Architecture, OutsidersSeeThePluginHeadersOnly) {
  const std::vector<std::string> headers{"predicates/plugin/tribunal_predicates.h",
                                         "algorithms/plugin/tribunal_triangulator.h",
                                         "algorithms/plugin/tribunal_mesher.h"};
  for (const std::string& header : headers)
    EXPECT_EQ(read(root / header).find("#include \""), std::string::npos);
  std::size_t examples = 0, peers = 0;
  for (const std::string room : rooms)
    for (const Source& source : sources_of(room))
      if (is_example(source)) {
        ++examples;
        EXPECT_EQ(source.includes.size(), 1U) << source.path << " needs one header alone";
      }
  const std::string list = read(root / "algorithms/peers/list.def");
  for (const Source& source : sources_of("algorithms/peers")) {
    for (const std::string& include : source.includes)
      EXPECT_TRUE(include.rfind("algorithms/peers/", 0) == 0 ||
                  std::find(headers.begin(), headers.end(), include) != headers.end())
          << source.path << " includes " << include;
    if (fs::path(source.path).extension() != ".cpp") continue;
    ++peers;
    EXPECT_NE(list.find("PEER(" + fs::path(source.path).stem().string() + ")"), std::string::npos)
        << source.path << " is not listed";
  }
  EXPECT_GE(examples, 1U);
  EXPECT_GE(peers, 2U);
}

TEST(Architecture, MeshFilesDecideNothing) {
  for (const Source& source : sources_of("algorithms/mesh"))
    for (const std::string& include : source.includes)
      EXPECT_EQ(include.rfind("predicates/", 0), std::string::npos) << source.path << " includes " << include;
}

/// Listed files stand side by side: what two of them share is an unlisted file.
TEST(Architecture, BackendsDoNotIncludeEachOther) {
  const std::string list = "predicates/backends/all.hpp";
  std::set<std::string> listed;
  for (const Source& source : sources_of("predicates/backends"))
    if (source.path == list) listed.insert(source.includes.begin(), source.includes.end());
  ASSERT_GE(listed.size(), 7U);
  for (const Source& source : sources_of("predicates/backends"))
    for (const std::string& include : source.includes)
      EXPECT_TRUE(source.path == list || !listed.count(include))
          << source.path << " includes the listed " << include;
}

/// What defines an entry is named in the list of its folder.
TEST(Architecture, EntriesAreListed) {
  for (const auto& [folder, mark, list, page] : all_entries) {
    const std::string listed = read(root / list);
    const bool by_include = fs::path(list).extension() == ".hpp";  // else by its name alone
    std::size_t found = 0;
    for (const Source& source : sources_of(folder)) {
      if (source.text.find(mark) == std::string::npos) continue;
      ++found;
      const std::string line =
          by_include ? "#include \"" + source.path + "\"" : "(" + fs::path(source.path).stem().string() + ")";
      EXPECT_NE(listed.find(line), std::string::npos) << source.path << " is not in " << list;
    }
    EXPECT_GE(found, 3U) << folder;
  }
}

TEST(Architecture, EverySourceIsCompiled) {
  for (const std::string room : rooms) {
    std::string lists;
    for (const auto& entry : fs::recursive_directory_iterator(root / room))
      if (entry.path().filename() == "CMakeLists.txt" || entry.path().extension() == ".cmake" ||
          entry.path().extension() == ".def")
        lists += read(entry.path());
    for (const Source& source : sources_of(room)) {
      if (source.path.substr(source.path.rfind('.')) != ".cpp") continue;
      const std::string name = fs::path(source.path).stem().string();
      const std::regex listed("[ /\n(]" + name + "(\\.cpp\\b|\\))");
      EXPECT_TRUE(std::regex_search(lists, listed)) << source.path << " is in no list of its room";
    }
  }
}

TEST(Architecture, ForbiddenThings) {
  const std::regex random(
      "std::(uniform_|normal_distribution|shuffle|default_random_engine|mt19937)|[^a-z_:]rand\\(");
  const std::regex undone("\\b(TODO|FIXME|XXX|HACK)\\b");
  const std::regex unsafe_flags("-ffast-math|-Ofast|-funsafe-math");
  for (const std::string room : rooms)
    for (const Source& source : sources_of(room)) {
      const std::string code = std::regex_replace(source.text, std::regex("//[^\n]*"), "");
      EXPECT_FALSE(std::regex_search(code, random))
          << source.path << ": random numbers that differ by library";
      EXPECT_FALSE(std::regex_search(source.text, undone)) << source.path << ": left undone";
      EXPECT_TRUE(source.text.find("CLI/") == std::string::npos || source.path == "cli/main.cpp")
          << source.path << ": CLI11 belongs in cli/main.cpp";
    }
  EXPECT_FALSE(std::regex_search(read(root / "CMakeLists.txt"), unsafe_flags));
}

}  // namespace
