// What the bench's tests share.
#pragma once

#include "bench/campaign.hpp"
#include "bench/cell.hpp"
#include "bench/plan.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace tribunal::bench {

/// A folder that is there for one test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "tribunal-bench-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_file(const std::filesystem::path& path, std::string_view text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline Plan plan_of(std::string_view text) { return read_plan(toml::parse(text), "test.toml"); }

/// A plan whose cells end in several outcomes, right and wrong ones.
inline Plan small_plan() {
  return plan_of(R"(
    [[cells]]
    algorithm = "*"
    backend = ["double", "gmp"]
    dataset = ["uniform", "grid", "mixed-exponents"]
    n = 30
    seed = "1..3"
    [[cells]]
    experiment = "sign-differential"
    backend = "double"
    n = 100
    bits = 20
    parameters = { generator = ["uniform", "grid"] }
  )");
}

/// The row of the only cell that a table of a plan stands for.
inline Row run_one(const std::string& block) {
  const Plan plan = plan_of("[[cells]]\n" + block);
  EXPECT_EQ(plan.cells.size(), 1u);
  return run_cell(plan.cells.at(0));
}

}  // namespace tribunal::bench
