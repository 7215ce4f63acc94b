#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What bash offers after `tzc-rewrite --`, and the manual pages. usage: test_completion.sh SOURCE_DIR BUILD_DIR TOOL...
set -euo pipefail
source "$1/packaging/completion/tzc.bash"
build=$2
shift 2

offers() {  # EXPECTED TOOL CURRENT PREVIOUS [COMMAND]
  COMP_WORDS=("$2" "${5:-$3}") COMP_CWORD=2
  _tzc "$build/bin/$2" "$3" "$4"
  printf '%s\n' "${COMPREPLY[@]}" | grep -xF -- "$1" >/dev/null ||
    { echo "$2 $3: no $1 among: ${COMPREPLY[*]}"; exit 1; }
}
for tool in "$@"; do
  case $tool in
    tzc-rewrite) offers --apply tzc-rewrite --a ""; offers -j tzc-rewrite -j ""; offers TZC1004 tzc-rewrite TZC10 --explain ;;
    tzc-monitor) offers --why tzc-monitor --w "" ;;
    tzc-msggen) offers --help tzc-msggen --h ""; offers --if-changed tzc-msggen --if "" generate ;;
  esac
  if command -v help2man >/dev/null; then
    grep -q '^\.SH DESCRIPTION' "$build/man/$tool.1" || { echo "$tool.1 is no manual page"; exit 1; }
  fi
done
echo "completion and manual pages are there"
