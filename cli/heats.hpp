// What `tribunal bench algorithms` is to race: who, and where.
#pragma once

#include "bench/whole/contestant.hpp"
#include "bench/whole/course.hpp"
#include "cli/verbs.hpp"

#include <vector>

namespace tribunal::cli {

/// Methods of ours over one course.
struct Heat {
  bench::Course course;
  std::vector<bench::Method> methods;
};

/// Every combination of what the user named, by dataset; or what the goals name, those over point sets with
/// as many points as the user says. Throws BadUsage or BadInput for what cannot be raced.
std::vector<Heat> heats_of(const BenchOptions& options);

}  // namespace tribunal::cli
