#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The headers of instructive definitions, kept under expected/: a person should be able to read them.

usage: golden_test.py TZC_MSGGEN                                         compare
       golden_test.py TZC_MSGGEN --compile COMPILER FLAGS... -- LIBS...  compile and run use.cpp with gencpp's stock headers

TZC_UPDATE_GOLDEN=1 in the environment writes expected/ anew before it is compared: look at the diff.
"""
import difflib
import glob
import os
import shutil
import subprocess
import sys
import tempfile

here = os.path.dirname(os.path.abspath(__file__))
tool = os.path.abspath(sys.argv[1])
definitions = sorted(glob.glob(f'{here}/msg/*.msg') + glob.glob(f'{here}/srv/*.srv'))


def std_msgs():
    for share in ['/usr/share'] + glob.glob('/opt/ros/*/share'):
        if os.path.isdir(f'{share}/std_msgs/msg'):
            return f'std_msgs:{share}/std_msgs/msg'
    sys.exit('std_msgs is not installed')


def generate(out):
    subprocess.run([tool, 'generate', '-p', 'demo', '-I', std_msgs(), '-o', out] + definitions, check=True)


def tree(folder):
    paths = sorted(glob.glob(f'{folder}/**/*.h', recursive=True))
    return {os.path.relpath(p, folder): open(p, encoding='utf-8').read() for p in paths}


def compare():
    with tempfile.TemporaryDirectory() as scratch:
        generate(scratch)
        actual, expected = tree(scratch), tree(f'{here}/expected')
        different = [n for n in sorted(set(actual) | set(expected)) if actual.get(n) != expected.get(n)]
        for name in different:
            a, b = expected.get(name, '').splitlines(), actual.get(name, '').splitlines()
            print('\n'.join(difflib.unified_diff(a, b, f'expected/{name}', 'actual', lineterm='')))
    print(f'{len(expected)} golden headers')
    if different:
        sys.exit(f'{len(different)} differ; if that is intended, run this test with TZC_UPDATE_GOLDEN=1 and look at the diff')


def compile_and_run(compiler, flags, libraries):
    gencpp = [p for p in ['/usr/lib/gencpp/gen_cpp.py'] + glob.glob('/opt/ros/*/lib/gencpp/gen_cpp.py') if os.path.exists(p)]
    templates = [p for p in ['/usr/share/gencpp'] + glob.glob('/opt/ros/*/share/gencpp') if os.path.isdir(p)]
    with tempfile.TemporaryDirectory() as scratch:
        generate(f'{scratch}/include')
        for definition in definitions:
            subprocess.run(['/usr/bin/python3', gencpp[0], definition, f'-Idemo:{here}/msg', '-I' + std_msgs(), '-p', 'demo',
                            '-o', f'{scratch}/stock/demo', '-e', templates[0]], check=True)
        program = f'{scratch}/use'
        subprocess.run([compiler, '-std=c++14', '-Wall', '-Wextra', '-Werror', f'-I{scratch}/include',
                        f'-isystem{scratch}/stock'] + flags + [f'{here}/use.cpp', f'{here}/use_again.cpp', '-o', program]
                       + libraries, check=True)
        subprocess.run([program], check=True)


if '--compile' in sys.argv:
    rest = sys.argv[sys.argv.index('--compile') + 1:]
    split = rest.index('--')
    compile_and_run(rest[0], rest[1:split], rest[split + 1:])
else:
    if os.environ.get('TZC_UPDATE_GOLDEN') == '1':
        shutil.rmtree(f'{here}/expected')
        generate(f'{here}/expected')
    compare()
