# SPDX-License-Identifier: BSD-3-Clause
# Completion for bash: options are what the tool's --help lists (of the command that was typed, if it has commands), codes
# what tzc-rewrite --list-codes lists, the rest are files.
_tzc_options() { "$@" --help 2>/dev/null | grep -oE -- '(^|[ ,])--?[a-zA-Z][a-zA-Z0-9-]*' | tr -d ' ,' | sort -u; }

_tzc() {
  local tool=$1 current=$2 previous=$3 command=()
  COMPREPLY=()
  if [ "$previous" = --explain ]; then
    mapfile -t COMPREPLY < <(compgen -W "$("$tool" --list-codes 2>/dev/null | grep -oE '^ *TZC[0-9]+')" -- "$current")
  elif [[ $current == -* ]]; then
    [[ ${COMP_WORDS[1]:-} == -* || ${COMP_CWORD:-1} -le 1 ]] || command=("${COMP_WORDS[1]}")
    [ "${tool##*/}" = tzc-msggen ] || command=()
    mapfile -t COMPREPLY < <(compgen -W "$(_tzc_options "$tool" "${command[@]}")" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}
complete -o filenames -F _tzc tzc-rewrite tzc-msggen tzc-monitor tzc-diagnostics tzc-compare tzc-run
