#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input: each folder of bad/ is one case, the tool's complaint word for word in its `expected`.

usage: bad_input_test.py TZC_MSGGEN ROS_SHARE_DIR [--update]

A case's files are given to `tzc-msggen generate -p demo -o OUT`, unless its `args` holds other arguments. The exit status
must be 1 (2 for bad usage), and OUT must not come into being. --update writes the `expected` files anew: look at the diff.
"""
import difflib
import os
import re
import subprocess
import sys
import tempfile

tool, share = os.path.abspath(sys.argv[1]), os.path.realpath(sys.argv[2])
update = '--update' in sys.argv
cases = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'bad')


def read(path, default=''):
    if not os.path.exists(path):
        return default
    with open(path, encoding='utf-8') as file:
        return file.read()


def run(case, out):
    files = sorted(f for f in os.listdir(case) if re.search(r'\.(msg|srv|action|txt)$', f))
    arguments = read(f'{case}/args').split() or ['generate', '-p', 'demo', '-o', 'OUT'] + files
    variables = {k: v for k, v in os.environ.items() if k not in ('ROS_PACKAGE_PATH', 'CMAKE_PREFIX_PATH')}
    result = subprocess.run([tool] + [a.replace('OUT', out) for a in arguments], cwd=case, env=variables,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    text = result.stderr.replace(share, 'ROS_SHARE').replace(out, 'OUT')
    return result.returncode, text


def check(name):
    case = f'{cases}/{name}'
    with tempfile.TemporaryDirectory() as scratch:
        status, text = run(case, f'{scratch}/out')
        written = [f for _, _, files in os.walk(f'{scratch}/out') for f in files]
    if update:
        with open(f'{case}/expected', 'w', encoding='utf-8') as file:
            file.write(text)
        return []
    problems = []
    if status not in (1, 2):
        problems.append(f'exit status {status}')
    if written:
        problems.append(f'files were written: {written}')
    expected = read(f'{case}/expected')
    if text != expected:
        problems += difflib.unified_diff(expected.splitlines(), text.splitlines(), 'expected', 'actual', lineterm='')
    return [f'{name}: {p}' for p in problems]


def main():
    names = sorted(os.listdir(cases))
    problems = [p for name in names for p in check(name)]
    print('\n'.join(problems))
    print(f'{len(names)} cases')
    sys.exit(1 if problems or len(names) < 30 else 0)


main()
