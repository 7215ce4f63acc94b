# SPDX-License-Identifier: BSD-3-Clause
"""Turns a page of the documentation into a script that does what it says, word for word.

usage: guide_script.py LOGS PAGE.md[:HEADING]... > script

HEADING: stop before the line that begins with it.

A ```bash block is typed; its output goes to LOGS/<line of the block>. A block with file=NAME is written to that file,
relative to the current folder. Each line of a ```text block must be part of a line that the last bash block printed.
"""
import os
import re
import shlex
import sys

PROLOGUE = """set -eE
guide_failed() { echo "$1"; echo "--- output:"; cat "$2"; exit 1; }
guide_expect() {  # LINE TEXT LOG
  grep -qF -- "$2" "$3" || guide_failed "$1 promises '$2'" "$3"
}
exec 3>&1
trap 'exec >&3 2>&3; guide_failed "a command of the block at $guide_block failed: $BASH_COMMAND" "$guide_log"' ERR
"""


def blocks(lines):
    """(line number, info string, lines) of each fenced block."""
    info, start, body = None, 0, []
    for number, line in enumerate(lines, 1):
        if info is None and line.startswith("```"):
            info, start, body = line[3:].strip(), number, []
        elif info is not None and line.startswith("```"):
            yield start, info, body
            info = None
        elif info is not None:
            body.append(line)


def emit(page, logs):
    """Prints one page's part of the script; the number of blocks to type."""
    page, _, heading = page.partition(":")
    with open(page) as file:
        lines = file.read().splitlines()
    if heading:
        lines = lines[:next(number for number, line in enumerate(lines) if line.startswith(heading))]
    typed, log = 0, ""
    for start, info, body in blocks(lines):
        name = re.search(r"file=(\S+)", info)
        if name:
            print(f"cat >{shlex.quote(name.group(1))} <<'END_OF_BLOCK'", *body, "END_OF_BLOCK", sep="\n")
        elif info == "bash":
            typed, log = typed + 1, f"{logs}/{os.path.basename(page)}:{start}"
            print(f"guide_block={os.path.basename(page)}:{start} guide_log={log}; exec >{log} 2>&1", *body, "exec >&3 2>&3", sep="\n")
        elif info == "text":
            for offset, line in enumerate(body, 1):
                print(f"guide_expect {os.path.basename(page)}:{start + offset} {shlex.quote(line.strip())} {log}")
    return typed


def main():
    print(PROLOGUE)
    for page in sys.argv[2:]:
        if not emit(page, sys.argv[1]):
            sys.exit(f"{page} has no block to type: the page or this script has changed")
    print("trap - ERR; echo 'every block did what the page says'")


if __name__ == "__main__":
    main()
