# SPDX-License-Identifier: BSD-3-Clause
"""Prints the levels of the sites in reports of tzc-rewrite, one line for each package.

usage: site_table.py REPORT.json...

Exit status 1: a publish site is plain, or a subscribe site neither shared nor copied nor not_needed.
"""
import collections
import json
import sys

PUBLISH = ["zero_copy", "one_copy", "plain", "not_needed"]
SUBSCRIBE = ["shared", "copied", "plain", "not_needed"]


def packages(paths):
    for path in paths:
        with open(path) as file:
            report = json.load(file)
        yield from report if isinstance(report, list) else report.get("packages", [report])


def count(sites, kind):
    return collections.Counter(site["level"] for site in sites if site["kind"] == kind)


def row(name, publish, subscribe):
    cells = [f"{publish[level]:>11}" for level in PUBLISH] + [f"{subscribe[level]:>11}" for level in SUBSCRIBE]
    return f"{name:<20}" + "".join(cells)


def main():
    total_publish, total_subscribe = collections.Counter(), collections.Counter()
    print(f"{'':<20}{'publish':>11}{'':>33}{'subscribe':>11}")
    print(f"{'package':<20}" + "".join(f"{level:>11}" for level in PUBLISH + SUBSCRIBE))
    for report in packages(sys.argv[1:]):
        publish, subscribe = count(report["sites"], "publish"), count(report["sites"], "subscribe")
        print(row(report["package"], publish, subscribe))
        total_publish += publish
        total_subscribe += subscribe
    print(row("all", total_publish, total_subscribe))
    heavy = sum(total_publish[level] for level in PUBLISH[:3])
    if heavy:
        print(f"zero_copy: {100 * total_publish['zero_copy'] / heavy:.0f} % of {heavy} publish sites")
    return 1 if total_publish["plain"] or total_subscribe["plain"] else 0


if __name__ == "__main__":
    sys.exit(main())
