# SPDX-License-Identifier: BSD-3-Clause
"""A terminal that a test reads."""
import os
import pty
import subprocess


class Terminal:
    """A program whose output is a terminal; with is_whole its other streams, too, as setsid --ctty and a shell need them."""
    ENTER, LEAVE = "\x1b[?1049h\x1b[?25l", "\x1b[?25h\x1b[?1049l"

    def __init__(self, *command, is_whole=False):
        self.end, other = pty.openpty()
        os.set_blocking(self.end, False)
        streams = {"stdin": other, "stderr": other} if is_whole else {"stdin": subprocess.DEVNULL, "start_new_session": True}
        self.process = subprocess.Popen(command, stdout=other, **streams)
        os.close(other)
        self.written = b""

    def screen(self):
        """All that it has written so far."""
        try:
            while True:
                more = os.read(self.end, 65536)
                if not more:
                    break
                self.written += more
        except OSError:
            pass  # nothing more now, or it has ended
        return self.written.decode()

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.end)
