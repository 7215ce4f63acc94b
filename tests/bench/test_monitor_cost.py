# SPDX-License-Identifier: BSD-3-Clause
"""usage: test_monitor_cost.py TZC_BENCH TZC_MONITOR

bench/monitor_cost.py in a tiny form: live monitors see the nodes and are killed, and a table says what that did. How
large the figures are is not looked at."""
import os
import re
import subprocess
import sys

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench", "monitor_cost.py")


def main():
    done = subprocess.run([sys.executable, SCRIPT, *sys.argv[1:], "--pairs", "1", "--count", "45"], text=True, timeout=600,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert done.returncode == 0, done
    for name in ("alone", "watched"):
        assert re.search(rf"^{name} .* \d+ of 180$", done.stdout, re.M), done.stdout
    killed = re.search(r"^10 monitors at a time, (\d+) of them killed; pairs of rounds: 1$", done.stdout, re.M)
    assert killed and int(killed.group(1)) > 0, done.stdout
    assert "median_us watched / alone: " in done.stdout, done.stdout


main()
