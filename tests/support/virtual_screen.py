# SPDX-License-Identifier: BSD-3-Clause
"""A screen without a display, whose pixels can be read: Xvfb, with its frame buffer in a file.

    with VirtualScreen(scratch) as screen:
        ros.start(["image_view", ...], env=screen.env)
        ... screen.shows(rows) ...
"""
import os
import shutil
import struct
import subprocess
import tempfile


def without_fourth_bytes(line):
    colours = bytearray(len(line) // 4 * 3)
    for i in range(3):
        colours[i::3] = line[i::4]
    return bytes(colours)


class VirtualScreen:
    WIDTH, HEIGHT = 1920, 1080

    def __init__(self, scratch):
        if not shutil.which("Xvfb"):
            raise RuntimeError("there is no Xvfb, in which a program's window is looked at: install the package xvfb")
        self.directory = tempfile.mkdtemp(dir=scratch)

    def __enter__(self):
        """Xvfb takes a display number that is free, and tells it when it can be used."""
        read_end, write_end = os.pipe()
        self._server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{self.WIDTH}x{self.HEIGHT}x24", "-nolisten", "tcp",
             "-fbdir", self.directory], pass_fds=[write_end], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True)
        os.close(write_end)
        with open(read_end, encoding="ascii") as number:
            display = number.readline().strip()
        if not display:
            raise RuntimeError("Xvfb ended before it told its display")
        self.env = {"DISPLAY": f":{display}", "XDG_RUNTIME_DIR": self.directory}
        return self

    def __exit__(self, *exc):
        self._server.terminate()
        self._server.wait()
        return False

    def lines(self):
        """The screen's lines from the top, four bytes for each pixel: blue, green, red, none."""
        with open(os.path.join(self.directory, "Xvfb_screen0"), "rb") as dump:
            content = dump.read()
        header = struct.unpack(">25I", content[:100])  # the format of xwd
        line_bytes, colours = header[12], header[19]
        begin = header[0] + 12 * colours
        return [content[begin + y * line_bytes:begin + y * line_bytes + 4 * self.WIDTH] for y in range(self.HEIGHT)]

    def shows(self, rows):
        """Is there a place on the screen with just these pixels? rows: each one's bytes, in the order blue, green, red."""
        seen = [without_fourth_bytes(line) for line in self.lines()]
        for top in range(self.HEIGHT - len(rows) + 1):
            left = seen[top].find(rows[0])
            if left >= 0 and all(line[left:left + len(row)] == row for line, row in zip(seen[top:], rows)):
                return True
        return False
