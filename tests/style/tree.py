# SPDX-License-Identifier: BSD-3-Clause
"""The C++ files that people write: what git tracks, or without git what lies there, but for the inputs of tests."""
import os
import subprocess

# folder -> why its files are not held to the project's style
NOT_OURS = {
    "tests/rewriter/golden/cases/": "packages in their authors' styles, which the rewriter must leave alone",
    "tests/msggen/golden/expected/": "what tzc-msggen writes",
}


def cpp_files(root):
    """Paths relative to `root`, sorted."""
    tracked = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=root, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False).stdout.splitlines()
    return sorted(path for path in tracked or _walk(root)
                  if path.endswith((".h", ".cpp")) and not path.startswith(tuple(NOT_OURS))
                  and os.path.exists(os.path.join(root, path)))


def _walk(root):
    for folder, folders, names in os.walk(root):
        folders[:] = [name for name in folders if not name.startswith((".", "build"))]
        yield from (os.path.relpath(os.path.join(folder, name), root) for name in names)
