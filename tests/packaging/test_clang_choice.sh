#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Whether tzc-rewrite is built, and the line that says what is missing otherwise (cmake/TzcOptions.cmake, TzcClang.cmake),
# for installations of LLVM that lack one thing each. usage: test_clang_choice.sh SOURCE_DIR
set -euo pipefail
source=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
read -r newest rest < <(sed -n 's/^set(TZC_LLVM_VERSIONS \(.*\))$/\1/p' "$source/cmake/TzcLlvmVersions.cmake")
oldest=${rest##* }

cat >"$scratch/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.16)
project(choice CXX)
list(APPEND CMAKE_MODULE_PATH ${TZC}/cmake)
set(CATKIN_DEVEL_PREFIX none)
include(TzcOptions)
CMAKE

# llvm NAME VERSION FILE...: an installation with these files; its llvm-config is NAME/llvm-config.
llvm() {
  local name=$1 version=$2 file; shift 2
  mkdir -p "$scratch/$name"
  for file in "$@"; do mkdir -p "$scratch/$name/$(dirname "$file")"; touch "$scratch/$name/$file"; done
  cat >"$scratch/$name/llvm-config" <<SH
#!/bin/sh
case \$1 in --version) echo $version ;; --includedir) echo $scratch/$name/include ;; --libdir) echo $scratch/$name/lib ;; esac
SH
  chmod +x "$scratch/$name/llvm-config"
}

# configured STATUS WORDS OPTION...: CMake ends with STATUS, and one of its lines holds the words.
configured() {
  local status=0 expected=$1 words=$2; shift 2
  cmake -S "$scratch" -B "$scratch/build" --fresh -DTZC="$source" "$@" >"$scratch/log" 2>&1 || status=$?
  [ "$status" = "$expected" ] || { echo "$*: ends with $status"; cat "$scratch/log"; exit 1; }
  tr -s '\n ' ' ' <"$scratch/log" | grep -qF -e "$words" || { echo "$*: no '$words' in"; cat "$scratch/log"; exit 1; }
}

# missing NAME WORDS: left out with the reason, or an error with it where the tool was asked for.
missing() {
  configured 0 "tzc-rewrite is left out: $2" -DTZC_LLVM_CONFIG="$scratch/$1/llvm-config"
  configured 1 "tzc-rewrite needs Clang's libraries: $2" -DTZC_LLVM_CONFIG="$scratch/$1/llvm-config" -DTZC_BUILD_REWRITER=ON
}

headers=include/clang/Tooling/Tooling.h
libraries=(lib/libclang-cpp.so "lib/libLLVM-$newest.so")
llvm complete "$newest.1.7" "$headers" "${libraries[@]}" "lib/clang/$newest/include/stddef.h"
configured 0 "tzc-rewrite uses Clang $newest ($scratch/complete/include)" -DTZC_LLVM_CONFIG="$scratch/complete/llvm-config"
llvm unknown "$((oldest - 1)).0.1" "$headers" "${libraries[@]}"
missing unknown "$scratch/unknown/llvm-config is of LLVM $((oldest - 1)).0.1; versions $oldest to $newest are known to work"
llvm no_headers "$newest.1.7" "${libraries[@]}"
missing no_headers "$scratch/no_headers/include has no headers of Clang; install libclang-$newest-dev"
llvm no_libraries "$newest.1.7" "$headers"
missing no_libraries "$scratch/no_libraries/lib has no libclang-cpp.so; install libclang-cpp$newest-dev"
llvm no_resource "$newest.1.7" "$headers" "${libraries[@]}"
missing no_resource "$scratch/no_resource/lib/clang has no stddef.h; install libclang-common-$newest-dev"
configured 0 "tzc-rewrite is left out: llvm-config-$((newest + 1)) was not found; install llvm-$((newest + 1))-dev" \
  -DTZC_LLVM_VERSION=$((newest + 1))
echo "the line says what is missing"
