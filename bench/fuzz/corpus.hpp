// Hard cases on disk: one small text file each.
#pragma once

#include "bench/fuzz/case.hpp"
#include "predicates/sign.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tribunal::bench::fuzz {

/// A case worth asking again, with its true sign.
struct CorpusEntry {
  Case asked;
  Sign exact;
};

// An entry is a text file of these lines, in this order; `#` begins a comment:
//
//   predicate orient2d           or incircle, orient3d, insphere
//   exact +                      or -, 0
//   point 0x1p+0 0x0p+0          one line per point, two or three numbers: hexadecimal, decimal or integer
//
// It is named after the hash of its bytes, "0123456789abcdef.query": the same case is kept once.

/// The text of an entry, and the name of the file that holds it.
std::string corpus_text(const CorpusEntry& entry);
std::string corpus_name(const CorpusEntry& entry);

/// Reads the text of one entry; `name` is the file's in messages. Throws BadInput with file and line: what is
/// no entry, and an entry whose sign is not the exact one.
CorpusEntry parse_corpus_entry(const std::string& name, const std::string& text);

/// Every *.query file of the folder, in order of their names; none when there is no such folder. Throws
/// BadInput.
std::vector<CorpusEntry> load_corpus(const std::filesystem::path& folder);

/// Writes the entry into the folder, which is made when it is missing; returns the file. Throws BadInput.
std::filesystem::path save_to_corpus(const std::filesystem::path& folder, const CorpusEntry& entry);

}  // namespace tribunal::bench::fuzz
