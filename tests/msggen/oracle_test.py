#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares tzc-msggen with genmsg, for every definition of every message package on this machine.

usage: oracle_test.py DUMP_PROGRAM MINIMUM MUTANTS

Every installed .msg, .srv and .action: md5sum, full text, fields, constants, and whether the type is fixed-length (asked
of gencpp, which makes roscpp's IsFixedSize). Then MUTANTS damaged definitions: what we accept means the same to genmsg,
and what genmsg accepts we refuse only for a reason that C++ or ROS has.
"""
import ast
import collections
import glob
import json
import os
import random
import re
import subprocess
import sys
import tempfile

import gencpp
import genmsg
import genmsg.gentools
import genmsg.msg_loader

failures = []


def check(name, what, ours, theirs):
    if ours != theirs:
        failures.append(f'{name}: {what} differs\n  ours:   {ours!r}\n  theirs: {theirs!r}')


def search_path(files):
    path = collections.defaultdict(list)
    for file in files:
        folder = os.path.dirname(os.path.abspath(file))
        package, kind = os.path.basename(os.path.dirname(folder)), os.path.basename(folder)
        if kind == 'msg' and folder not in path[package]:
            path[package].append(folder)
    return path


def actionlib_generator():
    """actionlib's own program that turns an action into seven messages."""
    for candidate in glob.glob('/usr/lib/actionlib_msgs/genaction.py') + glob.glob(
            '/opt/ros/*/lib/actionlib_msgs/genaction.py') + glob.glob('/opt/ros/*/share/actionlib_msgs/cmake/genaction.py'):
        return candidate
    sys.exit('actionlib_msgs/genaction.py is not installed')


def messages_of(file, package, scratch):
    """(full name, message spec) of all messages in a file, as genmsg or actionlib make them; and the service spec."""
    context = genmsg.msg_loader.MsgContext.create_default()
    name = os.path.splitext(os.path.basename(file))[0]
    full_name = f'{package}/{name}'
    if file.endswith('.msg'):
        return context, [genmsg.msg_loader.load_msg_from_file(context, file, full_name)], None
    if file.endswith('.srv'):
        service = genmsg.msg_loader.load_srv_from_file(context, file, full_name)
        return context, [service.request, service.response], service
    subprocess.run(['/usr/bin/python3', actionlib_generator(), file, '-o', scratch], check=True,
                   stdout=subprocess.DEVNULL)
    specs = []
    for suffix in 'Action ActionGoal ActionResult ActionFeedback Goal Result Feedback'.split():
        specs.append(genmsg.msg_loader.load_msg_from_file(context, f'{scratch}/{name}{suffix}.msg', full_name + suffix))
    return context, specs, None


def python_value(constant):
    """Our spelling of a constant's value as genmsg's."""
    type_, name, text, value = constant
    if type_ == 'string':
        return (type_, name, text, value)
    if type_ == 'bool':
        return (type_, name, text, value == '1')
    if type_.startswith('float'):
        return (type_, name, text, repr(float(value)))
    return (type_, name, text, int(value))


def theirs_value(constant):
    value = repr(constant.val) if constant.type.startswith('float') else constant.val
    return (constant.type, constant.name, constant.val_text, value)


def compare(ours, spec, context, path):
    name = spec.full_name
    check(name, 'md5sum', ours['md5'], genmsg.gentools.compute_md5(context, spec))
    check(name, 'full text', ours['full_text'], genmsg.gentools.compute_full_text(context, spec))
    check(name, 'fields', [tuple(f) for f in ours['fields']], list(zip(spec.types, spec.names)))
    check(name, 'constants', [python_value(c) for c in ours['constants']], [theirs_value(c) for c in spec.constants])
    check(name, 'fixed length', ours['fixed_length'], gencpp.is_fixed_length(spec, context, path))


def compare_installed(dump, minimum):
    ours = json.loads(subprocess.run([dump], check=True, stdout=subprocess.PIPE).stdout)
    files = glob_definitions()
    path = search_path(files)
    kinds, seen = collections.Counter(), set()
    with tempfile.TemporaryDirectory() as scratch:
        for file in files:
            package = os.path.basename(os.path.dirname(os.path.dirname(file)))
            context, specs, service = messages_of(file, package, scratch)
            scratch_path = dict(path, **{package: path[package] + [scratch]})
            kinds[os.path.splitext(file)[1]] += 1
            for spec in specs:
                genmsg.msg_loader.load_depends(context, spec, scratch_path)
                seen.add(spec.full_name)
                if spec.full_name not in ours['messages']:
                    failures.append(f'{spec.full_name}: not found by us')
                    continue
                compare(ours['messages'][spec.full_name], spec, context, scratch_path)
            if service:
                seen.add(service.full_name)
                check(service.full_name, 'md5sum', ours['services'].get(service.full_name),
                      genmsg.gentools.compute_md5(context, service))
    extra = (set(ours['messages']) | set(ours['services'])) - seen
    for name in sorted(extra):
        failures.append(f'{name}: found by us only')
    print(f'compared {len(seen)} definitions ({len(ours["messages"])} messages, {len(ours["services"])} services) from '
          f'{dict(kinds)} files of {len(set(n.split("/")[0] for n in seen))} packages')
    if len(seen) < minimum:
        failures.append(f'only {len(seen)} definitions were compared, at least {minimum} are wanted: are all message '
                        'packages of scripts/packages.txt installed?')
    return files


def glob_definitions():
    """Independent of our own search: every file in a folder's msg/, srv/ and action/."""
    roots = [r for r in os.environ.get('TZC_ORACLE_SHARE', '/usr/share').split(':') if r]
    files = []
    for root in roots:
        for kind in ('msg', 'srv', 'action'):
            files += sorted(glob.glob(f'{root}/*/{kind}/*.{kind}'))
    return files


def mutate(text, rng):
    """A definition with a few small faults; the alphabet is that of the language."""
    alphabet = ' \t\n#=[]/_-+.0123456789aZ\u00a0\r"\\'
    snippets = ['uint8 ', 'string ', 'Header ', 'float64 ', 'bool ', 'X=', '=1', '[3]', '[]', '# ', ' \t', 'time ', '\r\n',
                'True', '1e5', '1_000', '--', '\u2003']
    for _ in range(rng.randint(1, 3)):
        at = rng.randint(0, len(text))
        kind = rng.random()
        if kind < 0.4:
            text = text[:at] + rng.choice(alphabet) + text[at:]
        elif kind < 0.6:
            text = text[:at] + rng.choice(snippets) + text[at:]
        elif kind < 0.8:
            text = text[:at] + text[at + rng.randint(1, 4):]
        else:
            lines = text.split('\n')
            lines.insert(rng.randint(0, len(lines)), rng.choice(lines))
            text = '\n'.join(lines)
    return text


# Why we refuse what genmsg takes: genmsg does not look at these, the C++ compiler or roscpp would.
ALLOWED_REFUSALS = re.compile(
    "name '.*' (is empty|does not begin|may contain|is a C\\+\\+ keyword)|duplicate name|circular|takes more than 4 GiB|"
    "is too long|does not fit into|has no name|are no array bounds|byte order mark|not text|"
    "unknown (type|package)|not a value for u?int64", re.S)


def is_no_literal(faults):
    """Whether something is refused that genmsg evaluates as a bool, and that is more of Python than a number."""
    refused = re.search(r"'(.*)' is not a value for bool", faults)
    if not refused:
        return False
    node = ast.parse(refused.group(1).strip(), mode='eval').body
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.UAdd, ast.USub)):
        node = node.operand
    return not (isinstance(node, ast.Constant) and type(node.value) in (bool, int, float))


