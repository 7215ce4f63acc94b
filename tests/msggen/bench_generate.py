#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How long the headers of all installed message packages take: tzc-msggen against genmsg + gencpp, in one run.

usage: bench_generate.py TZC_MSGGEN [WANTED_RATIO]

tzc-msggen runs once for everything, as the project's build does, and once per definition, as genmsg's plugin does in a
catkin package. gencpp is run as its CMake macros run it, one process per definition. For the kindest comparison also
genmsg and gencpp in one process, without starting Python each time. Fails when gencpp's time divided by ours is less than
WANTED_RATIO (20).
"""
import glob
import os
import subprocess
import sys
import tempfile
import time

import genmsg.template_tools

tool = os.path.abspath(sys.argv[1])
wanted = float(sys.argv[2]) if len(sys.argv) > 2 else 20
share = '/usr/share'
if not os.path.isdir(f'{share}/gencpp'):
    share = glob.glob('/opt/ros/*/share')[0]
gen_cpp = [p for p in (f'{os.path.dirname(share)}/lib/gencpp/gen_cpp.py', f'{share}/gencpp/cmake/gen_cpp.py')
           if os.path.exists(p)][0]
templates = f'{share}/gencpp'


def definitions():
    """(package, file) of every definition; an action's messages are installed beside it."""
    files = sorted(glob.glob(f'{share}/*/msg/*.msg') + glob.glob(f'{share}/*/srv/*.srv'))
    return [(os.path.basename(os.path.dirname(os.path.dirname(f))), f) for f in files]


def include_flags():
    return [f'-I{os.path.basename(os.path.dirname(d))}:{d}' for d in sorted(glob.glob(f'{share}/*/msg'))]


def clock(action):
    start = time.monotonic()
    action()
    return time.monotonic() - start


def run_gencpp(files, flags, out):
    for package, file in files:
        subprocess.run(['/usr/bin/python3', gen_cpp, file, *flags, '-p', package, '-o', f'{out}/{package}', '-e', templates],
                       check=True, stdout=subprocess.DEVNULL)


def run_gencpp_in_process(files, flags, out):
    for package, file in files:
        genmsg.template_tools.generate_from_file(file, package, f'{out}/{package}', templates,
                                                 [f[2:] for f in flags], {'msg.h.template': '@NAME@.h'},
                                                 {'srv.h.template': '@NAME@.h'})


def run_each(files, flags, out):
    for package, file in files:
        subprocess.run([tool, 'generate', '-p', package, *flags, '-o', out, file], check=True)


def run_all(out):
    subprocess.run([tool, 'generate', '--installed', '-o', out], check=True, stdout=subprocess.DEVNULL)


def main():
    files, flags = definitions(), include_flags()
    with tempfile.TemporaryDirectory() as scratch:
        ours = min(clock(lambda i=i: run_all(f'{scratch}/all{i}')) for i in range(3))
        each = clock(lambda: run_each(files, flags, f'{scratch}/each'))
        in_process = clock(lambda: run_gencpp_in_process(files, flags, f'{scratch}/inside'))
        theirs = clock(lambda: run_gencpp(files, flags, f'{scratch}/gencpp'))
        made = len(glob.glob(f'{scratch}/all0/tzc/*/*.h'))
    print(f'{len(files)} definitions, {made} headers; seconds (and how many times faster than gencpp)')
    print(f'  genmsg + gencpp, a process each   {theirs:8.3f}')
    print(f'  genmsg + gencpp, one process      {in_process:8.3f}  ({theirs / in_process:.1f})')
    print(f'  tzc-msggen, a process each        {each:8.3f}  ({theirs / each:.1f})')
    print(f'  tzc-msggen generate --installed   {ours:8.3f}  ({theirs / ours:.1f}; '
          f'{in_process / ours:.1f} times faster than gencpp in one process)')
    if theirs / ours < wanted:
        sys.exit(f'FAILED: not {wanted} times faster')


main()
