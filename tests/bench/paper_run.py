# SPDX-License-Identifier: BSD-3-Clause
"""Runs of tzc-bench paper for its tests: its command line, its results."""
import csv
import os
import subprocess

TINY = ["--rounds", "1", "--rate", "50"]
ROS_FREE = ["--only", "ach,tzc", "--subscribers", "1"]


def environment(scratch, **more):
    return dict(os.environ, ROS_HOME=scratch, ROS_LOG_DIR=os.path.join(scratch, "log"), **more)


def run(bench, scratch, *options, output="out", **more):
    return subprocess.run([bench, "paper", "--output", os.path.join(scratch, output), *options], text=True, timeout=600,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment(scratch, **more))


def read(scratch, name):
    with open(os.path.join(scratch, "out", name), encoding="utf-8") as file:
        return file.read()


def rows(scratch, name):
    return list(csv.DictReader(read(scratch, name).splitlines()))


def key(row):
    return row["contender"], int(row["size_bytes"]), int(row["subscribers"])