def genmsg_reads(file, package, path):
    context = genmsg.msg_loader.MsgContext.create_default()
    spec = genmsg.msg_loader.load_msg_from_file(context, file, f'{package}/{os.path.basename(file)[:-4]}')
    genmsg.msg_loader.load_depends(context, spec, path)
    return context, spec


def compare_mutants(dump, files, count):
    rng = random.Random(20)
    path = search_path(files)
    texts = [open(f, encoding='utf-8').read() for f in files if f.endswith('.msg')]
    accepted = refused = stricter = 0
    with tempfile.TemporaryDirectory() as folder:
        names = [f'{folder}/M{i}.msg' for i in range(count)]
        for name in names:
            with open(name, 'w', encoding='utf-8', newline='') as out:
                out.write(mutate(rng.choice(texts), rng))
        batch = json.loads(subprocess.run([dump, 'sensor_msgs'] + names, check=True, stdout=subprocess.PIPE).stdout)
        for name in names:
            ours = batch[name]
            try:
                context, spec = genmsg_reads(name, 'sensor_msgs', path)
            except Exception as error:  # genmsg raises whatever comes to hand
                check(name, f'refusal ({error})', ours['accepted'], False)
                refused += 1
                continue
            if not ours['accepted']:
                stricter += 1
                if not ALLOWED_REFUSALS.search(ours['faults']) and not is_no_literal(ours['faults']):
                    failures.append(f'refused without need:\n{ours["faults"]}')
                continue
            accepted += 1
            compare(ours['messages'][spec.full_name], spec, context, path)
    print(f'{count} mutants: {accepted} accepted by both and compared, {refused} refused by both, '
          f'{stricter} refused by us alone')


def main():
    dump, minimum, mutants = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    files = compare_installed(dump, minimum)
    compare_mutants(dump, files, mutants)
    for failure in failures[:20]:
        print('FAILED', failure)
    if failures:
        sys.exit(f'{len(failures)} differences')


main()
