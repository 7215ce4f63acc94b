#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The setup files of a prefix that is relative, has a blank, or could not be written into a shell's file.
# usage: test_setup_files.sh SOURCE_DIR BUILD_DIR
source "$(dirname "$0")/lib.sh"
source_dir=$1 build=$2

install_into() { # PREFIX
  logged install cmake -DCMAKE_INSTALL_PREFIX="$1" -Dgenerated="$build/catkin_generated/installspace" \
    -Dsetup_util="$build/devel/_setup_util.py" -P "$source_dir/cmake/install_setup_files.cmake"
}

for prefix in relative "with a blank" "$scratch/absolute"; do
  install_into "$prefix" || wrong "'$prefix' is no prefix"
  folder=$scratch/${prefix##*/}
  found=$(as_user env --chdir=/ sh -c '. "$1" && echo "$CMAKE_PREFIX_PATH"' sh "$folder/setup.sh" || true)
  [ "${found%%:*}" = "$folder" ] || wrong "setup.sh of '$prefix' gives the prefix '$found'"
done

for prefix in "it's" 'a"quote' 'a}brace' 'a$variable' 'a`command`'; do
  ! install_into "$prefix" >/dev/null || wrong "$prefix is taken"
  grep -q -- "--prefix" "$scratch/install.log" || wrong "$prefix is refused without a word on what to do"
  [ ! -e "$scratch/$prefix" ] || wrong "$prefix is refused after files were written"
done
echo "setup.sh names every prefix that it can, and no other is taken"
