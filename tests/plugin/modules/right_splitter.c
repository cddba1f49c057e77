/* Right: Dekker's splitter for doubles. The broken one differs in this constant alone. */
#define SPLITTER 0x1.0000002p27
#include "splitter.h"
