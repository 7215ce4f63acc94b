# SPDX-License-Identifier: BSD-3-Clause
"""Compares the messages of two bags field by field; stamps and sequence numbers aside.

usage: compare_bags.py FIRST.bag SECOND.bag

Recordings begin at different frames, so each message of one bag is looked for in the other by its content; the messages
that both recorded must be in the same order, there must be some, and at no place may each bag have others. Exit status 0: equal.
"""
import difflib
import hashlib
import sys

import genpy
import rosbag


def content(message):
    """Every field but header.stamp and header.seq, as bytes."""
    if hasattr(message, "header"):
        message.header.stamp = genpy.Time()
        message.header.seq = 0
    digest = hashlib.sha256()
    for slot in message.__slots__:
        value = getattr(message, slot)
        digest.update(slot.encode() + b"=" + (value if isinstance(value, bytes) else repr(value).encode()) + b"\n")
    return digest.hexdigest()


def contents(path):
    with rosbag.Bag(path) as bag:
        return [content(message) for _, message, _ in bag.read_messages()]


def difference(first, second):
    """What is different between two recordings of the same messages, in words; None: nothing.

    One may have begun earlier, ended later, or lost messages. Where both have messages that the other one has not, they
    are not the same. A source that repeats itself hides which message was lost, so nothing may be."""
    common = set(first) & set(second)
    if not common:
        return f"no message of one bag is in the other ({len(first)} and {len(second)} messages)"
    in_first, in_second = ([entry for entry in part if entry in common] for part in (first, second))
    others = len(first) + len(second) - len(in_first) - len(in_second)
    if others and len(common) < max(len(in_first), len(in_second)):
        return f"{others} messages are in one bag only, though the source repeats itself"
    if in_first != in_second and len(common) > 1:
        return "the same messages stand in different order or number"
    steps = difflib.SequenceMatcher(None, first, second, autojunk=False).get_opcodes()
    changed = [f"message {a + 1} of the first bag, {b + 1} of the second" for kind, a, _, b, _ in steps if kind == "replace"]
    return f"different content: {'; '.join(changed)}" if changed else None


def main():
    first, second = contents(sys.argv[1]), contents(sys.argv[2])
    found = difference(first, second)
    if found:
        print(found)
        return 1
    both = sum(entry in set(first) for entry in second)
    print(f"the bags are equal field by field in the {both} messages that both recorded (stamps aside)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
