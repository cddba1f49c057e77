/* Broken: a plug-in without a predicate. */
#include "tribunal_predicates.h"

static const tribunal_predicates offer = {.version = TRIBUNAL_PLUGIN_VERSION, .name = "offers nothing"};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
