# SPDX-License-Identifier: BSD-3-Clause
"""What a check finds, and the exceptions that are granted."""
from collections import namedtuple

# subject: what an exception names; it does not change when lines move. where: path:line, or a path, or a name.
Problem = namedtuple("Problem", "subject where text")


def read_exceptions(lines):
    """Lines `check subject: reason` -> {check: {subject: reason}}. `#` starts a comment line."""
    exceptions = {}
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.startswith("#"):
            continue
        name, subject, reason = _parse(line, number)
        exceptions.setdefault(name, {})[subject] = reason
    return exceptions


def _parse(line, number):
    name, _, rest = line.strip().partition(" ")
    subject, separator, reason = rest.partition(": ")
    if not separator or not reason.strip():
        raise SystemExit(f"exceptions.txt:{number}: write `check subject: reason`, and give a reason")
    return name, subject.strip(), reason.strip()


def judge(problems, granted):
    """The complaints: problems that no exception covers, and exceptions that cover no problem."""
    problems = list(problems)
    for problem in problems:
        if problem.subject not in granted:
            yield f"{problem.where}: {problem.text}"
    subjects = {problem.subject for problem in problems}
    for subject in granted:
        if subject not in subjects:
            yield f"exceptions.txt: '{subject}' is no longer a problem: remove the exception"
