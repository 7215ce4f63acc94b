# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m port_packages --tzc BUILD --out DIR [OPTION...] -- NAME=FOLDER...; see scripts/port-packages --help."""
import argparse
import contextlib
import fcntl
import glob
import hashlib
import json
import os
import sys

from .command import ended_by_signals
from .kept import digest_of
from .repository import Repository
from .table import table

USUAL_BUILD = "Release"


def parse_arguments():
    parser = argparse.ArgumentParser(prog="scripts/port-packages")
    parser.add_argument("--tzc", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--inputs")
    parser.add_argument("--with", dest="options", action="append", default=[])
    parser.add_argument("--no-tests", dest="tests", action="store_false")
    parser.add_argument("--no-speed", dest="speed", action="store_false")
    parser.add_argument("--build-type", default=USUAL_BUILD)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--timeout", type=float, default=900)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("sources", nargs="+", metavar="NAME=FOLDER")
    return parser.parse_args()


def key_of(settings):
    """What a rewriting depends on besides its source: the program and what it was told."""
    with open(os.path.join(settings.tzc, "bin/tzc-rewrite"), "rb") as file:
        program = hashlib.sha256(file.read()).hexdigest()
    built = [] if settings.build_type == USUAL_BUILD else [settings.build_type]
    return [program, settings.only, settings.options, settings.tests, settings.speed, settings.inputs, *built]


def runtime_of(settings):
    """What ports are built, run and compared with."""
    programs = [os.path.join(settings.tzc, "bin", name) for name in ("tzc-compare", "tzc-msggen")]
    libraries = glob.glob(os.path.join(settings.tzc, "devel/lib/libtzc*.so"))
    folders = []
    with contextlib.suppress(FileNotFoundError), open(os.path.join(settings.tzc, "devel/share/tzc/include_folders")) as file:
        folders = file.read().split("\n")
    return digest_of(*filter(os.path.exists, [*programs, *sorted(libraries), *folders]))


def catkin_share():
    """Where catkin's CMake files are."""
    places = [os.path.join(prefix, "share") for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(":") if prefix]
    for share in [*places, "/usr/share"]:
        if os.path.exists(os.path.join(share, "catkin/cmake/toplevel.cmake")):
            return os.path.join(share, "catkin")
    sys.exit("error: catkin was not found; source ROS's setup.bash first")


def save(path, text):
    with open(path + ".new", "w") as file:
        file.write(text)
    os.replace(path + ".new", path)


class Mistake(Exception):
    """Of the command line."""


def repositories(settings):
    """Those of the command line, NAME=FOLDER, whose names and places are fit."""
    found = {}
    for source in settings.sources:
        name, _, path = source.partition("=/")  # a name has no slash, a folder begins with one
        if name in found:
            raise Mistake(f"two sources are called {name}; port them into different --out")
        found[name] = Repository(name, "/" + path, settings)
        places = [os.path.join(os.path.realpath(place), "") for place in (found[name].folder, found[name].out)]
        if os.path.commonprefix(places) in places:
            raise Mistake(f"{found[name].out} and the source {found[name].folder} lie one in the other; name another --out")
    return found.values()


@contextlib.contextmanager
def locked(repository):
    """No two runs build in the same folder."""
    os.makedirs(repository.out, exist_ok=True)
    with open(os.path.join(repository.out, "lock"), "w") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Mistake(f"another run works in {repository.out}") from None
        yield


def port_all(settings):
    results = []
    for repository in repositories(settings):
        with locked(repository):
            known = None if settings.again else repository.saved()
            if known:
                repository.say("is done already")
            results.append(known or repository.run())
        save(os.path.join(settings.out, "table.json"), json.dumps(results, indent=1))
        save(os.path.join(settings.out, "table.txt"), table(results))
    return results


def main():
    ended_by_signals()
    settings = parse_arguments()
    settings.out, settings.tzc = os.path.abspath(settings.out), os.path.abspath(settings.tzc)
    settings.inputs = settings.inputs and os.path.abspath(settings.inputs)
    settings.catkin, settings.key, settings.runtime = catkin_share(), key_of(settings), runtime_of(settings)
    try:
        results = port_all(settings)
        print(table(results), end="", flush=True)
    except (Mistake, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 1 if any(result["problems"] for result in results) else 0


if __name__ == "__main__":
    sys.exit(main())
