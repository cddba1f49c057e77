// What a run folder's rows were made with: enough to judge them by, and to refuse to mix.
#pragma once

#include "bench/plan.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace tribunal::bench {

/// Schema version, build (commit, dirty flag, compiler, flags), floating-point witness, libraries, machine
/// (CPU, kernel) and the plan (name, digest, caps, number of cells, seeds, digests of the datasets of fixed
/// size).
nlohmann::json make_manifest(const Plan& plan);

/// Writes `folder`/manifest.json. Where there is one already, its plans are kept and this one added; BadInput
/// when it was written by another build, for then its rows cannot be told from this one's.
void update_manifest(const std::filesystem::path& folder, const Plan& plan);

}  // namespace tribunal::bench
