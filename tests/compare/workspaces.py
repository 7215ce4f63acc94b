# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of tzc-compare compare, and how they call it. The program's first arguments are BUILD_FOLDER REPOSITORY SCRATCH."""
import json
import os
import shutil
import subprocess
import sys

BUILD, REPOSITORY, SCRATCH = (os.path.abspath(path) for path in sys.argv[1:4])
COMPARE = os.path.join(BUILD, "bin", "tzc-compare")
SAMPLE = os.path.join(REPOSITORY, "samples", "camera_pair")
EDITS = {
    "original": None,
    "changed": ("row[3 * x + 2] = 3 * frame_;", "row[3 * x + 2] = 3 * frame_ + (frame_ == 20 && x == 7 && y == 5);"),
    "lossy": ("  publishFrame();\n", "  if (frame_ % 10 != 3) publishFrame();\n"),
}


def environment():
    return dict(os.environ, PATH="/usr/bin:" + os.environ["PATH"], ROS_VERSION="1", ROS_PYTHON_VERSION="3")


def call(command, **more):
    done = subprocess.run(command, env=dict(environment(), **more), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{command} failed:\n{done.stdout.decode(errors='replace')[-3000:]}")


def build(workspace):
    """catkin_make, as a user does it, with this build tree among the prefixes."""
    call(["catkin_make", "-C", workspace, "-j2", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache",
          "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DPYTHON_EXECUTABLE=/usr/bin/python3"],
         CMAKE_PREFIX_PATH=os.path.join(BUILD, "devel"))


def camera_workspace(name):
    """A built workspace with the sample, edited. Made once for all tests."""
    workspace = os.path.join(SCRATCH, "camera_" + name)
    if os.path.exists(os.path.join(workspace, "devel", "lib", "camera_pair", "camera_node")):
        return workspace
    shutil.rmtree(workspace, ignore_errors=True)
    package = os.path.join(workspace, "src", "camera_pair")
    shutil.copytree(SAMPLE, package)
    source = os.path.join(package, "src", "camera_node.cpp")
    if EDITS[name]:
        with open(source) as file:
            text = file.read()
        assert text.count(EDITS[name][0]) == 1, "the sample is not what this test expects"
        with open(source, "w") as file:
            file.write(text.replace(*EDITS[name]))
    build(workspace)
    return workspace


def is_newer(path, than):
    return not os.path.exists(than) or os.path.getmtime(path) > os.path.getmtime(than)


def ported_workspace():
    """Made again when the tool or the runtime has changed since, whose headers the node was compiled with."""
    workspace = os.path.join(SCRATCH, "camera_ported")
    node = os.path.join(workspace, "devel", "lib", "camera_pair", "camera_node")
    made_with = [os.path.join(BUILD, "bin", "tzc-rewrite"), os.path.join(BUILD, "devel", "lib", "libtzc_roscpp.so")]
    if any(is_newer(path, node) for path in made_with):
        original = camera_workspace("original")
        shutil.rmtree(workspace, ignore_errors=True)
        os.makedirs(os.path.join(workspace, "src"))
        call([os.path.join(BUILD, "bin", "tzc-rewrite"), "-p", os.path.join(original, "build"), "--out-dir",
              os.path.join(workspace, "src"), os.path.join(original, "src", "camera_pair")])
        build(workspace)
    return workspace


def node_workspace(name, node):
    """A workspace whose setup.bash names the node to run: what --command runs differs without a build."""
    workspace = os.path.join(SCRATCH, "node_" + name)
    os.makedirs(workspace, exist_ok=True)
    with open(os.path.join(workspace, "setup.bash"), "w") as file:
        file.write(f"export NODE='{node}'\n")
    return workspace


def recording():
    """40 stamped messages in 4 seconds."""
    path = os.path.join(SCRATCH, "input.bag")
    if not os.path.exists(path):
        import genpy
        import rosbag
        from std_msgs.msg import Header
        from sensor_msgs.msg import Image
        with rosbag.Bag(path, "w") as bag:
            for index in range(40):
                stamp = genpy.Time.from_sec(1000 + index / 10)
                bag.write("/in", Image(header=Header(stamp=stamp, frame_id="lens"), height=1, width=8, step=8, encoding="mono8",
                                       data=bytes([index] * 8)), stamp)
    return path


def slow_recording():
    """Loaded in a second and compared in half a minute: each of its 40 streams leads through all compressed chunks."""
    path = os.path.join(SCRATCH, "slow.bag")
    if not os.path.exists(path):
        import genpy
        import rosbag
        from sensor_msgs.msg import Image
        with rosbag.Bag(path + ".new", "w", compression="bz2") as bag:
            for index in range(400):
                bag.write(f"/stream{index % 40}", Image(data=os.urandom(20000)), genpy.Time.from_sec(1000 + index / 10))
        os.rename(path + ".new", path)
    return path


# In place of the recorder: it brings a bag, whatever the nodes publish.
STAND_IN = """#!/usr/bin/python3
import json, select, shutil, sys
shutil.copy(BAG, sys.argv[sys.argv.index("--bag") + 1])
status = {"graph": "1", "nodes": ["/relay"], "topics": 1, "ready": True, "messages": 1, "inputs": 1, "error": ""}
summary = {"now": 1, "traffic": [], "topics": [], "late": [], "left_out": [],
           "inputs": [[1700000000000000000 + i, 1700000000000000000 + i] for i in range(INPUTS)]}
while True:
    print(json.dumps(status), flush=True)
    if select.select([0], [], [], 0.1)[0]:
        if not sys.stdin.readline():
            break
        print(json.dumps({"summary": summary}), flush=True)
"""


def tool_with_stand_in(name, bag, inputs):
    """A copy of the tool, beside a stand-in for its recorder that tells of so many input messages."""
    folder = os.path.join(SCRATCH, name)
    os.makedirs(folder, exist_ok=True)
    tool, recorder = (os.path.join(folder, program) for program in ("tzc-compare", "tzc-compare-recorder"))
    shutil.copy(COMPARE, tool)
    with open(recorder, "w") as file:
        file.write(STAND_IN.replace("BAG", repr(bag)).replace("INPUTS", str(inputs)))
    os.chmod(recorder, 0o755)
    return tool


def compare(original, port, *arguments):
    """Exit status, text, and the result; null when there is none."""
    result = os.path.join(SCRATCH, "result.json")
    if os.path.exists(result):
        os.remove(result)
    done = subprocess.run([COMPARE, original, port, "--quiet", "--json", result, *arguments], env=environment(),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300, check=False)
    text = done.stdout.decode(errors="replace")
    if not os.path.exists(result):
        return done.returncode, text, None
    with open(result) as file:
        return done.returncode, text, json.load(file)


def findings(result, topic):
    [stream] = [stream for stream in result["streams"] if stream["topic"] == topic]
    return {(found["cause"], found.get("field")): found for found in stream["findings"]}, stream


def processes_of(folder):
    """Processes whose ROS session lies in the folder, by their environment."""
    found = []
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{pid}/environ", "rb") as variables:
                if b"ROS_LOG_DIR=" + folder.encode() in variables.read():
                    found.append(int(pid))
        except OSError:
            continue  # it has ended, or is another user's
    return found
