#!/usr/bin/env bash
# usage: install.sh CMAKE BUILD_FOLDER PREFIX COMPILER
# Installs into an empty folder, and lets the installed program try a plug-in made of the installed header alone.
set -euo pipefail
cmake=$1 build=$2 prefix=$3 compiler=$4
rm -rf "$prefix"
"$cmake" --install "$build" --prefix "$prefix" >/dev/null
cd "$prefix"
for file in share/tribunal/schemas/row.schema.json share/doc/tribunal/{README.md,LICENSE,docs/plugins.md}; do
  [[ -s $file ]] || { echo "missing: $file" >&2; exit 1; }
done
bin/tribunal list backends >/dev/null
bin/tribunal list peers | grep '\.so' | grep -vF "$prefix/lib/tribunal/peers/" &&
  { echo "a peer that is not installed" >&2; exit 1; }

cat >zero.c <<'C'
#include "tribunal_predicates.h"
static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  (void)context, (void)a, (void)b, (void)c;
  return 0;
}
static const tribunal_predicates offer = {.version = TRIBUNAL_PLUGIN_VERSION, .name = "zero", .orient2d = orient2d};
const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
C
"$compiler" -x c -shared -fPIC -Iinclude zero.c -o zero.so
status=0
bin/tribunal try --plugin ./zero.so >/dev/null 2>&1 || status=$?
[[ $status == 1 ]] || { echo "a predicate that is always zero ended with status $status" >&2; exit 1; }
