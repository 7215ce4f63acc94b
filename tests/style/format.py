#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails when clang-format 19 would change a C++ file.

usage: format.py CLANG_FORMAT REPOSITORY
"""
import subprocess
import sys

from tree import cpp_files


def main(clang_format, root):
    files = cpp_files(root)
    result = subprocess.run([clang_format, "--dry-run", "-Werror", *files], cwd=root, text=True, stderr=subprocess.PIPE,
                            check=False)
    changed = sorted({line.split(":")[0] for line in result.stderr.splitlines() if "[-Wclang-format-violations]" in line})
    print(f"{len(files)} files, {len(changed)} not formatted")
    if changed:
        print(f"run: {clang_format} -i {' '.join(changed)}")
    elif result.returncode:
        print(result.stderr)
    return 1 if result.returncode or not files else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
