# SPDX-License-Identifier: BSD-3-Clause
"""tzc-rewrite and its report."""
import json
import os
import re
import subprocess

from toolchain import Failure


def rewrite(config, build, package, report, more):
    """Runs tzc-rewrite; its report."""
    includes = [word for folder in config["tzc_includes"] for word in ("--tzc-include", folder)]
    done = subprocess.run([config["rewrite"], "-p", build, "--report", report, *includes, *more, package],
                          stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, check=False)
    if done.returncode not in (0, 1):
        raise Failure(f"tzc-rewrite ends with {done.returncode}:\n" + done.stderr.decode(errors="replace")[-3000:])
    with open(report) as file:
        return json.load(file)


def lasting_sites(sites):
    """What of each site stays when the port is applied."""
    return [(site["id"], site["kind"], site["message_type"], site["topic"], site["level"],
             site["code"]) for site in sites]


# How each kind of site is written; a count by text that knows nothing of C++.
WRITTEN = {"publish": r"\bpublish\(", "advertise": r"\badvertise(?:Camera)?(?:<|\()",
           "subscribe": r"\bsubscribe(?:<[^(]*>)?\(|new message_filters::Subscriber<"}


def check_sites(package, report):
    """Every site of the package is in the report exactly once."""
    text = ""
    for folder, _, names in os.walk(package):
        for name in names:
            if name.endswith((".h", ".cpp")):
                with open(os.path.join(folder, name)) as file:
                    text += file.read()
    for kind, pattern in WRITTEN.items():
        written = len(re.findall(pattern, text))
        reported = sum(1 for site in report["sites"] if site["kind"] == kind)
        if written != reported:
            raise Failure(f"{written} {kind} sites are written, {reported} are in the report")
