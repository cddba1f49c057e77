// The entry of each query family; its file says what it draws.
#pragma once

#include "datasets/queries/queries.hpp"

namespace tribunal::queries {

#define QUERY_FAMILY(name) extern const QueryFamily name;
#include "datasets/queries/list.def"
#undef QUERY_FAMILY

}  // namespace tribunal::queries
