# SPDX-License-Identifier: BSD-3-Clause
"""Compiles generated packages, with the stock headers precompiled, and says how they are compiled."""
import concurrent.futures
import hashlib
import json
import os
import shlex
import subprocess

# Of the libraries that programs use. TZC's own headers are not among them: what a ported file needs it must include.
PRECOMPILED = ["ros/ros.h", "sensor_msgs/Image.h", "sensor_msgs/PointCloud2.h", "sensor_msgs/point_cloud2_iterator.h",
               "visualization_msgs/Marker.h", "nav_msgs/OccupancyGrid.h", "cv_bridge/cv_bridge.h",
               "image_transport/image_transport.h", "image_transport/subscriber_filter.h",
               "message_filters/subscriber.h",
               "pcl_conversions/pcl_conversions.h", "pcl_ros/point_cloud.h"]


class Failure(Exception):
    """Something that must not happen did; the text says what."""


class Toolchain:
    def __init__(self, config, jobs):
        self.config, self.jobs = config, jobs
        self.harness = os.path.join(os.path.dirname(os.path.abspath(__file__)), "harness")

    def flags(self, package):
        folders = [f"-I{package}/include", f"-I{self.harness}"]
        folders += [f"-isystem{folder}" for folder in self.config["includes"] if folder != "/usr/include"]
        return ["-std=gnu++17", "-w", "-O0", "-fPIC", "-DBOOST_BIND_GLOBAL_PLACEHOLDERS"] + folders

    def tzc_flags(self):
        return [f"-I{folder}" for folder in self.config["tzc_includes"]]

    def write_commands(self, package, build, sources):
        """compile_commands.json, as catkin would have it made."""
        os.makedirs(build, exist_ok=True)
        entries = [{"directory": build, "file": f"{package}/{source}",
                    "command": shlex.join(["c++", *self.flags(package), *self.tzc_flags(), "-o",
                                           f"CMakeFiles/fuzz_nodes.dir/{source}.o", "-c", f"{package}/{source}"])}
                   for source in sources]
        with open(f"{build}/compile_commands.json", "w") as file:
            json.dump(entries, file, indent=1)

    def precompiled(self, folder):
        """Made once for a build folder."""
        text = "".join(f"#include <{header}>\n" for header in PRECOMPILED)
        command = ["g++", "-x", "c++-header", *self.flags("precompiled")]
        name = f"{folder}/{hashlib.sha1(repr((text, command)).encode()).hexdigest()[:12]}.h"
        if not os.path.exists(name + ".gch"):
            os.makedirs(folder, exist_ok=True)
            with open(name, "w") as file:
                file.write(text)
            check([*command, name, "-o", name + ".tmp"], "precompiling the stock headers")
            os.rename(name + ".tmp", name + ".gch")
        return name

    def build(self, package, build, sources, precompiled, ported):
        """Compiles and links a package; its executable."""
        extra = (["-DFUZZ_TZC"] if ported else []) + self.tzc_flags()
        commands = [(f"{build}/{source.replace('/', '_')}.o", f"{package}/{source}",
                     ["-include", precompiled]) for source in sources]
        commands.append((f"{build}/fuzz.o", f"{self.harness}/fuzz.cpp", []))
        os.makedirs(build, exist_ok=True)

        def compile_one(command):
            output, source, more = command
            check(["g++", *more, *self.flags(package), *extra, "-c", source, "-o", output], f"compiling {source}")
            return output

        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            objects = list(pool.map(compile_one, commands))
        libraries = self.config["libraries"] + (self.config["tzc_libraries"] if ported else [])
        libraries = [one if one.startswith(("/", "-")) else f"-l{one}" for one in libraries]
        folders = sorted({os.path.dirname(library) for library in libraries if "/" in library})
        check(["g++", "-o", f"{build}/fuzz_nodes", *objects, *libraries, "-Wl,-rpath," + ":".join(folders)], "linking")
        return f"{build}/fuzz_nodes"


def check(command, what):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise Failure(f"{what} failed:\n" + done.stdout.decode(errors="replace")[:6000])
    return done
