# SPDX-License-Identifier: BSD-3-Clause
"""Whether levels are true: what the report calls zero_copy does not copy, says TZC's own counter."""
import collections
import json

from execution import read_log
from toolchain import Failure

# Levels are those of the steady state. The first message of an object may be copied: the object lasts, and was filled before its
# publisher shared memory. So the second half of a run counts, and some copies among few messages say nothing there either: a
# container's last object may be a late one.
MOST = 0.5
ENOUGH = 3


def counted(path):
    """topic -> (messages, bytes that were copied into shared memory), from the first subscriber on shared memory on"""
    with open(path) as file:
        nodes = json.load(file)["nodes"]
    return {topic["topic"]: (topic["messages"], topic["copied_bytes"]) for node in nodes for topic in node["topics"]}


def counted_in_second_half(folder):
    half, whole = counted(f"{folder}/counters_half.json"), counted(f"{folder}/counters.json")
    return {topic: tuple(now - before for now, before in zip(counters, half.get(topic, (0, 0))))
            for topic, counters in whole.items()}


def topics_without_copy(sites):
    """Those that nothing but zero_copy sites publish on."""
    levels = collections.defaultdict(set)
    for site in sites:
        if site["kind"] == "publish" and site["topic"]:
            levels[site["topic"]].add(site["level"])
    return sorted(topic for topic, found in levels.items() if found == {"zero_copy"})


def mark_needless(sites, folder):
    """A site that is said to copy, on a topic that copied nothing, lost its level for nothing: as far as this run shows."""
    counters = counted_in_second_half(folder)
    for site in sites:
        messages, copied = counters.get(site["topic"], (0, 0))
        site["needless"] = site["kind"] == "publish" and site["level"] == "one_copy" and messages > 0 and copied == 0


def check_copies(sites, folder):
    counters, received = counted_in_second_half(folder), read_log(f"{folder}/recorder.log")
    wrong = []
    for topic in topics_without_copy(sites):
        messages, copied = counters.get(topic, (0, 0))
        lengths = [int(line.split(":")[0]) for line in received.get(topic, [])][-messages:] if messages else []
        if messages >= ENOUGH and copied > MOST * sum(lengths):
            wrong.append(f"  {topic}: {copied} bytes of its last {messages} messages, which have {sum(lengths)} bytes")
    if wrong:
        raise Failure("reported zero_copy, but copied into shared memory:\n" + "\n".join(wrong))
