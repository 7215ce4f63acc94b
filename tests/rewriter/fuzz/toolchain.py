# SPDX-License-Identifier: BSD-3-Clause
"""Compiles generated packages, with the stock headers precompiled, and says how they are compiled."""
import concurrent.futures
import hashlib
import json
import os
import shlex
import shutil
import subprocess
import tempfile

# Of the libraries that programs use. TZC's own headers are not among them: what a ported file needs it must include.
PRECOMPILED = ["ros/ros.h", "sensor_msgs/Image.h", "sensor_msgs/PointCloud2.h", "sensor_msgs/point_cloud2_iterator.h",
               "visualization_msgs/Marker.h", "nav_msgs/OccupancyGrid.h", "cv_bridge/cv_bridge.h",
               "image_transport/image_transport.h", "image_transport/subscriber_filter.h",
               "message_filters/subscriber.h",
               "pcl_conversions/pcl_conversions.h", "pcl_ros/point_cloud.h"]


class Failure(Exception):
    """Something that must not happen did; the text says what."""


# As tzc-rewrite parses: its Clang takes no header that was precompiled with other macros, and rejects old code without.
AS_PARSED = ["-DTZC_ENABLED", "-Wno-enum-constexpr-conversion", "-Wno-missing-template-arg-list-after-template-kw"]


class Toolchain:
    def __init__(self, config, jobs):
        self.config, self.jobs = config, jobs
        self.harness = os.path.join(os.path.dirname(os.path.abspath(__file__)), "harness")
        self.linker = ["-fuse-ld=lld"] if shutil.which("ld.lld") else []
        self.objects = tempfile.TemporaryDirectory()  # of the harness, compiled once

    def flags(self, source_space, packages):
        folders = [f"-I{source_space}/{package}/include" for package in packages] + [f"-I{self.harness}"]
        folders += [f"-isystem{folder}" for folder in self.config["includes"] if folder != "/usr/include"]
        return ["-std=gnu++17", "-w", "-O0", "-fPIC", "-DBOOST_BIND_GLOBAL_PLACEHOLDERS"] + folders

    def tzc_flags(self):
        return [f"-I{folder}" for folder in self.config["tzc_includes"]]

    def write_commands(self, source_space, build, packages, precompiled=None):
        """compile_commands.json, as catkin would have it made."""
        os.makedirs(build, exist_ok=True)
        first = ["-include", precompiled] if precompiled else []
        flags = [*first, *self.flags(source_space, packages), *self.tzc_flags()]
        entries = [{"directory": build, "file": f"{source_space}/{package}/{source}",
                    "command": shlex.join(["c++", *flags, "-o", f"CMakeFiles/{package}.dir/{source}.o", "-c",
                                           f"{source_space}/{package}/{source}"])}
                   for package, sources in packages.items() for source in sources]
        with open(f"{build}/compile_commands.json", "w") as file:
            json.dump(entries, file, indent=1)

    def precompiled(self, folder):
        """The stock headers as one, made once for a folder: for g++, and for tzc-rewrite where there is its Clang."""
        text = "".join(f"#include <{header}>\n" for header in PRECOMPILED)
        flags = ["-x", "c++-header", *self.flags("precompiled", ["stock"])]
        commands = {".gch": ["g++", *flags]}
        if self.config["clang"]:
            commands[".pch"] = [self.config["clang"], *flags, *AS_PARSED]
        name = f"{folder}/{hashlib.sha1(repr((text, commands)).encode()).hexdigest()[:12]}.h"
        if not os.path.exists(name):
            write_once(name, lambda path: write(path, text))
        for suffix, command in commands.items():
            if not os.path.exists(name + suffix):
                write_once(name + suffix, lambda path, made_by=command: check([*made_by, name, "-o", path],
                                                                              "precompiling the stock headers"))
        return name

    def build(self, source_space, build, packages, precompiled, ported):
        """Compiles and links packages; the executable."""
        extra = (["-DFUZZ_TZC"] if ported else []) + self.tzc_flags()
        commands = [(f"{build}/{package}_{source.replace('/', '_')}.o", f"{source_space}/{package}/{source}",
                     ["-include", precompiled]) for package, sources in packages.items() for source in sources]
        harness = f"{self.objects.name}/{'ported' if ported else 'original'}.o"
        if not os.path.exists(harness):
            commands.append((harness, f"{self.harness}/fuzz.cpp", []))
        os.makedirs(build, exist_ok=True)

        def compile_one(command):
            output, source, more = command
            check(["g++", *more, *self.flags(source_space, packages), *extra, "-c", source, "-o", output], f"compiling {source}")
            return output

        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            objects = {*pool.map(compile_one, commands), harness}
        libraries = self.config["libraries"] + (self.config["tzc_libraries"] if ported else [])
        libraries = [one if one.startswith(("/", "-")) else f"-l{one}" for one in libraries]
        folders = sorted({os.path.dirname(library) for library in libraries if "/" in library})
        check(["g++", *self.linker, "-o", f"{build}/fuzz_nodes", *sorted(objects), *libraries,
               "-Wl,-rpath," + ":".join(folders)], "linking")
        return f"{build}/fuzz_nodes"


def write(path, text):
    with open(path, "w") as file:
        file.write(text)


def write_once(path, make):
    """A file that is complete as soon as it has its name."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    unfinished = f"{path}.{os.getpid()}"
    make(unfinished)
    os.rename(unfinished, path)


def check(command, what):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise Failure(f"{what} failed:\n" + done.stdout.decode(errors="replace")[:6000])
    return done
