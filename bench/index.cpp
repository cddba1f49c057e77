#include "bench/index.hpp"

#include <sqlite3.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace tribunal::bench {
namespace {

constexpr const char* schema = R"(
  PRAGMA journal_mode = OFF;
  CREATE TABLE cells(key TEXT PRIMARY KEY, task TEXT, backend TEXT, dataset TEXT, n INTEGER, bits INTEGER,
    seed INTEGER, order_seed INTEGER, "order" TEXT, measure TEXT, repeats INTEGER, outcome TEXT, reason TEXT,
    peak_bytes INTEGER, digest TEXT, command TEXT) WITHOUT ROWID;
  CREATE TABLE counters(key TEXT, name TEXT, value REAL, PRIMARY KEY(key, name)) WITHOUT ROWID;
  CREATE TABLE texts(key TEXT, name TEXT, value TEXT, PRIMARY KEY(key, name)) WITHOUT ROWID;
  CREATE TABLE parameters(key TEXT, name TEXT, value TEXT, PRIMARY KEY(key, name)) WITHOUT ROWID;
  CREATE TABLE seconds(key TEXT, sample INTEGER, value REAL, PRIMARY KEY(key, sample)) WITHOUT ROWID;
  CREATE INDEX cells_by_task ON cells(task, backend, dataset, n);
  CREATE INDEX counters_by_name ON counters(name);
  BEGIN;
)";

class Database {
 public:
  explicit Database(const std::filesystem::path& path) {
    sqlite3* opened = nullptr;
    const int status = sqlite3_open(path.c_str(), &opened);
    handle_.reset(opened);
    check(status);
  }
  void execute(const char* statements) {
    check(sqlite3_exec(handle_.get(), statements, nullptr, nullptr, nullptr));
  }
  void check(int status) const {
    if (status != SQLITE_OK && status != SQLITE_DONE)
      throw std::runtime_error(std::string("index: ") + sqlite3_errmsg(handle_.get()));
  }
  sqlite3* get() const { return handle_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close(handle); }
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

/// INSERT INTO table VALUES (?, ...), prepared once. The database must outlive it.
class Insertion {
 public:
  Insertion(const Database& database, const std::string& table, int columns) : database_(database) {
    std::string statement = "INSERT INTO " + table + " VALUES (?";
    for (int i = 1; i < columns; ++i) statement += ",?";
    sqlite3_stmt* prepared = nullptr;
    database_.check(sqlite3_prepare_v2(database_.get(), (statement + ")").c_str(), -1, &prepared, nullptr));
    statement_.reset(prepared);
  }
  template <class... Values>
  void add(const Values&... values) {
    int column = 0;
    (bind(++column, values), ...);
    database_.check(sqlite3_step(statement_.get()));
    database_.check(sqlite3_reset(statement_.get()));
  }

 private:
  template <class Value>
  void bind(int column, const Value& value) {
    if constexpr (std::is_integral_v<Value>)
      database_.check(sqlite3_bind_int64(statement_.get(), column, static_cast<sqlite3_int64>(value)));
    else if constexpr (std::is_floating_point_v<Value>)
      database_.check(sqlite3_bind_double(statement_.get(), column, value));
    else
      database_.check(sqlite3_bind_text(statement_.get(), column, value.c_str(), -1, SQLITE_TRANSIENT));
  }

  struct Finalise {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  const Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalise> statement_;
};

void insert_rows(const Database& database, std::span<const Row> rows) {
  Insertion cells(database, "cells", 16), counters(database, "counters", 3), texts(database, "texts", 3),
      parameters(database, "parameters", 3), seconds(database, "seconds", 3);
  for (const Row& row : rows) {
    const Cell& c = row.cell;
    const std::string measure = c.measure == Measure::time ? "time" : "counts";
    cells.add(row.key, c.task, c.backend, c.dataset, c.n, c.bits, c.seed, c.order_seed, c.order, measure,
              c.repeats, row.outcome, row.reason, row.peak_bytes, row.digest, row.command);
    for (const auto& [name, value] : row.counters) counters.add(row.key, name, value);
    for (const auto& [name, value] : row.texts) texts.add(row.key, name, value);
    for (const auto& [name, value] : c.parameters) parameters.add(row.key, name, value);
    for (std::size_t i = 0; i < row.seconds.size(); ++i) seconds.add(row.key, i, row.seconds[i]);
  }
}

}  // namespace

void write_index(const std::filesystem::path& path, std::span<const Row> rows) {
  std::filesystem::path unfinished = path;
  unfinished += ".unfinished";
  std::filesystem::remove(unfinished);
  {
    Database database(unfinished);
    database.execute(schema);
    insert_rows(database, rows);
    database.execute("COMMIT");
  }
  std::filesystem::rename(unfinished, path);
}

}  // namespace tribunal::bench
