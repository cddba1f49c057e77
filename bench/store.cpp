#include "bench/store.hpp"

#include "bench/digest.hpp"
#include "datasets/files/files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>
#include <unistd.h>

namespace tribunal::bench {
namespace fs = std::filesystem;
namespace {

constexpr const char* rows_folder = "rows";
constexpr const char* own_file = "local.jsonl";  // where this machine's driver appends

std::vector<fs::path> row_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder / rows_folder, none))
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Row parse_row(const std::string& line) {
  Row row = nlohmann::json::parse(line).get<Row>();
  if (row.key != cell_key(row.cell)) throw std::invalid_argument("the key does not match the cell");
  return row;
}

/// Rows by key in the order of their first appearance.
class Collection {
 public:
  void add(Row row) {
    const auto [place, fresh] = index_.try_emplace(row.key, rows_.size());
    if (fresh) {
      rows_.push_back(std::move(row));
      return;
    }
    Row& known = rows_[place->second];
    if (!is_deterministic(row)) return;
    if (!is_deterministic(known))
      known = std::move(row);
    else if (digest_line(known) != digest_line(row))
      throw std::invalid_argument("another row of the same cell differs from this one");
  }
  std::vector<Row> take() { return std::move(rows_); }

 private:
  std::vector<Row> rows_;
  std::map<std::string, std::size_t> index_;
};

void read_file(const fs::path& path, Collection& collection) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw BadInput(path.string() + ": cannot be read");
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (file.eof()) return;  // no newline: torn
    try {
      collection.add(parse_row(line));
    } catch (const std::exception& error) {  // nlohmann's errors and ours
      throw BadInput(path.string() + ':' + std::to_string(number) + ": " + error.what());
    }
  }
}

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw BadInput(path.string() + ": " + reason);
}

int open_file(const fs::path& path, int flags) {
  const int file = open(path.c_str(), flags | O_CLOEXEC, 0666);
  if (file < 0) refuse(path, std::generic_category().message(errno));
  return file;
}

// A new name is on the disk only when its folder is.
void sync_folder(const fs::path& path) {
  const int folder = open_file(path, O_RDONLY | O_DIRECTORY);
  fsync(folder);
  close(folder);
}

// Record locks, unlike flock's, are not inherited by children: they end with this process and no other.
int lock_folder(const fs::path& folder) {
  const int file = open_file(folder / ".lock", O_RDWR | O_CREAT);
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(file, F_SETLK, &whole) == 0) return file;
  close(file);
  refuse(folder, "another run is writing into this folder");
}

void cut_torn_line(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  off_t end = size;
  for (char last = 0; end > 0; --end) {
    if (pread(file, &last, 1, end - 1) != 1)
      throw std::system_error(errno, std::generic_category(), own_file);
    if (last == '\n') break;
  }
  if (end < size && ftruncate(file, end) != 0)
    throw std::system_error(errno, std::generic_category(), own_file);
}

}  // namespace

std::vector<Row> read_rows(const fs::path& folder) {
  const std::string only = folder.string();
  return read_rows(std::span(&only, 1));
}

std::vector<Row> read_rows(std::span<const std::string> folders) {
  Collection collection;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(folder)) refuse(folder, "no such folder");
    for (const fs::path& path : row_files(folder)) read_file(path, collection);
  }
  return collection.take();
}

RunFolder::RunFolder(fs::path folder, Mode mode) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_ / rows_folder, error);
  if (error) refuse(folder_, error.message());
  lock_ = lock_folder(folder_);
  try {
    rows_ = read_rows(folder_);
    if (mode == Mode::fresh && !rows_.empty())
      refuse(folder_,
             "holds " + std::to_string(rows_.size()) + " rows already; --resume continues such a run");
    file_ = open_file(folder_ / rows_folder / own_file, O_RDWR | O_CREAT | O_APPEND);
    cut_torn_line(file_);
    sync_folder(folder_ / rows_folder);
    sync_folder(folder_);
  } catch (...) {
    close(file_);
    close(lock_);
    throw;
  }
}

RunFolder::~RunFolder() {
  close(file_);
  close(lock_);
}

void RunFolder::append(std::span<const Row> rows) {
  using json = nlohmann::json;
  std::string lines;
  for (const Row& row : rows) lines += json(row).dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
  const off_t before = lseek(file_, 0, SEEK_END);
  const ssize_t written = write(file_, lines.data(), lines.size());
  const int cause = written < 0 ? errno : ENOSPC;
  if (written != static_cast<ssize_t>(lines.size())) {
    static_cast<void>(!ftruncate(file_, before));
    throw std::system_error(cause, std::generic_category(), (folder_ / rows_folder / own_file).string());
  }
  if (fdatasync(file_) != 0) throw std::system_error(errno, std::generic_category(), "fdatasync");
  rows_.insert(rows_.end(), rows.begin(), rows.end());
}

}  // namespace tribunal::bench
