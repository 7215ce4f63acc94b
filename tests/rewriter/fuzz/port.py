# SPDX-License-Identifier: BSD-3-Clause
"""tzc-rewrite and its report."""
import json
import os
import re
import subprocess

from toolchain import Failure


def rewrite(toolchain, build, packages, report, more):
    """Runs tzc-rewrite; sites and number of changed files. The packages have compile commands and nothing to configure."""
    includes = [word for folder in toolchain.config["tzc_includes"] for word in ("--tzc-include", folder)]
    if len(packages) > 1:
        more = ["--exported-headers=change", *more]
    # The programs' arrays are small, and would be left alone.
    done = subprocess.run([toolchain.config["rewrite"], "--verify=source", "--small=0", "--jobs", str(toolchain.jobs),
                           "-p", build, "--report", report, *includes, *more, *packages],
                          stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, check=False)
    if done.returncode not in (0, 1):
        raise Failure(f"tzc-rewrite ends with {done.returncode}:\n" + done.stderr.decode(errors="replace")[-3000:])
    with open(report) as file:
        written = json.load(file)
    reports = written.get("packages", [written])
    return {"sites": [site for one in reports for site in one["sites"]],
            "files_changed": sum(one["summary"]["files_changed"] for one in reports)}


# What programs do with a std::vector by name, on purpose; the only reason why a port may not compile.
BY_NAME = re.compile(r"no matching function for call to 'fill'|to type 'std::vector<")


def must_be_ported(site, may_be_plain):
    if site["code"] in ("TZC1009", "TZC2005") and not BY_NAME.search(site["reason"]):
        return True
    return site["level"] == "plain" and not may_be_plain


def check_levels(report, may_be_plain=False):
    """No site stays on TCPROS, and what the rules write compiles with the real headers."""
    wrong = [site for site in report["sites"] if must_be_ported(site, may_be_plain)]
    if wrong:
        raise Failure("these sites must be ported:\n" + "\n".join(
            f"  {site['file']}:{site['line']} {site['kind']} {site['level']} {site['code']} {site['reason']}"
            for site in wrong[:10]))


def contents(folder):
    """path -> its bytes, of all files below a folder."""
    files = {}
    for path, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(path, name), "rb") as file:
                files[os.path.join(path, name)] = file.read()
    return files


def lasting_sites(sites):
    """What of each site stays when the port is applied."""
    return [(site["id"], site["kind"], site["message_type"], site["topic"], site["level"],
             site["code"]) for site in sites]


# How each kind of site is written; a count by text that knows nothing of C++.
WRITTEN = {"publish": r"\bpublish(?:<[^<>;]*>)?\(", "advertise": r"\badvertise(?:Camera)?(?:<|\()",
           "subscribe": r"\bsubscribe(?:<[^(]*>)?\(|new message_filters::Subscriber<"}


def check_sites(source_space, report):
    """Every site of the packages is in the report exactly once."""
    text = ""
    for folder, _, names in os.walk(source_space):
        for name in names:
            if name.endswith((".h", ".cpp")):
                with open(os.path.join(folder, name)) as file:
                    text += file.read()
    for kind, pattern in WRITTEN.items():
        written = len(re.findall(pattern, text))
        reported = sum(1 for site in report["sites"] if site["kind"] == kind)
        if written != reported:
            raise Failure(f"{written} {kind} sites are written, {reported} are in the report")
