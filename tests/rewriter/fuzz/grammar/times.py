# SPDX-License-Identifier: BSD-3-Clause
"""When a handle is used, in the order of the publishes. Each is given the attack and returns its statements: those that
make the handle are `attack.make()`, those that publish are `attack.send()`."""
from .fills import in_block
from .program import indented


# The handle is made once, and what takes the elements over may follow it
# ----------------------------------------------------------------------------------------------------------------------


def before(attack):
    return attack.make() + attack.write(1) + attack.send()


def after(attack):
    return attack.make() + attack.send() + attack.write(1) + attack.send()


def before_and_after(attack):
    return attack.make() + attack.write(1) + attack.send() + attack.write(2) + attack.send()


def in_loop(attack):
    return (attack.make() + ["for (int turn = 0; turn < 2; ++turn) {"] +
            indented(attack.write("(1 + turn)") + attack.send()) + ["}"])


def in_endless_loop(attack):
    return (attack.make() + ["for (int turn = 0;; ++turn) {", "  if (turn == 3) break;", "  if (turn == 1) continue;"] +
            indented(attack.write("(1 + turn)") + attack.send()) + ["}"])


def by_goto(attack):
    label = attack.program.unique("again")
    return (["int turn = 0;"] + attack.make() + [f"{label}:"] + attack.write("(1 + turn)") + attack.send() +
            [f"if (++turn < 2) goto {label};"])


def after_branch(attack):
    return attack.make() + ["if (k % 2) {"] + indented(attack.send()) + ["}"] + attack.write(1) + attack.send()


def after_switch(attack):
    return (attack.make() + ["switch (k % 3) {", "  case 0:"] + indented(attack.send()) +
            ["    // falls through", "  case 1:"] + indented(attack.write(3)) + ["    break;", "  default:"] +
            indented(attack.send()) + ["}"] + attack.write(1) + attack.send())


def after_exception(attack):
    return (attack.make() + ["try {"] + indented(attack.send()) + ["  throw 2;", "} catch (int) {"] +
            indented(attack.write(1)) + ["}"] + attack.send())


def in_other_branch(attack):
    """Harmless: no path both publishes and writes afterwards."""
    return attack.make() + ["if (k % 2) {"] + indented(attack.send()) + ["} else {"] + indented(
        attack.write(1) + attack.send()) + ["}"]


def in_index(attack):
    """The publish is part of the expression that writes."""
    publish = "([&] { " + " ".join(attack.send()) + " return 1; }())"
    return attack.make() + attack.write(publish) + attack.send()


def in_value(attack):
    publish = "[&] { " + " ".join(attack.send()) + f" return {attack.value}; }}()"
    return attack.make() + attack.write(1, publish) + attack.send()


def read_after(attack):
    """What was written through the message in between is read through the handle, and the other way round."""
    read = attack.read(4)
    if not read:
        return after(attack)
    lines = attack.make() + attack.send() + [f"{attack.array}[4] = {attack.value};"]
    return lines + [f"{{ {attack.element} r = {attack.read(4)}; {attack.array}[5] = r; }}"] + attack.send()


def after_shrinking(attack):
    return attack.make() + attack.send() + [f"{attack.array}.resize(10);"] + attack.write(1) + attack.send()


def after_refilling(attack):
    return (attack.make() + attack.send() + [f"{attack.array}.pop_back();", f"{attack.array}.push_back({attack.value});"] +
            attack.write(1) + attack.send())


def after_growing(attack):
    """Within the reserved memory, so that a vector stays where it is."""
    return attack.make() + [f"{attack.array}.push_back({attack.value});"] + attack.write(1) + attack.send()


def after_growing_and_publish(attack):
    return (attack.make() + attack.send() + [f"{attack.array}.push_back({attack.value});"] + attack.write(1) +
            attack.send())


ONCE = [before, before, after, before_and_after, in_loop, in_endless_loop, by_goto, after_branch, after_switch,
        after_exception, in_other_branch, in_index, in_value, read_after, after_shrinking, after_refilling, after_growing,
        after_growing_and_publish]


# The handle is made anew, or beside the publish
# ----------------------------------------------------------------------------------------------------------------------


def between(attack):
    return attack.send() + attack.make() + attack.write(2) + attack.send()


def made_in_loop(attack):
    return (["for (int turn = 0; turn < 2; ++turn) {"] +
            indented(attack.make() + attack.write("(1 + turn)") + attack.send()) + ["}"])


def ends_in_block(attack):
    return in_block(attack.make() + attack.write(1)) + attack.send()


def ends_in_block_after(attack):
    return attack.send() + in_block(attack.make() + attack.write(1)) + attack.send()


def through_closure(attack):
    return (["auto send = [&] {"] + indented(attack.send()) + ["};"] + attack.make() + ["send();"] + attack.write(1) +
            ["send();"])


def in_range_loop(attack):
    """The loop itself keeps iterators."""
    return (["int turn = 0;", f"for (auto& one : {attack.array}) {{", "  if (++turn > 2) break;"] + indented(
        attack.send()) + [f"  one = {attack.value};", "}"] + attack.make() + attack.write(3) + attack.send())


def in_iterator_loop(attack):
    return ([f"for (auto it = {attack.array}.begin(); it != {attack.array}.begin() + 2; ++it) {{",
             f"  *it = {attack.value};"] + indented(attack.send()) + ["}"] + attack.make() + attack.write(3) +
            attack.send())


def destroyed_after(attack):
    """The handle ends, and may act, between two publishes."""
    return in_block(attack.make() + attack.write(1) + attack.send() + attack.write(2)) + attack.send()


ANEW = [between, made_in_loop, made_in_loop, ends_in_block, ends_in_block, ends_in_block_after, through_closure,
        in_range_loop, in_iterator_loop, destroyed_after]

# No handle is used after a publish that was there when it was made.
HARMLESS = [before, before, made_in_loop, ends_in_block, ends_in_block_after, between, in_other_branch]
