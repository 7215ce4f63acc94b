#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The API reference is made without a warning, holds what users call, and each kind of mistake makes scripts/doc fail.
# usage: test_reference.sh SOURCE_DIR SCRATCH_DIR
set -euo pipefail
source_dir=$1 scratch=$2
tree="$scratch/a tree" out="$scratch/a folder"  # wherever they lie
failures=0
complain() { echo "FAIL: $*" >&2; failures=$((failures + 1)); }

rm -rf "$scratch"
mkdir -p "$tree/docs" "$tree/runtime"
cp -a "$source_dir/scripts" "$source_dir/package.xml" "$tree/"
cp "$source_dir/docs/Doxyfile" "$tree/docs/"
for module in "$source_dir"/runtime/*/include; do
  mkdir -p "$tree/runtime/$(basename "$(dirname "$module")")"
  cp -a "$module" "$tree/runtime/$(basename "$(dirname "$module")")/"
done
doc() { "$tree/scripts/doc" "$out" >"$scratch/log" 2>&1; }

doc || { cat "$scratch/log" >&2; complain "the public headers give warnings"; }
pages=$(cat "$out"/html/*.html)
for name in tzc::Publisher tzc::advertise tzc::Array tzc::channel::Subscriber tzc::image_transport::Publisher; do
  grep -q "${name##*::}" <<<"$pages" || complain "$name is not in the reference"
done
if compgen -G "$out/html/*detail*.html" >/dev/null; then complain "internals are in the reference"; fi

wrong() {
  cp "$source_dir/runtime/roscpp/include/tzc/options.h" "$tree/runtime/roscpp/include/tzc/options.h"
  printf '%s\n' "$2" >>"$tree/runtime/roscpp/include/tzc/options.h"
  if doc; then complain "$1 goes unnoticed"; fi
}
wrong "a link that leads nowhere" '/// See @ref no_such_page.
struct WrongLink {};'
wrong "a parameter that is not there" '/// Does it. @param missing no such parameter
void wrong_parameter(int given);'
wrong "a class without documentation" 'namespace tzc { struct WithoutWords { int value; }; }'
[ "$failures" -eq 0 ]
