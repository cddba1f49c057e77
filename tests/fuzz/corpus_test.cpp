// Laws of the corpus: what is written is read back, and what is no entry is refused with file and line.
#include "bench/fuzz/corpus.hpp"

#include "bench/fuzz/batch.hpp"
#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/hex_float.hpp"
#include "bench/fuzz/oracle.hpp"
#include "datasets/files/files.hpp"
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>

namespace tribunal::bench::fuzz {
namespace {
using cli::Folder;

TEST(HexFloats, ReadBackToTheSameBits) {
  Random random(1);
  std::vector<double> numbers{0.0, -0.0, 1.0, -1.5, 0x1p-1074, -0x1.fffffffffffffp+1023, 0x1p-1022, 0.1};
  for (int i = 0; i < 2000; ++i) {
    const double x = std::bit_cast<double>(random.bits());
    if (x - x == 0) numbers.push_back(x);
  }
  for (const double x : numbers)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(hex_float(x).c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(x))
        << hex_float(x);
  EXPECT_EQ(hex_float(-0.75), "-0x1.8p-1");
  EXPECT_EQ(hex_float(0), "0x0p+0");
}

TEST(Corpus, WhatIsSavedIsLoadedInOrderOfNames) {
  const Folder folder;
  std::map<std::string, std::string> saved;  // file -> query
  for (std::uint64_t index = 0; index < 12; ++index) {
    const Case asked = draw_batch(3, index, all_predicates[index % 4], Pool{}, 1).cases[0];
    const CorpusEntry entry{asked, exact_sign(asked)};
    const auto file = save_to_corpus(folder / "corpus", entry);
    EXPECT_EQ(file.filename().string(), corpus_name(entry));
    EXPECT_EQ(save_to_corpus(folder / "corpus", entry), file) << "the same case is kept once";
    saved[file.string()] = query_text(asked);
  }
  folder.write("corpus/notes.txt", "not an entry, and none of our business");
  const auto loaded = load_corpus(folder / "corpus");
  ASSERT_EQ(loaded.size(), saved.size());
  auto expected = saved.begin();
  for (const CorpusEntry& entry : loaded) EXPECT_EQ(query_text(entry.asked), (expected++)->second);
}

TEST(Corpus, IsEmptyWhereThereIsNoFolder) {
  const Folder folder;
  EXPECT_TRUE(load_corpus(folder / "absent").empty());
}

TEST(Corpus, NumbersMayBeWrittenByHand) {
  const CorpusEntry entry = parse_corpus_entry(
      "x", "# a line\npredicate orient2d\n\nexact -\npoint 0 0\npoint 1 1e0\npoint 2 0x1.8p+0\n");
  EXPECT_EQ(entry.exact, Sign::negative);
  EXPECT_EQ(query_text(entry.asked), "orient2d 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+1 0x1.8p+0");
}

TEST(Corpus, BadEntriesAreRefusedWithTheirLine) {
  struct Bad {
    const char *text, *message;
  };
  const Bad bad[] = {
      {"", "x: ends before a line 'predicate'"},
      {"predicate\n", "x:1:"},
      {"query orient2d\n", "x:1:1: expected 'predicate'"},
      {"predicate handedness\n", "x:1:11: there is no predicate"},
      {"predicate orient2d twice\n", "x:1:"},
      {"predicate orient2d\n", "x: ends before a line 'exact'"},
      {"predicate orient2d\nexact plus\n", "x:2:7:"},
      {"predicate orient2d\nexact +\npoint 0 0\npoint 1 0\n", "x: ends before a line 'point'"},
      {"predicate orient2d\nexact +\npoint 0\npoint 1 0\npoint 0 1\n", "x:3"},
      {"predicate orient2d\nexact +\npoint 0 0\npoint 1 nan\npoint 0 1\n", "x:4:9:"},
      {"predicate orient2d\nexact +\npoint 0 0\npoint 1 0 0\npoint 0 1\n", "x:4:"},
      {"predicate orient2d\nexact +\npoint 0 0\npoint 1 0\npoint 0 1\npoint 1 1\n",
       "x:6: orient2d takes 3 points"},
      {"predicate orient2d\nexact -\npoint 0 0\npoint 1 0\npoint 0 1\n", "x:2: the exact sign is +"},
  };
  for (const auto& [text, message] : bad) {
    try {
      parse_corpus_entry("x", text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const BadInput& error) {
      EXPECT_EQ(std::string(error.what()).rfind(message, 0), 0U) << error.what() << " is not " << message;
    }
  }
}

TEST(Corpus, AFileIsNoFolder) {
  const Folder folder;
  EXPECT_THROW(load_corpus(folder.write("corpus", "text")), BadInput);
}

}  // namespace
}  // namespace tribunal::bench::fuzz
