/* Broken: of a version that is not yet. */
#include "tribunal_predicates.h"

static const tribunal_predicates offer = {.version = TRIBUNAL_PLUGIN_VERSION + 1, .name = "other version"};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
