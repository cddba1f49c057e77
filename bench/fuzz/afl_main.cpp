// What AFL++ runs: one input from standard input, or thousands per process when built with its compiler.
// Aborts when an exact backend answers wrongly.
#include "bench/fuzz/bytes.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace {

void judge_standard_input() {
  std::array<std::uint8_t, 4096> input{};
  const std::size_t size = std::fread(input.data(), 1, input.size(), stdin);
  const std::string fault = tribunal::bench::fuzz::judge_bytes(std::span(input).first(size));
  if (fault.empty()) return;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

}  // namespace

int main() {
#ifdef __AFL_LOOP
  while (__AFL_LOOP(10000)) {
    std::clearerr(stdin);
    judge_standard_input();
  }
#else
  judge_standard_input();
#endif
}
