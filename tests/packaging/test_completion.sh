#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What every tool that is installed has: its version, a manual page, completion by bash and by zsh; and what bash offers.
# usage: test_completion.sh SOURCE_DIR BUILD_DIR VERSION TOOL...
set -euo pipefail
completion=$1/packaging/completion
source "$completion/tzc.bash"
build=$2 version=$3
shift 3
wrong() { echo "$*"; exit 1; }

offers() {  # EXPECTED TOOL CURRENT PREVIOUS [COMMAND]
  COMP_WORDS=("$2" "${5:-$3}") COMP_CWORD=2
  _tzc "$build/bin/$2" "$3" "$4"
  printf '%s\n' "${COMPREPLY[@]}" | grep -xF -- "$1" >/dev/null || wrong "$2 $3: no $1 among: ${COMPREPLY[*]}"
}
for tool in "$@"; do
  [ "$("$build/bin/$tool" --version)" = "$tool $version" ] || wrong "$tool --version says something else than $tool $version"
  complete -p "$tool" | grep -q -- '-F _tzc' || wrong "bash does not complete $tool"
  offers --help "$tool" --h ""
  offers --version "$tool" --v ""
  if command -v zsh >/dev/null; then
    zsh -f -c 'fpath=($1 $fpath); autoload -Uz compinit && compinit -D -u && [[ ${_comps[$2]} == _tzc ]]' zsh "$completion" "$tool" ||
      wrong "zsh does not complete $tool"
  fi
  if command -v help2man >/dev/null; then
    grep -q '^\.SH DESCRIPTION' "$build/man/$tool.1" || wrong "$tool.1 is no manual page"
  fi
done
for tool in "$@"; do
  case $tool in
    tzc-rewrite) offers --apply tzc-rewrite --a ""; offers -j tzc-rewrite -j ""; offers TZC1004 tzc-rewrite TZC10 --explain ;;
    tzc-monitor) offers --why tzc-monitor --w "" ;;
    tzc-compare) offers --quiet tzc-compare --q "" ;;
    tzc-run) offers --guard tzc-run --g "" ;;
    tzc-msggen) offers --if-changed tzc-msggen --if "" generate ;;
  esac
done
echo "versions, manual pages and completion are there"
