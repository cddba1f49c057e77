// The entry of each generator; its file says what it draws.
#pragma once

#include "datasets/dataset.hpp"

namespace tribunal::generators {

#define GENERATOR(name) extern const Dataset name;
#include "datasets/generators/list.def"
#undef GENERATOR

}  // namespace tribunal::generators
