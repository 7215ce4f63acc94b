# SPDX-License-Identifier: BSD-3-Clause
"""Fails when a room includes what it must not use. The arrows are those of docs/architecture.md.

usage: check_includes.py REPOSITORY
"""
import os
import re
import sys

# room -> rooms that it may include besides itself
USES = {
    "runtime/posix": [],
    "runtime/segment": ["runtime/posix"],
    "runtime/channel": ["runtime/segment", "runtime/posix"],
    "runtime/message": ["runtime/segment"],
    "runtime/roscpp": ["runtime/channel", "runtime/message", "runtime/segment", "runtime/posix"],
    "runtime/adapters": ["runtime/roscpp", "runtime/message", "runtime/segment"],
    "runtime/preload": ["runtime/roscpp", "runtime/message", "runtime/segment"],
    "msggen/model": [],
    "msggen/parse": ["msggen/model"],
    "msggen/emit": ["msggen/model"],
    "msggen/tool": ["msggen/model", "msggen/parse", "msggen/emit"],
    "rewriter/edits": [],
    "rewriter/report": ["rewriter/edits"],
    "rewriter/rules": ["rewriter/edits", "rewriter/report"],
    "rewriter/facts": ["rewriter/edits", "rewriter/report", "rewriter/rules"],
    "rewriter/solve": ["rewriter/edits", "rewriter/report", "rewriter/rules", "rewriter/facts"],
    "rewriter/verify": ["rewriter/edits", "rewriter/report", "rewriter/facts", "rewriter/solve"],
    "rewriter/format": ["rewriter/edits"],
    "rewriter/buildfiles": ["rewriter/edits", "rewriter/report"],
    "rewriter/tool": ["rewriter/*"],
}

# Headers of other projects that only some rooms may see.
FOREIGN = {
    "ROS": (r"(ros|rosconsole|xmlrpcpp|cv_bridge|image_transport|message_filters|pcl_conversions|[a-z0-9_]+_msgs)/",
            ["runtime/message", "runtime/roscpp", "runtime/adapters", "runtime/preload"]),
    "Clang": (r"(clang|llvm)/", ["rewriter/facts", "rewriter/solve", "rewriter/rules", "rewriter/verify", "rewriter/format",
              "rewriter"]),
    "Boost": (r"boost/", ["runtime/message", "runtime/roscpp", "runtime/adapters"]),
}
# The message room knows how messages are serialized, and nothing of nodes and topics.
MESSAGE_ROS = r"ros/(serialization|serialized_message|message_traits|message_operations|builtin_message_traits|types|time|duration)\.h|[a-z0-9_]+_msgs/"

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)


def room_of_source(path):
    parts = path.split("/")
    if path.startswith("runtime/include/tzc/"):
        return PUBLIC.get(parts[-1] if "detail" not in parts else "detail/" + parts[-1])
    candidate = "/".join(parts[:2])
    return candidate if candidate in USES else parts[0]


def read_public_map(root):
    """Which room a public header belongs to: runtime/include/tzc/rooms.txt."""
    rooms = {}
    with open(os.path.join(root, "runtime/include/tzc/rooms.txt")) as lines:
        for line in lines:
            if line.strip() and not line.startswith("#"):
                header, room = line.split()
                rooms[header] = room
    return rooms


def room_of_include(include, product):
    """The room that an include names, as seen from a product; None for what is not ours."""
    if include.startswith("tzc/"):
        return PUBLIC.get(include[len("tzc/"):])
    first = include.split("/")[0]
    # Every product's root is an include root of its own, so the nearest room of that name is meant.
    candidates = [f"{product}/{first}"] + [room for room in USES if room.endswith("/" + first)]
    candidates += ["/".join(include.split("/")[:2])]
    return next((room for room in candidates if room in USES), None)


def allowed(room, used):
    if room == used or room not in USES:
        return True
    return used in USES[room] or room.split("/")[0] + "/*" in USES[room] and used.startswith(room.split("/")[0] + "/")


def check(path, text):
    room = room_of_source(path)
    if room is None:
        yield f"{path}: not listed in runtime/include/tzc/rooms.txt: name its room there"
        return
    for match in INCLUDE.finditer(text):
        include = match.group(1)
        where = f"{path}:{text[:match.start()].count(chr(10)) + 1}"
        used = room_of_include(include, room.split("/")[0])
        if used and used.split("/")[0] != room.split("/")[0]:
            yield f"{where}: {room} includes {include}: products never include each other"
        elif used and not allowed(room, used):
            yield f"{where}: {room} must not use {used} ({include})"
        for name, (pattern, rooms) in FOREIGN.items():
            if re.match(pattern, include) and room not in rooms:
                yield f"{where}: {room} must not know {name} ({include})"
        if room == "runtime/message" and re.match(FOREIGN["ROS"][0], include) and not re.match(MESSAGE_ROS, include):
            yield f"{where}: {room} may only know how messages are serialized ({include})"


def main():
    global PUBLIC
    root = sys.argv[1]
    PUBLIC = read_public_map(root)
    problems, files = [], 0
    for product in ("runtime", "msggen", "rewriter"):
        for folder, _, names in os.walk(os.path.join(root, product)):
            for name in sorted(names):
                if name.endswith((".h", ".cpp")):
                    files += 1
                    full = os.path.join(folder, name)
                    with open(full) as source:
                        problems += check(os.path.relpath(full, root), source.read())
    print("\n".join(problems) or f"{files} files keep to the arrows")
    return 1 if problems or files == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
