// The folder of a run: rows that survive anything that happens between two of them.
#pragma once

#include "bench/row.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tribunal::bench {

/// All rows of a run folder, in order of file name and line. Reads only. A last line without its newline is a
/// write that did not finish and is left out; any other line that is no row of this schema, or whose key does
/// not match its cell, is BadInput "file:line: reason". Of several rows with one key the first stands, unless
/// a later one is deterministic (digest.hpp) and it is not; two deterministic rows that disagree are
/// BadInput.
std::vector<Row> read_rows(const std::filesystem::path& folder);

/// The same over several folders as if they were one.
std::vector<Row> read_rows(std::span<const std::string> folders);

/// A run folder held for writing: no other process can open it while this lives.
class RunFolder {
 public:
  enum class Mode { fresh, resume };

  /// Creates the folder as needed and locks it. Fresh: BadInput when it holds rows already. Resume: reads the
  /// rows and cuts off a torn last line. BadInput also when another process holds the folder or it cannot be
  /// written.
  RunFolder(std::filesystem::path folder, Mode mode);
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder();

  const std::filesystem::path& path() const { return folder_; }
  /// What the folder held when it was opened, and what was appended since.
  const std::vector<Row>& rows() const { return rows_; }

  /// Appends a line per row by one write and waits until they are on the disk. Throws std::system_error when
  /// they are not, after taking back what was written of them.
  void append(std::span<const Row> rows);

 private:
  std::filesystem::path folder_;
  std::vector<Row> rows_;
  int lock_ = -1;
  int file_ = -1;
};

}  // namespace tribunal::bench
