// What this program was built from and how.
#pragma once

#include <string_view>

namespace tribunal::bench {

struct BuildInfo {
  std::string_view commit;    ///< 40 hexadecimal digits; "unknown" outside a git checkout
  bool dirty;                 ///< the tree differed from the commit
  std::string_view compiler;  ///< name and version
  std::string_view flags;     ///< as given to the compiler
};

/// As of the last build.
const BuildInfo& build_info();

}  // namespace tribunal::bench
