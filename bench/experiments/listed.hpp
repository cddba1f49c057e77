// The entry of each listed experiment; its file says what it counts and how.
#pragma once

#include "bench/experiments/experiment.hpp"

namespace tribunal::bench {

#define EXPERIMENT(name) extern const Experiment name##_experiment;
#include "bench/experiments/list.def"
#undef EXPERIMENT

}  // namespace tribunal::bench
