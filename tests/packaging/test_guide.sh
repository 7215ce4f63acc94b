#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Does what pages of docs/ say, word for word, as a normal user with an empty home, after TZC was installed in ~/tzc.
# usage: test_guide.sh SOURCE_DIR BUILD_DIR PAGE[:HEADING]...      HEADING: stop before it
source "$(dirname "$0")/lib.sh"
source_dir=$1 build=$2
shift 2

install_as_user "$build" "$scratch/home/tzc"
as_user mkdir "$scratch/output"
python3 "$(dirname "$0")/guide_script.py" "$scratch/output" "${@/#/$source_dir/docs/}" >"$scratch/script"

# A master of its own, in a session of its own: whatever the page leaves running is ended with it.
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
sed -i "s/^roscore &/roscore -p $port \&/" "$scratch/script"
as_user env ROS_MASTER_URI="http://127.0.0.1:$port" ROS_IP=127.0.0.1 MAKEFLAGS=-j2 \
  setsid --wait bash -c "echo \$\$ >$scratch/session; . $scratch/script" >"$scratch/said" 2>&1 </dev/null &
end_session() {
  local session
  session=$(cat "$scratch/session" 2>/dev/null || true)
  [ -z "$session" ] || pkill -s "$session" 2>/dev/null || true
  sleep 2
  [ -z "$session" ] || pkill -9 -s "$session" 2>/dev/null || true
  rm -rf "$scratch"
}
trap end_session EXIT
status=0
wait $! || status=$?
cat "$scratch/said"
exit "$status"
