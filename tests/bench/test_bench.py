# SPDX-License-Identifier: BSD-3-Clause
"""usage: test_bench.py TZC_BENCH core|roscpp|scale|soak|sustained|inside

A short run of the command delivers messages, writes the JSON file that is promised, and mistakes are told."""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time

FIELDS = {"contender": str, "size_bytes": int, "subscribers": int, "sent": int, "delivered": int,
          "median_us": (int, float), "p99_us": (int, float), "publish_us": (int, float)}
CONTENDERS = {"core": {"seqpacket", "tzc", "tzc-own-loop"},
              "roscpp": {"seqpacket", "tzc-direct", "tzc-spin", "tzc-queue", "tzc-attached", "intraprocess", "tcpros"},
              "sustained": {"tzc-sustained"}}


CONFIGURATION = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "configuration.md")
# Of the user's own network, where a run has its own.
ELSEWHERE = {"ROS_HOSTNAME": "no-such-host.invalid", "ROS_NAMESPACE": "/robot",
             "ROS_MASTER_URI": "http://no-such-host.invalid:11311"}


def run(*command, **more):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=600,
                          env=dict(os.environ, **more))


def short_run(bench, command):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "figures.json")
        many = [] if command == "sustained" else ["--sizes", "4k,64k", "--rounds", "2"]
        done = run(bench, command, "--subscribers", "2", "--count", "10", "--rate", "50", "--json", path, *many, **ELSEWHERE)
        assert done.returncode == 0, done.stderr
        with open(path) as file:
            return done.stdout, json.load(file)


def check_rows(rows, command):
    assert CONTENDERS[command] <= {row["contender"] for row in rows}, rows
    sizes = {4 << 20} if command == "sustained" else {4096, 65536}
    for row in rows:
        assert set(row) == set(FIELDS), row
        assert all(isinstance(row[name], kind) for name, kind in FIELDS.items()), row
        assert row["size_bytes"] in sizes and row["subscribers"] == 2, row
        assert row["sent"] == 20 and 0 < row["delivered"] <= 20, row  # a busy machine may stall past the queue
        assert 0 < row["median_us"] <= row["p99_us"] and row["publish_us"] > 0, row


def check_ratios(table, rows):
    """The last columns compare a row with the bare socket and with TCPROS, where these were measured."""
    for row in rows:
        beside = {other["contender"]: other["median_us"] for other in rows
                  if (other["size_bytes"], other["subscribers"]) == (row["size_bytes"], row["subscribers"])}
        expected = [row["median_us"] / beside["seqpacket"]] if "seqpacket" in beside else []
        expected += [beside["tcpros"] / row["median_us"]] if "tcpros" in beside else []
        line = next(line.split() for line in table.splitlines()
                    if line.split()[:3] == [row["contender"], str(row["size_bytes"]), str(row["subscribers"])])
        shown = [float(word) for word in line[8:]]
        assert len(shown) == len(expected), (line, expected)
        assert all(abs(a - b) < 0.02 * b + 0.01 for a, b in zip(shown, expected)), (line, expected)


def check_failures(bench):
    """What could not be measured is no row of lost messages, and no success."""
    unknown = run(bench, "core", "--only", "tzc,zeromq")
    assert unknown.returncode == 2 and "no zeromq; there are seqpacket, futex, tzc" in unknown.stderr, unknown
    if "iceoryx" in unknown.stderr:
        nobody = run(bench, "core", "--only", "iceoryx-listener", "--sizes", "64m")
        assert nobody.returncode == 2 and "none of the wanted contenders takes" in nobody.stderr and not nobody.stdout, nobody
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "figures.json")
        failed = run(bench, "core", "--only", "tzc,futex", "--sizes", "4k,900g", "--subscribers", "1", "--count", "4", "--rounds", "2",
                     "--json", path)
        with open(path) as file:
            rows = json.load(file)["rows"]
    assert failed.returncode == 1 and "tzc, 966367641600 bytes to 1 subscriber(s): no message arrived" in failed.stderr, failed
    assert {(row["contender"], row["size_bytes"]): row["sent"] for row in rows} == {
        ("tzc", 4096): 4, ("futex", 4096): 4, ("futex", 900 << 30): 4}, rows


def check_settings(bench):
    """Settings in the environment are refused by name, or kept where that is asked for; then the figures say so."""
    with open(CONFIGURATION, encoding="utf-8") as file:
        variables = set(re.findall(r"TZC_[A-Z]+(?:_[A-Z]+)*", file.read()))
    assert {"TZC_DISABLE", "TZC_GUARD", "TZC_TRACE", "TZC_POLICY_ATTEMPTS", "TZC_TRIES"} <= variables, variables
    tiny = ["core", "--only", "futex", "--sizes", "4k", "--subscribers", "1", "--count", "2", "--rounds", "1"]
    with tempfile.TemporaryDirectory() as folder:
        value = os.path.join(folder, "1")
        for variable in sorted(variables):
            told = run(bench, *tiny, **{variable: value})
            assert told.returncode == 2 and f"{variable}={value}" in told.stderr and not told.stdout, (variable, told)
        path = os.path.join(folder, "figures.json")
        kept = run(bench, *tiny, "--keep-settings", "--json", path, TZC_POLICY="worst_effort", TZC_GUARD="", TZC_ROBOT="x")
        assert kept.returncode == 0, kept
        with open(path, encoding="utf-8") as file:
            assert json.load(file)["machine"]["environment"] == "TZC_POLICY=worst_effort"


