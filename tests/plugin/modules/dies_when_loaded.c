/* Broken: its start-up code ends the process. */
#include "tribunal_predicates.h"

#include <stdlib.h>

__attribute__((constructor)) static void start(void) { abort(); }

const tribunal_predicates* tribunal_predicates_entry(void) { return NULL; }
