// tribunal fuzz as a user meets it: statuses, documents, files, and the same bytes for the same request.
#include "tests/cli/program.hpp"
#include "tests/cli/schema.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <sys/stat.h>

namespace tribunal::cli {
namespace {

nlohmann::json fuzz_schema() {
  return nlohmann::json::parse(read(std::string(TRIBUNAL_SOURCE_DIR) + "/cli/schemas/fuzz.schema.json"));
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// By value: a loop over a temporary's member would outlive it.
nlohmann::json counterexamples_of(const Ended& ended) { return ended.json().at("counterexamples"); }

TEST(FuzzCommand, AWrongBackendThatWasNamedIsStatusOne) {
  for (const char* backend : {"double", "double-fma", "float", "knuth-as-printed"}) {
    const Ended ended = tribunal({"fuzz", "--backend", backend, "--queries", "20000", "--json"});
    EXPECT_EQ(ended.status, 1) << backend << ended.err;
    EXPECT_EQ(schema_fault(fuzz_schema(), ended.json()), "") << backend;
    EXPECT_FALSE(ended.json()["counterexamples"].empty()) << backend;
  }
}

TEST(FuzzCommand, WithoutNamesOnlyExactBackendsCount) {
  const Ended ended = tribunal({"fuzz", "--queries", "20000", "--json"});
  EXPECT_EQ(ended.status, 0) << ended.out;
  EXPECT_EQ(schema_fault(fuzz_schema(), ended.json()), "");
  EXPECT_EQ(ended.json()["checked"], 20000);
  for (const auto& counterexample : counterexamples_of(ended))
    EXPECT_NE(counterexample["backend"], "filtered") << counterexample;
  EXPECT_FALSE(ended.json()["counterexamples"].empty()) << "double is wrong and shown, but promises nothing";
}

TEST(FuzzCommand, AtMostOneCounterexamplePerBackendAndPredicate) {
  const auto document = tribunal({"fuzz", "--queries", "20000", "--json"}).json();
  std::set<std::string> seen;
  for (const auto& shown : document["counterexamples"])
    EXPECT_TRUE(seen.insert(shown["backend"].dump() + shown["predicate"].dump()).second) << shown;
}

TEST(FuzzCommand, TheReplayRepeatsTheWrongSign) {
  const auto document = tribunal({"fuzz", "--backend", "double", "--queries", "20000", "--json"}).json();
  EXPECT_EQ(document["counterexamples"].size(), 4U);
  for (const auto& shown : document["counterexamples"]) {
    auto words = words_of(shown["replay"]);
    ASSERT_EQ(words[0], "tribunal");
    words.erase(words.begin());
    words.push_back("--json");
    const auto signs = tribunal(words).json()["signs"];
    EXPECT_EQ(signs[0]["backend"], "double");
    EXPECT_EQ(signs[0]["sign"], shown["got"]);
    EXPECT_EQ(signs[1]["backend"], "gmp");
    EXPECT_EQ(signs[1]["sign"], shown["exact"]);
  }
}

TEST(FuzzCommand, SameRequestSameBytes) {
  for (const bool json : {false, true}) {
    std::vector<std::string> words{"fuzz", "--queries", "15000", "--seed", "9"};
    if (json) words.push_back("--json");
    const Ended once = tribunal(words), again = tribunal(words);
    EXPECT_EQ(once.out, again.out);
    words[4] = "10";
    EXPECT_NE(tribunal(words).out, once.out);
  }
}

TEST(FuzzCommand, TimeEndsIt) {
  const Ended ended = tribunal({"fuzz", "--backend", "gmp", "--seconds", "0.2", "--json"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_GE(ended.json()["seconds"].get<double>(), 0.2);
  EXPECT_GT(ended.json()["checked"], 0);
}

TEST(FuzzCommand, CounterexamplesAreKeptAndAskedFirst) {
  const Folder folder;
  const std::string corpus = folder / "corpus";
  const auto first =
      tribunal({"fuzz", "--backend", "double", "--queries", "20000", "--corpus", corpus, "--json"});
  ASSERT_EQ(first.status, 1);
  std::set<std::string> files;
  for (const auto& shown : counterexamples_of(first)) {
    files.insert(shown["file"].get<std::string>());
    EXPECT_TRUE(std::filesystem::exists(shown["file"].get<std::string>()));
  }
  EXPECT_EQ(files.size(), 4U);
  const auto replayed =
      tribunal({"fuzz", "--backend", "double", "--queries", "0", "--corpus", corpus, "--json"});
  EXPECT_EQ(replayed.status, 1);
  EXPECT_EQ(replayed.json()["checked"], 8);
  for (const auto& shown : counterexamples_of(replayed)) EXPECT_EQ(shown["source"], "corpus");
  EXPECT_EQ(tribunal({"fuzz", "--backend", "filtered", "--queries", "0", "--corpus", corpus}).status, 0);
}

TEST(FuzzCommand, ABadCorpusFileIsRefusedByFileAndLine) {
  const Folder folder;
  const std::string bad =
      folder.write("bad.query", "predicate orient2d\nexact -\npoint 0 0\npoint 1 0\npoint 0 1\n");
  const Ended ended = tribunal({"fuzz", "--queries", "100", "--corpus", folder / ""});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
  EXPECT_EQ(ended.err.rfind("tribunal: " + bad + ":2:", 0), 0U) << ended.err;
  EXPECT_TRUE(ended.out.empty());
}

TEST(FuzzCommand, PicturesAreDrawnOfEveryCounterexample) {
  const Folder folder;
  const auto ended = tribunal(
      {"fuzz", "--backend", "double", "--queries", "20000", "--picture", folder / "pictures", "--json"});
  ASSERT_EQ(ended.json()["counterexamples"].size(), 4U) << ended.err;
  for (const auto& shown : counterexamples_of(ended)) {
    const std::string svg = read(shown["picture"].get<std::string>());
    EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_TRUE(svg.find("#cc3311") != svg.npos || svg.find("#000000") != svg.npos ||
                svg.find("#009988") != svg.npos)
        << "no wrong pixel in " << shown["picture"];
  }
}

TEST(FuzzCommand, MistakesAreToldInOneLineWithStatusTwo) {
  const std::vector<std::vector<std::string>> mistakes{
      {"--backend", "oracle"},
      {"--predicate", "handedness"},
      {"--seconds", "0"},
      {"--seconds", "-1"},
      {"--seconds", "long"},
      {"--seconds", "nan"},
      {"--seconds", "inf"},
      {"--seconds", "1e300"},
      {"--corpus", ""},
      {"--plugin", ""},
      {"--picture", "/proc/nowhere"},
      {"--queries", "-1"},
      {"--queries", "1e3"},
      {"--seed", "x"},
      {"--oracle", "delphi"},
      {"--plugin", "/no/such.so"},
      {"--corpus", "/dev/null"},
      {"--progress", "loud"},
      {"--backend", "knuth", "--predicate", "insphere"},
  };
  for (auto words : mistakes) {
    words.insert(words.begin(), "fuzz");
    words.insert(words.end(), {"--queries", "10"});
    const Ended ended = tribunal(words);
    EXPECT_EQ(ended.status, 2) << words[1] << ' ' << words[2] << ended.out;
    EXPECT_TRUE(ended.one_line_error()) << words[1] << ' ' << words[2] << "\n" << ended.err;
    EXPECT_TRUE(ended.out.empty());
  }
}

TEST(FuzzCommand, NothingJudgedIsNoSuccess) {
  const std::vector<std::vector<std::string>> all{
      {"--backend", "knuth", "--predicate", "incircle", "--queries", "200"},
      {"--backend", "gmp", "--seconds", "1e-9"},
      {"--queries", "0"},
  };
  for (auto words : all) {
    words.insert(words.begin(), "fuzz");
    words.insert(words.end(), {"--seed", "1", "--json"});
    const Ended ended = tribunal(words);
    EXPECT_EQ(ended.status, 2) << words[1] << ' ' << words[2] << ended.out;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
    EXPECT_EQ(schema_fault(fuzz_schema(), ended.json()), "");
  }
}

TEST(FuzzCommand, NamedTwiceIsAskedOnce) {
  const std::vector<std::string> once{"fuzz",     "--backend", "gmp",  "--predicate",
                                      "orient2d", "--queries", "1000", "--json"};
  std::vector<std::string> twice = once;
  twice.insert(twice.end(), {"--backend", "gmp", "--predicate", "orient2d"});
  EXPECT_EQ(tribunal(once).out, tribunal(twice).out);
}

TEST(FuzzCommand, WhatCannotBeKeptIsRefusedBeforeTheHunt) {
  const Folder folder;
  const std::string file = folder.write("file", "");
  for (const char* option : {"--corpus", "--picture"}) {
    const Ended ended = tribunal({"fuzz", "--seconds", "60", option, file + "/sub"});
    EXPECT_EQ(ended.status, 2) << option;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
    EXPECT_TRUE(ended.out.empty());
  }
}

TEST(FuzzCommand, WhatWasFoundIsPrintedWhereItCannotBeKept) {
  const Folder folder;
  for (const char* predicate : {"orient2d", "incircle", "orient3d", "insphere"})
    std::filesystem::create_directories(folder / (std::string("pictures/double-") + predicate + ".svg/full"));
  const Ended ended = tribunal(
      {"fuzz", "--backend", "double", "--queries", "20000", "--picture", folder / "pictures", "--json"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
  EXPECT_EQ(ended.json()["counterexamples"].size(), 4U);
}

TEST(FuzzCommand, CorpusEntriesAreRegularFiles) {
  const Folder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.query").c_str(), 0600), 0);
  const Ended ended = tribunal({"fuzz", "--queries", "100", "--corpus", folder / ""});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("pipe.query: no regular file"), std::string::npos) << ended.err;
}

TEST(FuzzCommand, TimeEndsALongCorpus) {
  const Folder folder;
  for (int i = 0; i < 300; ++i)
    folder.write(std::to_string(i) + ".query", "predicate orient2d\nexact +\npoint 0 0\npoint 1 0\npoint 0 " +
                                                   std::to_string(i + 1) + "\n");
  const auto document = tribunal({"fuzz", "--seconds", "0.000001", "--corpus", folder / "", "--json"}).json();
  EXPECT_LT(document["checked"], 600);
}

TEST(FuzzCommand, ProgressGoesToStandardErrorOnly) {
  const Ended ended =
      tribunal({"fuzz", "--backend", "gmp", "--queries", "1000", "--json", "--progress", "none"});
  EXPECT_TRUE(ended.err.empty()) << ended.err;
  EXPECT_EQ(ended.json()["checked"], 1000);
}

}  // namespace
}  // namespace tribunal::cli