def check_refusals(bench, command):
    """No command measures something else because of the environment; its help is there all the same."""
    told = run(bench, command, TZC_DISABLE="1")
    assert told.returncode == 2 and "TZC_DISABLE=1" in told.stderr and "--keep-settings" in told.stderr, told
    told = run(bench, command, "--help", TZC_DISABLE="1")
    assert told.returncode == 0 and "--keep-settings" in told.stdout, told


def check_interruption(bench, send):
    """Ctrl-C, or the end of the terminal, ends it in order: what was measured is shown, no process is left, and no file is half a
    result."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "figures.json")
        core = subprocess.Popen([bench, "core", "--only", "seqpacket,iceoryx-listener", "--sizes", "4k", "--subscribers", "1", "--count", "10000",
                                 "--rate", "100", "--rounds", "1000", "--json", path],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
                                preexec_fn=hear_all)
        time.sleep(6)
        with open(f"/proc/{core.pid}/task/{core.pid}/children") as file:
            children = file.read().split()
        send(core.pid)
        table, messages = core.communicate(timeout=120)
        assert core.returncode == 130 and "interrupted" in messages and "seqpacket" in table, (core.returncode, table, messages)
        assert children and not [child for child in children if os.path.exists(f"/proc/{child}")], children
        assert not os.path.exists(path)
        if "iox-roudi does not start" not in messages:  # another one runs, or none is installed
            assert not os.path.exists("/dev/shm/iceoryx_mgmt")


def hear_all():
    """Whatever started the test may ignore some."""
    for sig in (signal.SIGINT, signal.SIGHUP):
        signal.signal(sig, signal.SIG_DFL)


def check_one_case(bench):
    """What it would leave out of account is a mistake."""
    for mistake in (["--only", "tzc"], ["--rounds", "3"], ["--sizes", "4k,64m"], ["--subscribers", "1,8"]):
        told = run(bench, "sustained", *mistake)
        assert told.returncode == 2 and mistake[0] in told.stderr, (mistake, told)


def check_inside(bench):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "figures.json")
        done = run(bench, "inside", "--json", path, "--benchmark_filter=allocate/|to_stopped", "--benchmark_min_time=0.01")
        assert done.returncode == 0, done.stderr
        assert "allocate/4194304" in done.stdout and "\033" not in done.stdout, "colours, and not on a terminal"
        with open(path) as file:
            rows = json.load(file)["rows"]
    assert {("allocate/4194304", 4 << 20, 0), ("allocate_publish_to_stopped/8", 4 << 20, 8)} <= {
        (row["contender"], row["size_bytes"], row["subscribers"]) for row in rows}, rows
    assert all(set(row) == set(FIELDS) and 0 < row["median_us"] <= row["p99_us"] for row in rows), rows
    assert run(bench, "inside", "--json").returncode == 2
    assert "Examples:" in run(bench, "inside", "--help").stdout
    assert run(bench, "--help").returncode == 0 and run(bench).returncode == 2 and run(bench, "fast").returncode == 2


def check_scale(bench):
    """Whatever a crowd costs, each message arrives, and each connection that can be is on shared memory."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "figures.json")
        done = run(bench, "scale", "--topics", "6", "--subscribers", "2", "--memory", "1m", "--json", path)
        assert done.returncode == 0, done.stderr
        with open(path) as file:
            rows = json.load(file)["rows"]
    assert [row["transport"] for row in rows] == ["tcpros", "tzc"], rows
    assert [row["upgraded"] for row in rows] == [0, 12], rows
    for row in rows:
        assert (row["topics"], row["subscribers"], row["connected"], row["delivered"]) == (6, 2, 12, 12), row
        assert all(row[role][need] > 0 for role in ("publisher", "subscriber")
                   for need in ("threads", "descriptors", "private_kb")), row
        assert row["connected_s"] > 0 and row["upgraded_s"] >= 0 and f"{row['transport']} " in done.stdout, row
    listening = rows[1]["publisher"]["descriptors"] - rows[0]["publisher"]["descriptors"]
    assert listening < 12 + 6 + 6, "a socket a connection, a file a publisher, and few for all of them together"
    for mistake in (["--topics", "0"], ["--memory", "much"], ["--size", "4k"]):
        told = run(bench, "scale", *mistake)
        assert told.returncode == 2 and mistake[0] in told.stderr, (mistake, told)
    assert "Examples:" in run(bench, "scale", "--help").stdout


