# SPDX-License-Identifier: BSD-3-Clause
"""A catkin package of many programs, or two, of which the other has functions for the programs. Program number n of a seed
is always the same, whatever stands beside it."""
import os
import random

from . import attacks, builders, libraries, messages, publishers, subscribers
from .program import Program

KINDS = [None, libraries.SENSORS, libraries.VISION, None, libraries.CLOUDS, None, libraries.SENSORS, libraries.VISION,
         None,
         libraries.CLOUDS]


NODES, TOOLS = "fuzz_nodes", "fuzz_tools"
ROUNDS = 8  # how often each program publishes on each of its topics


def make_program(seed, index, adversarial=False, siblings=False):
    if adversarial:
        return attacks.make(Program(random.Random(f"adversarial/{seed}/{index}"), index, siblings))
    program = Program(random.Random(f"{seed}/{index}"), index, siblings)
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
    header = header_text(programs)
    if programs[0].siblings:
        header += f"#include <{TOOLS}/{name}.h>\n\n"
    write(f"{folder}/include/{NODES}/{name}.h", header + "\n".join(parts[0]))
    for suffix, part in zip("ab", parts[1:]):
        write(f"{folder}/src/{name}_{suffix}.cpp", HEAD + f'#include "{NODES}/{name}.h"\n\n' + "\n".join(part))
    return [f"src/{name}_a.cpp", f"src/{name}_b.cpp"]


def write_sibling_group(folder, number, programs):
    header, source = [], []
    for program in programs:
        for part, lines in zip((header, source), program.render_sibling()):
            part += lines
    name = f"group_{number}"
    write(f"{folder}/include/{TOOLS}/{name}.h", header_text(programs) + "\n".join(header))
    write(f"{folder}/src/{name}.cpp", HEAD + f'#include "{TOOLS}/{name}.h"\n\n' + "\n".join(source))
    return [f"src/{name}.cpp"]


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
              f"  for (int k = 0; k < {ROUNDS}; ++k) {{"]
    for program in programs:
        lines += [f'    fuzz::running("{program.name}");', f"    {program.name}::step(k);", "    fuzz::settle();"]
    lines += ["    fuzz::round_done();", f'    if (k == {ROUNDS // 2 - 1}) fuzz::write_counters("counters_half.json");', "  }",
              "  return fuzz::finish();", "}", ""]
    return "\n".join(lines)


PACKAGE_XML = """<package format="2">
  <name>%s</name>
  <version>0.0.0</version>
  <description>Generated programs</description>
  <maintainer email="nobody@example.org">Nobody</maintainer>
  <license>BSD</license>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>roscpp</depend>
%s</package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.0.2)
project(%s)
find_package(catkin REQUIRED COMPONENTS roscpp%s)
catkin_package(%s)
include_directories(include ${catkin_INCLUDE_DIRS})
%s(${PROJECT_NAME} %s)
target_link_libraries(${PROJECT_NAME} ${catkin_LIBRARIES})
"""


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w") as file:
        file.write(text.rstrip() + "\n")


def groups(programs, size):
    return enumerate(programs[first:first + size] for first in range(0, len(programs), size))


def write_nodes(folder, programs, group_size):
    """The programs' package; its sources."""
    sources = ["src/main.cpp"]
    write(f"{folder}/src/main.cpp", main_text(programs))
    for number, group in groups(programs, group_size):
        sources += write_group(folder, number, group)
    siblings = programs[0].siblings
    write(f"{folder}/package.xml", PACKAGE_XML % (NODES, f"  <depend>{TOOLS}</depend>\n" if siblings else ""))
    write(f"{folder}/CMakeLists.txt",
          CMAKE % (NODES, f" {TOOLS}" if siblings else "", "", "add_executable", " ".join(sources)))
    return sources


def write_tools(folder, programs, group_size):
    """The package whose functions the programs call; its sources."""
    sources = [source for number, group in groups(programs, group_size)
               for source in write_sibling_group(folder, number, group)]
    write(f"{folder}/package.xml", PACKAGE_XML % (TOOLS, ""))
    write(f"{folder}/CMakeLists.txt", CMAKE % (TOOLS, "", f"INCLUDE_DIRS include LIBRARIES {TOOLS} CATKIN_DEPENDS roscpp",
                                               "add_library", " ".join(sources)))
    return sources


def write_packages(folder, programs, group_size=50):
    """Writes the packages below a folder; {name: sources, relative to the package}. A unit costs more than the programs in
    it."""
    packages = {NODES: write_nodes(f"{folder}/{NODES}", programs, group_size)}
    if programs[0].siblings:
        packages[TOOLS] = write_tools(f"{folder}/{TOOLS}", programs, group_size)
    return packages
