#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input: each file of bad/ is one golden case (tests/support/golden_case.py), with the tool's complaint word for word
as its expectation.

usage: bad_input_test.py TZC_MSGGEN ROS_SHARE_DIR

A case's files are given to `tzc-msggen generate -p demo -o OUT`, unless its section `args` holds other arguments. The exit
status must be 1 (2 for bad usage), and OUT must not come into being. TZC_UPDATE_GOLDEN=1 in the environment writes the
expectations anew: look at the diff.
"""
import difflib
import glob
import os
import re
import subprocess
import sys
import tempfile

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, f'{here}/../support')
from golden_case import GoldenCase  # noqa: E402

tool, share = os.path.abspath(sys.argv[1]), os.path.realpath(sys.argv[2])


def run(case, folder, out):
    files = [name for name in case.sections if name != 'args']
    case.write_sections(folder, files)
    given = sorted(name for name in files if re.fullmatch(r'[^/]*\.(msg|srv|action|txt)', name))
    arguments = case.sections.get('args', '').split() or ['generate', '-p', 'demo', '-o', 'OUT'] + given
    variables = {k: v for k, v in os.environ.items() if k not in ('ROS_PACKAGE_PATH', 'CMAKE_PREFIX_PATH')}
    result = subprocess.run([tool] + [a.replace('OUT', out) for a in arguments], cwd=folder, env=variables,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    return result.returncode, result.stderr.replace(share, 'ROS_SHARE').replace(out, 'OUT')


def check(path):
    case = GoldenCase(path)
    with tempfile.TemporaryDirectory() as scratch:
        os.mkdir(f'{scratch}/in')
        status, text = run(case, f'{scratch}/in', f'{scratch}/out')
        written = [f for _, _, files in os.walk(f'{scratch}/out') for f in files]
    problems = []
    if status not in (1, 2):
        problems.append(f'exit status {status}')
    if written:
        problems.append(f'files were written: {written}')
    expected = case.expected(text)
    if text != expected:
        problems += difflib.unified_diff(expected.splitlines(), text.splitlines(), 'expected', 'actual', lineterm='')
    return [f'{os.path.basename(path)}: {p}' for p in problems]


def main():
    cases = sorted(glob.glob(f'{here}/bad/*.case'))
    problems = [p for path in cases for p in check(path)]
    print('\n'.join(problems))
    print(f'{len(cases)} cases')
    sys.exit(1 if problems or len(cases) < 30 else 0)


main()
