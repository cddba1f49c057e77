// Standard output while foreign code is in this process.
#pragma once

#include "cli/console.hpp"

#include <functional>

namespace tribunal::cli {

/// From its construction to the end of the process, descriptor 1 leads to standard error, so that what a
/// module prints, be it when the process exits, never gets into a document.
class OwnOutput {
 public:
  OwnOutput();
  OwnOutput(const OwnOutput&) = delete;
  OwnOutput& operator=(const OwnOutput&) = delete;
  ~OwnOutput();

  /// Runs `print` with console.out where it led before.
  void print(Console& console, const std::function<void()>& print) const;

 private:
  int descriptor_;  ///< of the standard output that is kept
};

}  // namespace tribunal::cli
