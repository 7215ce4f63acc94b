# SPDX-License-Identifier: BSD-3-Clause
"""Runs a command, keeps its output in a file, and measures it."""
import contextlib
import dataclasses
import os
import signal
import subprocess
import threading
import time

patience = 40  # seconds: tzc-compare stops its nodes in order


@dataclasses.dataclass
class Outcome:
    status: int  # negative: ended by a signal
    seconds: float  # processor time of the command and its children
    wall: float
    timed_out: bool = False


def run(command, log, cwd=None, env=None, timeout=None, output=None):
    """Standard error, and standard output unless `output` names a file for it, go to the file `log`. A command that
    takes longer than `timeout` seconds is stopped with everything it started in its process group."""
    os.makedirs(os.path.dirname(log), exist_ok=True)
    begin, late, process = time.monotonic(), [], None
    with open(log, "wb") as errors, open(output or os.devnull, "wb") as file:

        def stop(which=signal.SIGTERM):
            late.append(which)
            os.killpg(process.pid, which)

        timers = [threading.Timer(timeout, stop), threading.Timer(timeout + patience, stop, [signal.SIGKILL])] if timeout else []
        try:
            with signals_wait():
                process = subprocess.Popen(command, cwd=cwd, env=env, stdin=subprocess.DEVNULL, stderr=errors,
                                           stdout=file if output else errors, start_new_session=True)
            for timer in timers:
                timer.start()
            _, status, usage = os.wait4(process.pid, 0)
        except BaseException:  # a signal that ends this program, as ended_by_signals has it
            if process:
                end(process)
            raise
        finally:
            for timer in timers:
                timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
    return Outcome(process.returncode, usage.ru_utime + usage.ru_stime, time.monotonic() - begin, bool(late))


def end(process):
    """Ends it with what it started in its process group, which may not outlive the run: the next one works in the same folders."""
    for which, seconds in ((signal.SIGTERM, patience), (signal.SIGKILL, None)):
        try:
            os.killpg(process.pid, which)
            process.wait(seconds)
        except (ProcessLookupError, subprocess.TimeoutExpired):
            pass  # all have ended; or some have not


_waiting = None  # numbers of signals that came while they have to wait; None: they need not


@contextlib.contextmanager
def signals_wait():
    """A signal that ends this program does so behind the block. Within, it would leave a process behind that has been started,
    and that nobody knows yet."""
    global _waiting
    _waiting = []
    try:
        yield
    finally:
        came, _waiting = _waiting, None
        if came:
            raise SystemExit(128 + came[0])


def ended_by_signals():
    """From now on these signals end the program through its exception handlers; a further one changes nothing, nor does one that
    is ignored already, as under nohup."""
    signals = [which for which in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP) if signal.getsignal(which) != signal.SIG_IGN]

    def leave(number, _):
        for which in signals:
            signal.signal(which, signal.SIG_IGN)
        if _waiting is not None:
            _waiting.append(number)
            return
        raise SystemExit(128 + number)

    for which in signals:
        signal.signal(which, leave)


def tail(path, lines=3):
    """The last lines of a log that say something."""
    with open(path, errors="replace") as file:
        return [line.rstrip() for line in file if line.strip()][-lines:]
