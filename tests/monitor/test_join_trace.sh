#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tzc-monitor --join-trace with files that cannot be joined: each ends it with 2, says which, and ends at all.
# usage: test_join_trace.sh TZC_MONITOR
set -euo pipefail
monitor=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# ends_with STATUS WORDS FILE...: appends to all, as a user does who joins in two steps.
ends_with() {
  local expected=$1 words=$2 status=0; shift 2
  timeout 20 "$monitor" --join-trace "$@" >>all 2>said || status=$?
  if [ "$status" != "$expected" ] || [[ $(<said) != *"$words"* ]]; then
    echo "WRONG: --join-trace $* ends with $status and says: $(cat said)"
    exit 1
  fi
}

printf '[\n{"pid":1},\n{"pid":1}\n]\n' >trace
touch all
ends_with 0 '' trace
before=$(cksum all)
ends_with 2 'all is the output' trace all
ln all link
ends_with 2 'link is the output' link
[ "$(cksum all)" = "$before" ] || { echo "WRONG: it wrote before it refused"; exit 1; }

ends_with 2 'excludes' trace --why /viewer /image

mkdir folder
ends_with 2 'folder cannot be read' trace folder
ends_with 2 'mem cannot be read' /proc/self/mem trace  # it opens, and reading fails
ends_with 2 'missing: No such file' trace missing
"$monitor" --join-trace trace /dev/null >/dev/null 2>&1 || { echo "WRONG: /dev/null is no file that grows"; exit 1; }
echo "what cannot be joined is refused"
