// The entry of each judge of the list; its file says what it decides and how.
#pragma once

#include "reports/judges/judge.hpp"

namespace tribunal::reports {

#define JUDGE(name) extern const Judge name##_judge;
#include "reports/judges/list.def"
#undef JUDGE

}  // namespace tribunal::reports
