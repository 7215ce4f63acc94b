# SPDX-License-Identifier: BSD-3-Clause
"""Runs a package's programs under a roscore of their own and compares what was received."""
import collections
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../support"))
from ros_session import RosSession  # noqa: E402

LOGS = ("recorder.log", "listener.log")
COUNTERS = ("counters_half.json", "counters.json")


def execute(program, recorder, folder, topics, guard=False, monitor=None):
    """{(log, topic): [what was received]}. In guard mode a late write is an error. tzc-monitor writes counters_half.json when half of the rounds
    are done, and counters.json at the end."""
    os.makedirs(folder, exist_ok=True)
    # Small payloads are read where they lie, so that a write by their publisher shows; by default they are copied.
    environment = {"FUZZ_FOLDER": folder, "ROS_VERSION": "1", "TZC_PRIVATE_WRITES": "0",
                   "TZC_GUARD": "1" if guard else "0", **({"FUZZ_MONITOR": monitor} if monitor else {})}
    with RosSession(folder, env=environment) as ros:
        ros.start([recorder, *topics], name="recorder")
        listener = ros.start([program, "listener"], name="listener")
        talker = ros.start([program, "talker"], name="talker")
        status = talker.wait(400)
        if status != 0:
            raise RuntimeError(f"{program} ends with {status}, {last_program(folder)}; its output ends:\n"
                               f"{talker.tail()}")
        for process in (talker, listener):
            if "TZC guard: a" in process.log():
                raise RuntimeError(f"{program} writes too late:\n{process.log()}")
        for name in COUNTERS if monitor else ():
            keep_counters_of(talker.pid, f"{folder}/{name}")
    return {(name, topic): lines for name in LOGS for topic, lines in read_log(f"{folder}/{name}").items()}


def keep_counters_of(pid, path):
    """tzc-monitor shows all nodes of the user, those of another run as well."""
    with open(path) as file:
        page = json.load(file)
    page["nodes"] = [node for node in page["nodes"] if node["pid"] == pid]
    with open(path, "w") as file:
        json.dump(page, file)


def last_program(folder):
    """Which program's step was the talker's last. The logs do not know: what was queued is lost with the talker."""
    try:
        with open(f"{folder}/talker.running") as file:
            return f"in {file.read().strip()}"
    except FileNotFoundError:
        return "before the first step"


def read_log(path):
    """topic -> length, checksum and first bytes of each message"""
    received = collections.defaultdict(list)
    with open(path) as file:
        for line in file:
            topic, length, checksum, first_bytes, _ = line.split()
            received[topic].append(f"{length}:{checksum}:{first_bytes}")
    return received


def shared_messages(folder):
    """How many messages the listener found in shared memory."""
    with open(f"{folder}/listener.log") as file:
        return sum(line.split()[4] == "shared" for line in file)


def differences(before, after):
    """One line for each topic whose messages are not equal."""
    lines = []
    for key in sorted(set(before) | set(after)):
        one, other = before.get(key, []), after.get(key, [])
        if one != other:
            at = next((i for i, pair in enumerate(zip(one, other)) if pair[0] != pair[1]), min(len(one), len(other)))
            lines.append(f"  {key[1]} ({key[0]}): {len(one)} messages before, {len(other)} after; message {at}: "
                         f"{one[at:at + 1]} before, {other[at:at + 1]} after")
    return lines