class RunningSoak:
    """A soak of at most a minute that somebody disturbs."""

    def __init__(self, bench, folder):
        self.path = os.path.join(folder, "soak.json")
        self.process = subprocess.Popen([bench, "soak", "--minutes", "1", "--look-every", "1", "--kill-every", "3", "--stop-for",
                                         "1", "--json", self.path],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        for line in self.process.stderr:  # until the subscribers receive
            if "received 0," not in line:
                break

    def children(self):
        with open(f"/proc/{self.process.pid}/task/{self.process.pid}/children") as file:
            return [int(word) for word in file.read().split()]

    def environment(self):
        """With the ROS master, which is the first child."""
        with open(f"/proc/{self.children()[0]}/environ", "rb") as file:
            values = dict(value.split(b"=", 1) for value in file.read().split(b"\0") if b"=" in value)
        return dict(os.environ, **{name.decode(): values[name].decode() for name in (b"ROS_MASTER_URI", b"ROS_IP")})

    def end(self):
        """Its status, table, messages and rows. None of its processes is left."""
        children = self.children() if self.process.poll() is None else []
        table, messages = self.process.communicate(timeout=120)
        left = [child for child in children if os.path.exists(f"/proc/{child}")]
        assert not left, left
        with open(self.path) as file:
            rows = {row["process"]: row for row in json.load(file)["rows"]}
        return self.process.returncode, table, messages, rows


def ask_to_end(node, environment):
    """As often as it takes: the node may be dead just then."""
    for _ in range(10):
        asked = subprocess.run(["rosnode", "kill", node], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               text=True, timeout=60)
        if asked.returncode == 0:
            return
    raise AssertionError(asked.stdout)


def check_soak_without_faults(bench, folder):
    """A port may pass from a killed process to its successor, which the master then takes for the one to shut down."""
    soak = RunningSoak(bench, folder)
    time.sleep(7)
    ask_to_end("/soak_killed_publisher", soak.environment())
    time.sleep(8)
    soak.process.send_signal(signal.SIGINT)
    status, table, messages, rows = soak.end()
    assert status == 0, (table, messages)
    assert "Too short to judge" in table and "GREW" not in table, table
    assert rows["publisher"]["published"] > 100 and rows["killed_publisher"]["published"] > 0, rows
    for name in ("subscriber", "direct", "keeper", "guest", "stopped", "killed", "plain"):
        assert rows[name]["received"] > 0 and rows[name]["spoiled"] == 0, (name, rows[name])
    for name, row in rows.items():
        assert bool(row["killed"]) == name.startswith("killed") != bool(row["looks"]), (name, row)
    for row in rows.values():
        assert all(look[need] > 0 for look in row["looks"] for need in ("threads", "descriptors", "private_kb")), row


def check_soak(bench):
    """It runs, it can be ended, and it tells of a message that nobody of it published and of a process that ends."""
    with tempfile.TemporaryDirectory() as folder:
        check_soak_without_faults(bench, folder)
        soak = RunningSoak(bench, folder)
        foreign = subprocess.run(["rostopic", "pub", "-1", "/soak/scans", "sensor_msgs/Image", "{step: 3, data: [1, 2, 3]}"],
                                 env=soak.environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)
        assert foreign.returncode == 0, foreign.stdout
        soak.process.send_signal(signal.SIGINT)
        status, table, _, rows = soak.end()
        assert status == 1 and rows["subscriber"]["spoiled"] == 1 and rows["direct"]["spoiled"] == 1, table
        soak = RunningSoak(bench, folder)
        os.kill(soak.children()[2], signal.SIGKILL)
        status, table, messages, _ = soak.end()
        assert status == 1 and "subscriber ended by itself" in messages, (table, messages)
    for mistake in (["--minutes", "0"], ["--look-every", "-1"], ["--hours", "2"]):
        told = run(bench, "soak", *mistake)
        assert told.returncode == 2 and mistake[0] in told.stderr, (mistake, told)
    assert "Examples:" in run(bench, "soak", "--help").stdout


def main():
    bench, command = sys.argv[1:]
    check_refusals(bench, command)
    if command == "soak":
        return check_soak(bench)
    if command == "scale":
        return check_scale(bench)
    if command == "inside":
        return check_inside(bench)
    table, figures = short_run(bench, command)
    assert set(figures) == {"machine", "rows"} and figures["machine"]["cpus"] > 0, figures
    check_rows(figures["rows"], command)
    check_ratios(table, figures["rows"])
    for mistake in (["--size", "4k"], ["--rate", "-1"], ["--rate", "nan"], ["--sizes", "many"], ["--sizes", "-5"], ["--subscribers", "99"],
                    ["--json", "/no/such/folder/figures.json"], ["--json", "/"], ["--json", "-"]):
        told = run(bench, command, *mistake)
        assert told.returncode == 2 and mistake[0] in told.stderr, (mistake, told)
    if command == "core":
        check_failures(bench)
        check_settings(bench)
        check_interruption(bench, lambda pid: os.kill(pid, signal.SIGINT))
        check_interruption(bench, lambda pid: os.killpg(pid, signal.SIGHUP))
    if command == "sustained":
        check_one_case(bench)
    assert "Examples:" in run(bench, command, "--help").stdout


main()
