#include "datasets/data/embedded.hpp"

#ifndef TRIBUNAL_DATA_FOLDER
#error "TRIBUNAL_DATA_FOLDER: the folder of the data files, given by CMakeLists.txt"
#endif

// C++20 has no #embed; the assembler's .incbin, which g++ and clang share, puts a file between two symbols.
#define TRIBUNAL_EMBED(name)                                                                  \
  __asm__(                                                                                    \
      ".pushsection .rodata\n"                                                                \
      ".hidden tribunal_data_" #name                                                          \
      "_begin\n"                                                                              \
      ".globl tribunal_data_" #name                                                           \
      "_begin\n"                                                                              \
      "tribunal_data_" #name                                                                  \
      "_begin:\n"                                                                             \
      ".incbin \"" TRIBUNAL_DATA_FOLDER "/" #name                                             \
      ".txt\"\n"                                                                              \
      ".hidden tribunal_data_" #name                                                          \
      "_end\n"                                                                                \
      ".globl tribunal_data_" #name                                                           \
      "_end\n"                                                                                \
      "tribunal_data_" #name                                                                  \
      "_end:\n"                                                                               \
      ".byte 0\n"                                                                             \
      ".popsection\n");                                                                       \
  extern "C" __attribute__((visibility("hidden"))) const char tribunal_data_##name##_begin[]; \
  extern "C" __attribute__((visibility("hidden"))) const char tribunal_data_##name##_end[]

TRIBUNAL_EMBED(counties);
TRIBUNAL_EMBED(coast);

namespace tribunal::data {

std::string_view counties() { return {tribunal_data_counties_begin, tribunal_data_counties_end}; }

std::string_view coast() { return {tribunal_data_coast_begin, tribunal_data_coast_end}; }

}  // namespace tribunal::data
