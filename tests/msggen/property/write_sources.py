#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the property tests' sources: one TEST per installed message type, spread over COUNT files.

usage: write_sources.py TZC_MSGGEN SHARE_DIR OUT_DIR COUNT [--every-type]

Without --every-type, most types without a data part are left out: tzc-msggen writes the same for all of them.
Files whose content would not change are left alone.
"""
import glob
import json
import os
import subprocess
import sys

msggen, share, out, count = sys.argv[1], sys.argv[2], sys.argv[3], int(sys.argv[4])
every_type = sys.argv[5:] == ['--every-type']


def all_types():
    folders = sorted({os.path.dirname(f) for k in ('msg', 'srv', 'action') for f in glob.glob(f'{share}/*/{k}/*.{k}')})
    census = json.loads(subprocess.run([msggen, 'classify', '--json'] + folders, check=True, stdout=subprocess.PIPE).stdout)
    return sorted(census['types'].items())


def source(types):
    lines = ['// Written by write_sources.py.\n', '#include "check.h"\n']
    lines += [f'#include <tzc/{t}.h>\n' for t, _ in types]
    for t, facts in types:
        package, name = t.split('/')
        fixed = 'true' if facts['fixed_length'] else 'false'
        lines.append(f'TEST(Properties, {package}_{name}) {{\n'
                     f'  tzc::test::check_type<::tzc::{package}::{name}, ::{package}::{name}>("{facts["md5"]}", {fixed});\n'
                     '}\n')
    return ''.join(lines)


def write(path, text):
    if os.path.exists(path) and open(path, encoding='utf-8').read() == text:
        return
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)


types = all_types()
if len(types) < 280:
    sys.exit(f'only {len(types)} message types under {share}: are all message packages installed?')
if not every_type:
    without_data = [item for item in types if not item[1]['has_data_part']]
    types = sorted([item for item in types if item[1]['has_data_part']] + without_data[::8])
os.makedirs(out, exist_ok=True)
for i in range(count):
    write(f'{out}/properties_{i}.cpp', source(types[i::count]))
