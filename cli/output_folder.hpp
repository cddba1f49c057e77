// A folder that results are to go to, looked at before the work that yields them.
#pragma once

#include <string>

namespace tribunal::cli {

/// Makes the folder where it is missing, and writes and removes a file in it. Throws BadInput with the
/// system's reason where that fails: what takes hours to find must not be lost for want of a place to put it.
void require_writable_folder(const std::string& folder);

}  // namespace tribunal::cli
