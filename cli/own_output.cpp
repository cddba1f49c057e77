#include "cli/own_output.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <ostream>
#include <system_error>
#include <unistd.h>

namespace tribunal::cli {

OwnOutput::OwnOutput() : descriptor_(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "standard output");
  std::fflush(stdout);
  dup2(STDERR_FILENO, STDOUT_FILENO);
}

OwnOutput::~OwnOutput() { close(descriptor_); }

void OwnOutput::print(Console& console, const std::function<void()>& print) const {
  std::fflush(stdout);  // a module's, which need not have ended its line
  dup2(descriptor_, STDOUT_FILENO);
  print();
  console.out.flush();
  if (std::fflush(stdout) != 0) console.out.setstate(std::ios::badbit);
  dup2(STDERR_FILENO, STDOUT_FILENO);
}

}  // namespace tribunal::cli
