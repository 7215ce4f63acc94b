# SPDX-License-Identifier: BSD-3-Clause
"""The table of all repositories."""
import collections

HEAD = ["repository", "packages", "units", "publish z/1/p/n", "subscribe s/c/p/n", "large z/1/p", "lines", "tests", "runs",
        "time/s", "x syntax", "MB", "problems"]
LEGEND = """units: compiled before, after; publish: zero_copy/one_copy/plain/not_needed; subscribe: shared/copied/plain/not_needed;
large: publish sites of types that are large in use; lines: median of the lines changed in a package; tests: passed of all before,
after; time: processor seconds of tzc-rewrite, and of the compilers and CMake that it started; x syntax: the former over those of
clang++-19 -fsyntax-only on the same units; MB: the most that tzc-rewrite held, and the largest of the programs that it started"""


def levels(counts, kind, names):
    return "/".join(str(counts.get(f"{kind} {name}", 0)) for name in names)


def of_tests(result):
    if "tests_before" not in result:
        return "-"
    return ", ".join("{}/{}".format(*result.get(f"tests_{version}", ("?", "?"))) for version in ("before", "after"))


def row(result):
    counts = result.get("sites", {}).get("counts", {})
    seconds, own, syntax = (result.get(f"{which}_seconds") for which in ("rewrite", "own", "syntax"))
    left_out = len(result.get("left_out", {}))
    return [result["name"], f"{len(result.get('packages', []))}" + (f" (-{left_out})" if left_out else ""),
            f"{result.get('compiled', '-')}, {result.get('compiled_after', '-')}",
            levels(counts, "publish", ("zero_copy", "one_copy", "plain", "not_needed")),
            levels(counts, "subscribe", ("shared", "copied", "plain", "not_needed")),
            levels(counts, "large", ("zero_copy", "one_copy", "plain")),
            f"{result.get('sites', {}).get('median_lines', '-')}", of_tests(result), result.get("compare", "-"),
            f"{own:.0f}+{seconds - own:.0f}" if seconds and own is not None else "-",
            f"{own / syntax:.2f}" if own and syntax else "-",
            "{}, {}".format(*result["megabytes"]) if "megabytes" in result else "-", str(len(result["problems"]))]


def total(results):
    counts = collections.Counter()
    for result in results:
        counts.update(result.get("sites", {}).get("counts", {}))
    large = sum(counts[f"large {level}"] for level in ("zero_copy", "one_copy", "plain"))
    if not large:
        return []
    return [f"large publish sites: {large}; zero_copy {100 * counts['large zero_copy'] / large:.0f} %, "
            f"one_copy {counts['large one_copy']}, plain {counts['large plain']}"]


def table(results):
    rows = [HEAD, *map(row, results)]
    widths = [max(len(line[column]) for line in rows) for column in range(len(HEAD))]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() for line in rows]
    lines += [*total(results), LEGEND]
    for result in results:
        lines += [f"{result['name']}: {name} is left out: {reason}" for name, reason in result.get("left_out", {}).items()]
        lines += [f"{result['name']}: {problem}" for problem in result["problems"]]
    return "\n".join(lines) + "\n"
