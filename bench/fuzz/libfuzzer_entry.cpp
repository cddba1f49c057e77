// What libFuzzer calls: aborts when an exact backend answers wrongly.
#include "bench/fuzz/bytes.hpp"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string fault = tribunal::bench::fuzz::judge_bytes({data, size});
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}
