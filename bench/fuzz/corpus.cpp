#include "bench/fuzz/corpus.hpp"

#include "bench/fuzz/hex_float.hpp"
#include "bench/fuzz/oracle.hpp"
#include "bench/hash.hpp"
#include "datasets/files/files.hpp"
#include "datasets/files/scanner.hpp"
#include "datasets/files/text.hpp"

#include <algorithm>
#include <array>
#include <system_error>

namespace tribunal::bench::fuzz {
namespace {
namespace fs = std::filesystem;

constexpr std::string_view ending = ".query";

void expect_keyword(Scanner& scanner, std::string_view keyword) {
  if (!scanner.next_line()) scanner.refuse_file("ends before a line '" + std::string(keyword) + "'");
  const auto place = scanner.place();
  if (scanner.field(keyword) != keyword) scanner.refuse_at(place, "expected '" + std::string(keyword) + "'");
}

Predicate read_predicate(Scanner& scanner) {
  expect_keyword(scanner, "predicate");
  const std::string_view name = scanner.field("predicate's name");
  for (const Predicate predicate : all_predicates)
    if (name == to_string(predicate)) return predicate;
  scanner.refuse("there is no predicate " + in_quotes(name));
}

Sign read_sign(Scanner& scanner) {
  expect_keyword(scanner, "exact");
  const std::string_view text = scanner.field("sign");
  for (const Sign sign : {Sign::negative, Sign::zero, Sign::positive})
    if (text == std::string(1, to_char(sign))) return sign;
  scanner.refuse(in_quotes(text) + " is no sign: +, - or 0");
}

}  // namespace

std::string corpus_text(const CorpusEntry& entry) {
  std::string text =
      "predicate " + std::string(to_string(entry.asked.predicate)) + "\nexact " + to_char(entry.exact) + "\n";
  for (int i = 0; i < entry.asked.points(); ++i) {
    text += "point";
    for (const double c : entry.asked.point(i)) text += " " + hex_float(c);
    text += "\n";
  }
  return text;
}

std::string corpus_name(const CorpusEntry& entry) {
  return hash_hex(corpus_text(entry)) + std::string(ending);
}

CorpusEntry parse_corpus_entry(const std::string& name, const std::string& text) {
  Scanner scanner(name, text);
  CorpusEntry entry{};
  entry.asked.predicate = read_predicate(scanner);
  scanner.expect_end_of_line();
  entry.exact = read_sign(scanner);
  scanner.expect_end_of_line();
  const std::uint64_t sign_line = scanner.line();
  for (int i = 0; i < entry.asked.points(); ++i) {
    expect_keyword(scanner, "point");
    for (double& c : entry.asked.point(i)) c = scanner.number("coordinate");
    scanner.expect_end_of_line();
  }
  if (scanner.next_line())
    scanner.refuse_line(scanner.line(), std::string(to_string(entry.asked.predicate)) + " takes " +
                                            std::to_string(entry.asked.points()) + " points");
  if (const Sign truth = exact_sign(entry.asked); truth != entry.exact)
    scanner.refuse_line(sign_line, std::string("the exact sign is ") + to_char(truth));
  return entry;
}

std::vector<CorpusEntry> load_corpus(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found) return {};
  if (!fs::is_directory(status)) throw BadInput(name_of(folder) + ": a corpus is a folder");
  std::vector<fs::path> files;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator();
       at.increment(error))
    if (at->path().extension() == ending) files.push_back(at->path());
  if (error) throw BadInput(name_of(folder) + ": " + error.message());
  std::sort(files.begin(), files.end());
  std::vector<CorpusEntry> entries;
  for (const fs::path& file : files) {
    if (!fs::is_regular_file(file, error))
      throw BadInput(name_of(file) + ": no regular file");  // a pipe hangs
    entries.push_back(parse_corpus_entry(file.string(), read_text(file)));
  }
  return entries;
}

fs::path save_to_corpus(const fs::path& folder, const CorpusEntry& entry) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw BadInput(name_of(folder) + ": " + error.message());
  fs::path file = folder / corpus_name(entry);
  write_text(file, corpus_text(entry));
  return file;
}

}  // namespace tribunal::bench::fuzz
