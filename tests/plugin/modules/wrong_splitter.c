/* Broken: splits doubles one bit too high, so that halves have up to 28 bits and their products are rounded.
 */
#define SPLITTER 0x1.0000001p28
#include "splitter.h"
