# SPDX-License-Identifier: BSD-3-Clause
"""The environment that a catkin workspace makes."""
import subprocess


def workspace_env(workspace):
    """What a shell has after devel/setup.bash."""
    # The path is $0: an argument would also be one of setup.bash, and as a part of the command it would need quoting.
    done = subprocess.run(["bash", "-c", '. "$0/devel/setup.bash" >&2 && env -0', workspace], check=True, stdout=subprocess.PIPE)
    return dict(entry.split("=", 1) for entry in done.stdout.decode().split("\0") if "=" in entry)
