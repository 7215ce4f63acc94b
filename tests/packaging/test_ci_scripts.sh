#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The commit hook and the script for CI, with programs that only tell how they were called in place of tzc-rewrite and
# catkin's. (docs/ci.md is followed with the true ones.)
# usage: test_ci_scripts.sh SOURCE_DIR
source "$(dirname "$0")/lib.sh"
source_dir=$1
ci=$source_dir/packaging/ci
programs=$scratch/programs
mkdir "$programs"
export PATH=$programs:$PATH HOME=$scratch/home GIT_CONFIG_NOSYSTEM=1
git config --global user.name me
git config --global user.email me@example.org

# A package is ported when no source of it says otherwise.
cat >"$programs/tzc-rewrite" <<'END'
#!/usr/bin/env bash
[ "$1" = --check ] || exit 2
shift
packages=()
for word; do case $word in --report) ;; *.sarif) ;; *) packages+=("$word") ;; esac; done
! grep -rq --exclude=README.md unported "${packages[@]}" || { echo "not ported yet"; exit 1; }
END
for builder in catkin catkin_make catkin_make_isolated; do
  printf '#!/usr/bin/env bash\necho %s "$@" >>builders\n' "$builder" >"$programs/$builder"
done
chmod +x "$programs"/*

# A repository whose last commit is ported, with the hook.
repository() {
  local file
  rm -rf "$scratch/repository"
  mkdir -p "$scratch/repository/demo/src"
  cd "$scratch/repository" || exit
  git init -q .
  touch demo/package.xml
  for file in demo/src/one.cpp demo/src/two.h demo/CMakeLists.txt demo/README.md; do echo ported >"$file"; done
  git add . && git commit -qm first
  cp "$ci/pre-commit" .git/hooks/pre-commit
}

head_is_ported() { ! git grep -q unported HEAD -- '*.cpp' '*.h'; }

# What is committed is ported, however the index and the files differ and however the commit is made.
accepted=0
for file in one.cpp two.h; do
  for staged in ported unported; do
    for now in ported unported; do
      for command in "git commit -qm x" "git commit -qam x" "git commit -qm x demo/src/one.cpp"; do
        repository
        echo "// changed" >>demo/src/one.cpp
        echo "$staged 2" >"demo/src/$file"
        git add .
        echo "$now 3" >"demo/src/$file"
        if $command >"$scratch/said" 2>&1; then
          accepted=$((accepted + 1))
          head_is_ported || wrong "$command committed what is not ported: $file is $staged in the index, $now in the folder"
        else
          grep -qE "not ported yet|git add" "$scratch/said" || wrong "$command was refused without a reason: $(cat "$scratch/said")"
        fi
      done
    done
  done
done
[ $accepted -gt 0 ] || wrong "no commit passed"

# What differs and is not read does not stand in the way; a file that was moved is a file of the commit.
repository
git mv demo/src/one.cpp demo/src/three.cpp
git commit -qm moved || wrong "a ported file that was moved was refused"
echo "unported" >>demo/README.md
echo "// more" >>demo/src/three.cpp
git add demo/src
git commit -qm more >"$scratch/said" 2>&1 || wrong "a README that is not staged was refused: $(cat "$scratch/said")"
git mv demo/src/three.cpp demo/src/four.cpp
echo "unported" >>demo/src/four.cpp
git add demo/src
! git commit -qm unported 2>/dev/null || wrong "a file that was moved and changed was not checked"

# Every kind of file that tzc-rewrite takes for a source makes the hook look, as it is staged and as it lies there.
mapfile -t endings < <(sed -nE '/^bool is_(cpp|cuda)_/,/^}/p' "$source_dir/rewriter/edits/files.cpp" | grep -oE '"\.[^"]+"' | tr -d '"')
[ "${#endings[@]}" -ge 20 ] || wrong "tzc-rewrite's list of sources was not found: ${endings[*]}"
for ending in .c "${endings[@]}"; do
  repository
  echo unported >"demo/src/new$ending"
  git add .
  ! git commit -qm unported 2>"$scratch/said" || wrong "an unported file *$ending was committed"
  grep -q "not ported yet" <(git commit -qm unported 2>&1) || wrong "*$ending was refused for another reason: $(cat "$scratch/said")"
  echo ported >"demo/src/new$ending"
  ! git commit -qm unported 2>"$scratch/said" || wrong "an unported file *$ending was committed when it was ported after git add"
done
for name in demo/CMakeLists.txt demo/package.xml demo/.tzc-rewrite.yaml demo/more.cmake demo/msg/Own.msg; do
  repository
  echo "// changed" >>demo/src/one.cpp
  mkdir -p demo/msg
  echo staged >"$name"
  git add .
  echo changed >"$name"
  ! git commit -qm x 2>"$scratch/said" || wrong "$name was judged as it lies there and committed as it was staged"
done

# check.sh builds with what has built the workspace before.
builds_with() { # EXPECTED FOLDER...
  local expected=$1; shift
  rm -rf "$scratch/ws"
  mkdir -p "$scratch/ws/src" "${@/#/$scratch/ws/}"
  TZC_WORKSPACE=$scratch/ws "$ci/check.sh" >/dev/null || wrong "check.sh failed"
  [ "$(tail -n 1 "$scratch/ws/builders")" = "$expected" ] || wrong "check.sh builds with: $(cat "$scratch/ws/builders")"
  grep -q -- "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON" "$scratch/ws/builders" || wrong "no compile commands are made"
}
option=-DCMAKE_EXPORT_COMPILE_COMMANDS=ON
builds_with "catkin_make $option"
builds_with "catkin_make $option" build devel build_isolated
builds_with "catkin_make_isolated $option" build_isolated devel_isolated
builds_with "catkin build" .catkin_tools
builds_with "catkin build" .catkin_tools build devel
TZC_BUILD_COMMAND="echo mine $option >>builders" builds_with "mine $option" .catkin_tools
status=0
TZC_BUILD_COMMAND=false TZC_WORKSPACE=$scratch/ws "$ci/check.sh" 2>"$scratch/said" || status=$?
[ "$status" = 2 ] || wrong "a build that fails ends with $status"
grep -q TZC_BUILD_COMMAND "$scratch/said" || wrong "a build that fails ends without a word: $(cat "$scratch/said")"

# A setup file joins the workspaces that the job has sourced before it; catkin's forget them without that word.
cat >"$scratch/setup.bash" <<'END'
[ "${1:-}" = --extend ] || CMAKE_PREFIX_PATH=
export CMAKE_PREFIX_PATH=/opt/tzc:$CMAKE_PREFIX_PATH
END
CMAKE_PREFIX_PATH=/the/job/s/own TZC_SETUP=$scratch/setup.bash TZC_BUILD_COMMAND='echo "$CMAKE_PREFIX_PATH" >prefixes' \
  TZC_WORKSPACE=$scratch/ws "$ci/check.sh" >/dev/null || wrong "check.sh failed with a setup file"
[ "$(<"$scratch/ws/prefixes")" = /opt/tzc:/the/job/s/own ] || wrong "check.sh builds among the prefixes $(<"$scratch/ws/prefixes")"

# What is wrong with the script's own settings is an error, and no unported site.
export CDPATH=$scratch
mkdir -p "$scratch/empty"
for settings in TZC_WORKSPACE=/no/such/folder TZC_WORKSPACE=ws TZC_SETUP=/no/such/setup.bash TZC_SETUP="$scratch/ends.bash"; do
  echo 'echo it ends >&2; exit 1' >"$scratch/ends.bash"
  status=0
  (cd "$scratch/empty" && env TZC_WORKSPACE="$scratch/ws" "$settings" "$ci/check.sh" >/dev/null 2>"$scratch/said") || status=$?
  [ "$status" = 2 ] || wrong "check.sh with $settings ends with $status"
  [ -s "$scratch/said" ] || wrong "check.sh with $settings ends without a word"
done

echo "the commit hook and the script for CI do what they say"
