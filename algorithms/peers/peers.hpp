// The peers there can be: whether one was built is known only where the program stands.
#pragma once

#include <array>
#include <string_view>

namespace tribunal {

/// Names of modules, as in list.def: the file is peers/<name>.so beside the program.
inline constexpr std::array peer_names{
#define PEER(name) std::string_view(#name),
#include "algorithms/peers/list.def"
#undef PEER
};

}  // namespace tribunal
