// The rows of a run as an SQLite database, for questions.
#pragma once

#include "bench/row.hpp"

#include <filesystem>
#include <span>

namespace tribunal::bench {

/// Writes `rows` into a database of its own at `path`, replacing what is there in one step. Derived: it can
/// be deleted and rebuilt at any time. Tables: cells(key, task, backend, ..., outcome, reason, peak_bytes,
/// digest, command), one row each; and by key counters(name, value), texts(name, value), parameters(name,
/// value), seconds(sample, value). Throws std::runtime_error when SQLite cannot write.
void write_index(const std::filesystem::path& path, std::span<const Row> rows);

}  // namespace tribunal::bench
