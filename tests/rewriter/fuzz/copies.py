# SPDX-License-Identifier: BSD-3-Clause
"""Whether levels are true: what the report calls zero_copy does not copy, says TZC's own counter."""
import collections
import json

from execution import read_log
from toolchain import Failure

# The first message of an object may be copied: the object lasts, and was filled before its publisher shared memory. So some copies
# among few messages, each perhaps of another object, say nothing.
MOST = 0.5
ENOUGH = 6


def counted(folder):
    """topic -> (messages, bytes that were copied into shared memory), from the first subscriber on shared memory on"""
    with open(f"{folder}/counters.json") as file:
        nodes = json.load(file)["nodes"]
    return {topic["topic"]: (topic["messages"], topic["copied_bytes"]) for node in nodes for topic in node["topics"]}


def topics_without_copy(sites):
    """Those that nothing but zero_copy sites publish on."""
    levels = collections.defaultdict(set)
    for site in sites:
        if site["kind"] == "publish" and site["topic"]:
            levels[site["topic"]].add(site["level"])
    return sorted(topic for topic, found in levels.items() if found == {"zero_copy"})


def check_copies(sites, folder):
    counters, received = counted(folder), read_log(f"{folder}/recorder.log")
    wrong = []
    for topic in topics_without_copy(sites):
        lengths = [int(line.split(":")[0]) for line in received.get(topic, [])]
        messages, copied = counters.get(topic, (0, 0))
        if messages >= ENOUGH and copied > MOST * messages * sum(lengths) / len(lengths):
            wrong.append(f"  {topic}: {copied} bytes of {messages} messages; {len(lengths)} messages have {sum(lengths)} bytes")
    if wrong:
        raise Failure("reported zero_copy, but copied into shared memory:\n" + "\n".join(wrong))
