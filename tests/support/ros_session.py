# SPDX-License-Identifier: BSD-3-Clause
"""A ROS graph of one's own: a roscore on a free loopback port, and processes that are all stopped at the end.

    with RosSession(scratch) as ros:
        camera = ros.start(["camera_node", "_count:=30"])
        camera.wait(20)

Everything is stopped by pid; nothing else on the machine is touched.
"""
import contextlib
import os
import random
import signal
import socket
import subprocess
import sys
import threading
import time
import xmlrpc.client

# Limits are for what hangs. What does come takes long on a machine that is busy with others, and is waited for then: each
# limit, which says how long a thing takes at most on an idle machine, is multiplied by this.
PATIENCE = 6


class ReservedPort:
    """A loopback port that nobody else is given before `close`, below those that the system gives to outgoing connections.

    Bound here and never listened on: roscore, which binds with SO_REUSEADDR, can listen on it, and another session, which binds
    without, finds it taken, also during the seconds before roscore listens."""

    def __init__(self):
        self.number = random.randrange(15000, 32000)
        while not self._reserve():
            self.number = random.randrange(15000, 32000)

    def _reserve(self):
        self._socket = socket.socket()
        try:
            self._socket.bind(("127.0.0.1", self.number))
        except OSError:
            self._socket.close()
            return False
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # from now on
        return True

    def close(self):
        self._socket.close()


class Termination:
    """A process that is terminated stops what it has started, unless it has a handler of its own: also what it is starting at
    that moment, which nothing names yet."""
    starting = 0
    came = False

    @classmethod
    def end_as_usual(cls):
        is_default = signal.getsignal(signal.SIGTERM) == signal.SIG_DFL
        if is_default and threading.current_thread() is threading.main_thread():
            signal.signal(signal.SIGTERM, cls._end)

    @classmethod
    def _end(cls, *_):
        cls.came = True
        if cls.starting == 0:
            sys.exit(128 + signal.SIGTERM)

    @classmethod
    @contextlib.contextmanager
    def put_off(cls):
        if threading.current_thread() is not threading.main_thread():  # no signal interrupts it
            yield
            return
        cls.starting += 1
        try:
            yield
        finally:
            cls.starting -= 1
            if cls.came:
                cls._end()


class Process:
    """A child with its output in a file."""

    def __init__(self, name, command, env, log_path):
        self.name = name
        self.log_path = log_path
        self._log = open(log_path, "wb")
        self.popen = subprocess.Popen(command, env=env, stdin=subprocess.DEVNULL, stdout=self._log,
                                      stderr=subprocess.STDOUT, start_new_session=True)

    @property
    def pid(self):
        return self.popen.pid

    def alive(self):
        return self.popen.poll() is None

    def wait(self, timeout):
        """Exit status; raises with the end of the log when the time is up."""
        try:
            return self.popen.wait(PATIENCE * timeout)
        except subprocess.TimeoutExpired:
            raise RuntimeError(f"{self.name} still runs after {PATIENCE * timeout} s; its log ends:\n{self.tail()}") from None

    def stop(self, sig=signal.SIGINT, timeout=8):
        """Asks it to end, then makes it end. Harmless when it has ended."""
        if self.alive():
            self.popen.send_signal(sig)
            try:
                self.popen.wait(PATIENCE * timeout)
            except subprocess.TimeoutExpired:
                self.popen.kill()
        status = self.popen.wait()
        self._log.close()
        return status

    def kill(self):
        self.popen.kill()
        self.popen.wait()

    def log(self):
        with open(self.log_path, "rb") as log:
            return log.read().decode(errors="replace")

    def tail(self, lines=15):
        return "\n".join(self.log().splitlines()[-lines:])


class RosSession:
    def __init__(self, scratch, env=None):
        self.scratch = scratch
        os.makedirs(scratch, exist_ok=True)
        self._port = ReservedPort()
        self.uri = f"http://127.0.0.1:{self.port}"
        self.env = dict(os.environ, ROS_IP="127.0.0.1", PYTHONUNBUFFERED="1")
        self.env.pop("ROS_HOSTNAME", None)
        self.env.update(env or {})
        # A workspace's setup.sh names a master, too: this session's own is the one that counts.
        self.env.update(ROS_MASTER_URI=self.uri, ROS_HOME=scratch, ROS_LOG_DIR=os.path.join(scratch, "log"))
        self.master = xmlrpc.client.ServerProxy(self.uri)
        self.core = None
        self._processes = []
        self._count = 0

    @property
    def port(self):
        return self._port.number

    def __enter__(self):
        Termination.end_as_usual()
        try:
            self._start_core()
        except BaseException:
            self.__exit__()
            raise
        return self

    def restart_core(self):
        """Another roscore takes the place of the one that is killed; it knows no node."""
        self.core.stop()
        self._start_core()

    def _start_core(self):
        self.core = self.start(["roscore", "-p", str(self.port)], name="roscore")
        self.wait_until(self.master_answers, 30, "roscore to answer")

    def __exit__(self, *exc):
        if self.core and not self.core.alive():  # whatever failed, this is why
            print(f"roscore ended before its session; its log ends:\n{self.core.tail()}", file=sys.stderr)
        for process in reversed(self._processes):
            process.stop()
        self.master("close")()
        self._port.close()
        return False

    def start(self, command, name=None, env=None):
        self._count += 1
        name = os.path.basename(name or command[0])
        log_path = os.path.join(self.scratch, f"{self._count:02d}-{name}.log")
        with Termination.put_off():
            process = Process(name, command, dict(self.env, **(env or {})), log_path)
            self._processes.append(process)
        return process

    def mark(self):
        """For stop_since: the processes that were started up to now."""
        return len(self._processes)

    def stop_since(self, mark):
        """Stops what was started after the mark, all at once. They are signalled first, so that none waits in turn."""
        started, self._processes[mark:] = self._processes[mark:], []
        for process in started:
            if process.alive():
                process.popen.send_signal(signal.SIGCONT)
                process.popen.send_signal(signal.SIGINT)
        for process in reversed(started):
            process.stop()

    def run(self, command, timeout=30, env=None):
        """Runs to the end; returns (status, output)."""
        done = subprocess.run(command, env=dict(self.env, **(env or {})), timeout=PATIENCE * timeout, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        return done.returncode, done.stdout.decode(errors="replace")

    def master_answers(self):
        try:
            return self.master.getPid("/tzc_test")[0] == 1
        except (OSError, xmlrpc.client.Error):
            return False

    def subscribers(self, topic):
        """Names of the nodes that subscribe to a topic, as the master knows them."""
        _, _, (_, subscribers, _) = self.master.getSystemState("/tzc_test")
        return dict(subscribers).get(topic, [])

    def publishers(self, topic):
        """Names of the nodes that advertise a topic, as the master knows them."""
        _, _, (publishers, _, _) = self.master.getSystemState("/tzc_test")
        return dict(publishers).get(topic, [])

    @staticmethod
    def wait_until(condition, timeout, what):
        deadline = time.monotonic() + PATIENCE * timeout
        while time.monotonic() < deadline:
            if condition():
                return
            time.sleep(0.05)
        raise RuntimeError(f"waited {PATIENCE * timeout} s in vain for {what}")
