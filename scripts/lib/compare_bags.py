# SPDX-License-Identifier: BSD-3-Clause
"""Compares the messages of two bags field by field; stamps and sequence numbers aside.

usage: compare_bags.py FIRST.bag SECOND.bag

Recordings begin at different frames, so each message of one bag is looked for in the other by its content; the messages
that both recorded must be in the same order, and there must be some. Exit status 0: equal.
"""
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


def main():
    first, second = contents(sys.argv[1]), contents(sys.argv[2])
    common = set(first) & set(second)
    in_first = [entry for entry in first if entry in common]
    in_second = [entry for entry in second if entry in common]
    if not common:
        print(f"no message of one bag is in the other ({len(first)} and {len(second)} messages)")
        return 1
    if in_first != in_second and len(common) > 1:
        print("the same messages stand in different order or number")
        return 1
    print(f"the bags are equal field by field in the {len(in_second)} messages that both recorded (stamps aside)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
