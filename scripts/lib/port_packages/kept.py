# SPDX-License-Identifier: BSD-3-Clause
"""What a step found, kept with what it depends on, so that a run that was interrupted goes on behind it."""
import hashlib
import json
import os


def files_below(place):
    if not os.path.isdir(place):
        yield place
    for folder, folders, names in os.walk(place):
        folders[:] = sorted(name for name in folders if name != ".git")
        for name in sorted(names):
            yield os.path.join(folder, name)


def digest_of(*places):
    """Of files, and of all files below folders, but for git's own."""
    digest = hashlib.sha256()
    for place in places:
        for path in files_below(place):
            digest.update(os.path.relpath(path, place).encode() + b"\0")
            if os.path.islink(path):
                digest.update(os.readlink(path).encode())
            else:
                with open(path, "rb") as file:
                    digest.update(hashlib.sha256(file.read()).digest())
    return digest.hexdigest()


class Kept:
    """A dictionary in a file. `key` may be anything that JSON has."""

    def __init__(self, path, key):
        self.path, self.key = path, key

    def read(self):
        """None: nothing is kept, or it was found with another key."""
        try:
            with open(self.path) as file:
                kept = json.load(file)
        except (OSError, ValueError):
            return None
        return kept["found"] if kept.get("key") == self.key else None

    def forget(self):
        """What it belongs to is about to change."""
        if os.path.exists(self.path):
            os.remove(self.path)

    def write(self, found):
        with open(self.path + ".new", "w") as file:
            json.dump({"key": self.key, "found": found}, file)
        os.replace(self.path + ".new", self.path)
