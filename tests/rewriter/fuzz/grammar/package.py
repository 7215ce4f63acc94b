# SPDX-License-Identifier: BSD-3-Clause
"""A catkin package of many programs. Program number n of a seed is always the same, whatever stands beside it."""
import os
import random

from . import attacks, builders, libraries, messages, publishers, subscribers
from .program import Program

KINDS = [None, libraries.SENSORS, libraries.VISION, None, libraries.CLOUDS, None, libraries.SENSORS, libraries.VISION,
         None,
         libraries.CLOUDS]


def make_program(seed, index, adversarial=False):
    if adversarial:
        return attacks.make(Program(random.Random(f"adversarial/{seed}/{index}"), index))
    program = Program(random.Random(f"{seed}/{index}"), index)
    library = KINDS[index % len(KINDS)]
    for _ in range(program.rng.choice([1, 1, 2, 3])):
        chance = program.rng.random()
        if library and chance < 0.6:
            pattern = program.rng.choice(library)
            program.traits.append(pattern.__name__)
            pattern(program)
        elif chance < 0.75 and program.rng.random() < 0.25:
            subscribers.relay(program)
        else:
            add_publisher(program)
    for topic in program.topics:
        subscribers.listen(program, topic)
    return program


def add_publisher(program):
    message = messages.choose(program.rng)
    publisher, wrap = publishers.choose(program, program.topic(message))
    lines = builders.choose(program, message, publisher)
    if program.rng.random() < 0.08:
        return add_to_both(program, message)
    program.steps += publishers.in_block(wrap(lines))


def add_to_both(program, message):
    """One message for two publishers."""
    pairs = [publishers.member(program, program.topic(message))[0] for _ in range(2)]
    program.traits.append("two publishers")
    lines = [f"{message.cpp} msg;"] + builders.contents(program, message, "msg.")
    program.steps += publishers.in_block(lines + pairs[0].publish("msg") + pairs[1].publish("msg"))


HEAD = "// SPDX-License-Identifier: BSD-3-Clause\n"
STANDARD = ["algorithm", "cstring", "iterator", "map", "string", "vector"]


def header_text(programs):
    includes = sorted(set().union(*[p.includes for p in programs]) |
                      {"geometry_msgs/Point32.h", "boost/make_shared.hpp", "boost/bind/bind.hpp"})
    text = HEAD + "#pragma once\n" + "".join(f"#include <{one}>\n" for one in includes)
    return text + "\n" + "".join(f"#include <{one}>\n" for one in STANDARD) + "\n#include <fuzz.h>\n\n"


def write_group(folder, number, programs):
    parts = [[], [], []]
    for program in programs:
        for part, lines in zip(parts, program.render()):
            part += lines
    name = f"group_{number}"
    write(f"{folder}/include/fuzz_nodes/{name}.h", header_text(programs) + "\n".join(parts[0]))
    for suffix, part in zip("ab", parts[1:]):
        write(f"{folder}/src/{name}_{suffix}.cpp", HEAD + f'#include "fuzz_nodes/{name}.h"\n\n' + "\n".join(part))
    return [f"src/{name}_a.cpp", f"src/{name}_b.cpp"]


def main_text(programs):
    lines = [HEAD + "#include <ros/ros.h>", "", "#include <fuzz.h>", ""]
    for program in programs:
        lines += [f"namespace {program.name} {{", "void start(ros::NodeHandle& nh);", "void step(int k);",
                  "void listen(ros::NodeHandle& nh);", "}"]
    lines += ["", "int main(int argc, char** argv) {", "  ros::init(argc, argv, fuzz::role(argc, argv));",
              "  ros::NodeHandle nh;",
              "  if (fuzz::listens()) {"]
    lines += [f"    {p.name}::listen(nh);" for p in programs] + ["    return fuzz::listen();", "  }"]
    for program in programs:
        lines += [f'  fuzz::expect("{t.name}", {2 + t.relays}, {t.relays});' for t in program.topics]
    lines += [f"  {p.name}::start(nh);" for p in programs] + ["  fuzz::wait_for_all();",
              "  for (int k = 0; k < fuzz::rounds; ++k) {"]
    for program in programs:
        lines += [f'    fuzz::running("{program.name}");', f"    {program.name}::step(k);", "    fuzz::settle();"]
    return "\n".join(lines + ["    fuzz::round_done();", "  }", "  return fuzz::finish();", "}", ""])


PACKAGE_XML = """<package format="2">
  <name>fuzz_nodes</name>
  <version>0.0.0</version>
  <description>Generated programs</description>
  <maintainer email="nobody@example.org">Nobody</maintainer>
  <license>BSD</license>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>roscpp</depend>
</package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.0.2)
project(fuzz_nodes)
find_package(catkin REQUIRED COMPONENTS roscpp)
catkin_package()
include_directories(include ${catkin_INCLUDE_DIRS})
add_executable(fuzz_nodes %s)
target_link_libraries(fuzz_nodes ${catkin_LIBRARIES})
"""


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w") as file:
        file.write(text.rstrip() + "\n")


def write_package(folder, programs, group_size=50):
    """Writes the package; returns its sources, relative to it. A unit costs more than the programs in it."""
    sources = ["src/main.cpp"]
    write(f"{folder}/src/main.cpp", main_text(programs))
    for first in range(0, len(programs), group_size):
        sources += write_group(folder, first // group_size, programs[first:first + group_size])
    write(f"{folder}/package.xml", PACKAGE_XML)
    write(f"{folder}/CMakeLists.txt", CMAKE % " ".join(sources))
    return sources
