// What the tests of datasets share: exact arithmetic on integer points, files that vanish after the test.
#pragma once

#include "predicates/point.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace tribunal::test {

__extension__ using Wide = __int128;

inline Wide wide(double integer) { return static_cast<Wide>(integer); }

/// orient2d of integer points below 2^62, exact.
inline Wide orient(const Point2& a, const Point2& b, const Point2& c) {
  return (wide(a[0]) - wide(c[0])) * (wide(b[1]) - wide(c[1])) -
         (wide(a[1]) - wide(c[1])) * (wide(b[0]) - wide(c[0]));
}

inline std::size_t distinct(std::span<const Point2> points) {
  return std::set<Point2>(points.begin(), points.end()).size();
}

/// A folder of its own for each test, removed at its end.
class Folder {
 public:
  Folder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("tribunal-") + test->test_suite_name() + "-" + test->name();
    for (char& c : name)
      if (c == '/') c = '-';
    path_ = std::filesystem::temp_directory_path() / (name + "-" + std::to_string(::getpid()));
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

  std::filesystem::path write(std::string_view name, std::string_view content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }
  std::string read(std::string_view name) const {
    std::stringstream content;
    content << std::ifstream(path_ / name, std::ios::binary).rdbuf();
    return content.str();
  }
  std::size_t files() const {
    const auto entries = std::filesystem::directory_iterator(path_);
    return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
  }

 private:
  std::filesystem::path path_;
};

}  // namespace tribunal::test
