// Files that live inside the program, so that it needs no source tree: filled in by reports/embed.cmake.
#pragma once

#include <span>
#include <string_view>

namespace tribunal::reports {

/// One file as it was when the program was built.
struct EmbeddedFile {
  std::string_view name;  ///< last component of its path
  std::string_view text;  ///< its bytes
};

/// The claim files, in the order of reports/claims/list.cmake.
std::span<const EmbeddedFile> embedded_claims();

/// Style and script of the page.
std::span<const EmbeddedFile> embedded_page();

/// The charting libraries, in the order in which the page loads them; empty when npm had not fetched them.
std::span<const EmbeddedFile> embedded_charting();

/// Their licences, in the same order: who passes a page on passes the libraries on.
std::span<const EmbeddedFile> embedded_licences();

}  // namespace tribunal::reports
