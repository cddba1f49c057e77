/* Broken: needs a function that no library has. */
#include "tribunal_predicates.h"

const tribunal_predicates* a_function_that_nobody_defines(void);

const tribunal_predicates* tribunal_predicates_entry(void) { return a_function_that_nobody_defines(); }
