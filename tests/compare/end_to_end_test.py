# SPDX-License-Identifier: BSD-3-Clause
"""tzc-compare on real nodes: a sample that is left alone, changed, made lossy, and ported; a relay that is fed from a bag.

usage: end_to_end_test.py BUILD_FOLDER REPOSITORY SCRATCH [CASE...]
"""
import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
import unittest.mock

BUILD, REPOSITORY, SCRATCH = (os.path.abspath(path) for path in sys.argv[1:4])
COMPARE = os.path.join(BUILD, "bin", "tzc-compare")
SAMPLE = os.path.join(REPOSITORY, "samples", "camera_pair")
CAMERA = "rosrun camera_pair camera_node _width:=160 _height:=120 _count:=60 _subscribers:=1 __name:=camera"
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


class Camera(unittest.TestCase):
    """Stamps differ from run to run, and there is no input."""

    def test_original_against_itself_is_equal(self):
        status, text, result = compare(camera_workspace("original"), camera_workspace("original"), "--command", CAMERA)
        self.assertEqual(status, 0, text)
        found, stream = findings(result, "/camera/image")
        self.assertEqual(set(found), {("content", "header.stamp")}, text)
        self.assertFalse(found["content", "header.stamp"]["different"])
        self.assertEqual((stream["original_messages"], stream["pairs"]), (60, 60))
        self.assertIn("EQUAL", text)

    def test_stamps_can_be_left_out(self):
        status, text, result = compare(camera_workspace("original"), camera_workspace("original"), "--command", CAMERA,
                                       "--ignore-stamps", "--runs", "1")
        self.assertEqual(status, 0, text)
        self.assertEqual(findings(result, "/camera/image")[1]["outcome"], "equal")

    def test_one_changed_byte_is_found_and_named(self):
        status, text, result = compare(camera_workspace("original"), camera_workspace("changed"), "--command", CAMERA)
        self.assertEqual(status, 1, text)
        found, stream = findings(result, "/camera/image")
        self.assertTrue(found["content", "data[]"]["different"])
        self.assertEqual(found["content", "data[]"]["count"], 1)
        [field] = [field for field in stream["fields"] if field["field"] == "data[]"]
        self.assertEqual(field["first"]["where"], "data[2423]")  # row 5 of 480 bytes, column 7 of 3, blue
        self.assertEqual((field["first"]["original"], field["first"]["port"]), ("60", "61"))
        self.assertEqual(stream["missing"]["between"], 0, "a change is no loss")
        self.assertIn("data[2423] at byte 2470", text)

    def test_loss_is_told_from_content(self):
        status, text, result = compare(camera_workspace("original"), camera_workspace("lossy"), "--command", CAMERA)
        self.assertEqual(status, 1, text)
        found, _ = findings(result, "/camera/image")
        self.assertEqual(found["loss", None]["count"], 6, text)
        self.assertEqual([key for key, entry in found.items() if entry["different"]], [("loss", None)])

    def test_a_launch_file_that_runs_on(self):
        workspace = camera_workspace("original")
        status, text, result = compare(workspace, workspace, "--launch", "camera_pair camera_pair.launch rate:=5",
                                       "--duration", "6")
        self.assertEqual(status, 0, text)
        copies = {entry["topic"]: entry for entry in result["port_resources"]["copies"]}["/camera/image"]
        self.assertEqual(copies["connections"], 2, "the viewer and the recorder")
        self.assertGreater(copies["socket_bytes"] / copies["deliveries"], 1920 * 1080 * 3)
        self.assertGreater(result["port_resources"]["cpu_seconds"]["camera"], 0)

    @unittest.skipUnless(os.path.exists(os.path.join(BUILD, "bin", "tzc-rewrite")), "this build has no rewriter")
    def test_a_port_is_equal_and_goes_through_shared_memory(self):
        status, text, result = compare(camera_workspace("original"), ported_workspace(), "--command",
                                       CAMERA.replace("_width:=160 _height:=120", "_width:=640 _height:=480"))
        self.assertEqual(status, 0, text)
        copies = {entry["topic"]: entry for entry in result["port_resources"]["copies"]}["/camera/image"]
        self.assertEqual((copies["connections"], copies["shared_connections"]), (1, 1), text)
        self.assertEqual(copies["copied_into_shared_memory_bytes"], 0)


class Relay(unittest.TestCase):
    """The input's stamps come through, and a bag says when it begins and ends."""
    RELAY = f"/usr/bin/python3 {os.path.dirname(os.path.abspath(__file__))}/relay.py"

    def compare(self, port, *arguments, original=RELAY):
        return compare(node_workspace("original", original), node_workspace("port", port), "--command", "exec $NODE", "--bag",
                       recording(), "--settle", "1", "--quiet-time", "1", *arguments)

    def test_equal(self):
        status, text, result = self.compare(self.RELAY)
        self.assertEqual(status, 0, text)
        _, stream = findings(result, "/out")
        self.assertEqual((stream["outcome"], stream["paired_by"], stream["pairs"]), ("equal", "stamp", 40), text)
        [latency] = result["port_resources"]["latency"]
        self.assertTrue(latency["p99_us"] < 1e6 and latency["messages"] == 40, latency)

    def test_loss(self):
        status, text, result = self.compare(self.RELAY + " --lose-each 4")
        self.assertEqual(status, 1, text)
        found, stream = findings(result, "/out")
        self.assertEqual(set(found), {("loss", None)}, text)
        self.assertEqual(found["loss", None]["count"], 10, "the last message too: the bag says that there is one")
        self.assertEqual(stream["equal"], 30, "what came is equal")

    def test_a_port_that_crashes_when_it_ends(self):
        crash = "bash -c \"" + self.RELAY + "; kill -SEGV \\$\\$\""
        status, text, result = compare(node_workspace("original", self.RELAY), node_workspace("port", crash), "--command",
                                       "eval exec $NODE", "--bag", recording(), "--settle", "1", "--quiet-time", "1",
                                       "--runs", "1")
        self.assertEqual(status, 1, text)
        self.assertEqual(result["port_failures"], ["eval exec $NODE: signal 11"])
        self.assertIn("DIED", text)

    def test_a_topic_that_is_missing(self):
        status, text, result = self.compare(self.RELAY + " --output /elsewhere", "--runs", "1")
        self.assertEqual(status, 1, text)
        self.assertIn(("not_published", None), findings(result, "/out")[0])
        self.assertIn(("new_topic", None), findings(result, "/elsewhere")[0])

    def test_a_topic_that_comes_with_its_first_message(self):
        lazy = "rosrun topic_tools relay /in /out __name:=relay"
        status, text, result = self.compare(lazy, original=lazy)
        self.assertEqual(status, 0, text)
        self.assertEqual(result["late_topics"], ["/out"])
        self.assertGreater(findings(result, "/out")[1]["pairs"], 20)

    def test_what_is_selected_says_nothing_about_the_input(self):
        lazy = "rosrun topic_tools relay /in /out __name:=relay"
        status, text, result = self.compare(lazy, "--topic", "/out", original=lazy)
        self.assertEqual(status, 0, text)
        self.assertEqual((result["late_topics"], result["topics_left_out"]), (["/out"], []))
        [latency] = result["port_resources"]["latency"]
        self.assertGreater(latency["messages"], 20)

    def test_simulated_time_and_a_quicker_bag(self):
        status, text, _ = self.compare(self.RELAY, "--clock", "--play-args=--rate=2", "--runs", "1")
        self.assertEqual(status, 0, text)


    def test_the_users_namespace_moves_the_nodes_and_not_the_input(self):
        with unittest.mock.patch.dict(os.environ, ROS_NAMESPACE="/robot"):
            status, text, result = self.compare(self.RELAY, "--runs", "1")
        outputs = [(stream["topic"], stream["node"], stream["pairs"]) for stream in result["streams"]]
        self.assertEqual((status, outputs), (0, [("/out", "/robot/relay", 40)]), text)


class Launch(unittest.TestCase):
    """A launch file with a node that ends after some seconds, as the workspace says."""

    def compare(self, name, required, original, port):
        launch = os.path.join(SCRATCH, "ends.launch")
        with open(launch, "w") as file:
            file.write(f"""<launch>
  <node name="talker" pkg="rostopic" type="rostopic" args="pub -r 10 /out std_msgs/String hello"/>
  <node name="{name}" required="{required}" pkg="rostopic" type="rostopic" launch-prefix="$(env NODE)"/>
</launch>""")
        return compare(node_workspace("original", original), node_workspace("port", port), "--launch", launch, "--settle", "1",
                       "--duration", "8", "--runs", "1")

    def test_a_required_node_that_fails(self):
        status, text, result = self.compare("ends", "true", 'bash -c "sleep 6"', 'bash -c "sleep 6; exit 3"')
        self.assertEqual(status, 1, text)
        self.assertEqual((result["original_failures"], result["port_failures"]), ([], ["ends: exit code 3"]))
        self.assertIn("DIED, in the port only: ends: exit code 3", text)

    def test_an_anonymous_node_that_fails_in_both(self):
        fails = 'bash -c "sleep 2; exit 3"'
        status, text, result = self.compare("$(anon ends)", "false", fails, fails)
        self.assertEqual(status, 0, text)
        [failure] = result["original_failures"]
        self.assertRegex(failure, r"^ends_.*\*: exit code 3$")
        self.assertEqual(result["port_failures"], [])


class Errors(unittest.TestCase):
    def test_no_workspace(self):
        status, text, _ = compare(SCRATCH, SCRATCH, "--command", "true")
        self.assertEqual(status, 2)
        self.assertIn("build the workspace", text)

    def test_nodes_that_do_not_start(self):
        workspace = node_workspace("original", "")
        with unittest.mock.patch.dict(os.environ, ROS_HOME="/the/users"):
            status, text, _ = compare(workspace, workspace, "--command", "echo a bad day in $ROS_HOME; exit 3")
        self.assertEqual(status, 2)
        self.assertIn("a bad day in /the/users", text)

    def test_a_setup_file_that_fails_comes_with_a_command_that_shows_it(self):
        workspace = node_workspace("that's broken", "'; echo it is broken; exit 1; '")
        status, text, _ = compare(workspace, workspace, "--command", "true")
        shown = subprocess.run(text.split("try it: ")[1], shell=True, stdout=subprocess.PIPE, text=True, check=False)
        self.assertEqual((status, shown.returncode, shown.stdout), (2, 1, "it is broken\n"), text)

    def test_nodes_that_are_not_there_are_named(self):
        launch = os.path.join(SCRATCH, "missing.launch")
        with open(launch, "w") as file:
            file.write("""<launch>
  <node name="there" pkg="topic_tools" type="relay" args="/in /out"/>
  <node name="not_there" pkg="topic_tools" type="no_such_node"/>
</launch>""")
        workspace = node_workspace("original", "")
        status, text, _ = compare(workspace, workspace, "--launch", launch, "--settle", "1", "--duration", "1")
        self.assertEqual(status, 2, text)
        self.assertIn("published nothing", text)
        self.assertIn("topic_tools/no_such_node: cannot be launched", text)

    def test_no_input_at_all(self):
        self.assertEqual(compare(SCRATCH, SCRATCH)[0], 2)

    def test_mistakes_are_found_before_anything_runs(self):
        workspace = node_workspace("original", "")
        for mistake in (["--json", SCRATCH], ["--json", "/no/such/folder/a.json"], ["--duration", "nan"], ["--allow-loss", "nan"]):
            done = subprocess.run([COMPARE, workspace, workspace, "--command", "touch started", *mistake], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True, cwd=SCRATCH, timeout=60, check=False)
            self.assertEqual(done.returncode, 2, mistake)
            self.assertIn(mistake[0], done.stderr)
            self.assertFalse(os.path.exists(os.path.join(SCRATCH, "started")))


class LongInput(unittest.TestCase):
    """A recorder that tells of 400,000 input messages, as after half an hour of an IMU: a stand-in, beside a copy of the tool."""
    RECORDER = """#!/usr/bin/python3
import json, select, shutil, sys
shutil.copy(INPUT, sys.argv[sys.argv.index("--bag") + 1])
status = {"graph": "1", "nodes": ["/relay"], "topics": 1, "ready": True, "messages": 1, "inputs": 1, "error": ""}
summary = {"now": 1, "traffic": [], "topics": [], "late": [], "left_out": [],
           "inputs": [[1700000000000000000 + i, 1700000000000000000 + i] for i in range(400000)]}
while True:
    print(json.dumps(status), flush=True)
    if select.select([0], [], [], 0.1)[0]:
        if not sys.stdin.readline():
            break
        print(json.dumps({"summary": summary}), flush=True)
"""

    def test_the_summary_is_read_whole(self):
        folder = os.path.join(SCRATCH, "long_input")
        os.makedirs(folder, exist_ok=True)
        tool, recorder = (os.path.join(folder, name) for name in ("tzc-compare", "tzc-compare-recorder"))
        shutil.copy(COMPARE, tool)
        with open(recorder, "w") as file:
            file.write(self.RECORDER.replace("INPUT", repr(recording())))
        os.chmod(recorder, 0o755)
        workspace = node_workspace("original", "")
        done = subprocess.run([tool, workspace, workspace, "--quiet", "--runs", "1", "--settle", "0.1", "--duration", "1",
                               "--command", "sleep 5"], env=environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stdout.decode(errors="replace"))


class Stopping(unittest.TestCase):
    def interrupt(self, sig):
        folder = os.path.join(SCRATCH, "stopped")
        shutil.rmtree(folder, ignore_errors=True)
        workspace = node_workspace("original", "")
        tool = subprocess.Popen([COMPARE, workspace, workspace, "--keep", folder, "--duration", "60", "--command",
                                 "sleep 1000 & rosrun topic_tools relay /in /out"], env=environment(),
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        for line in tool.stderr:
            if b"running" in line:
                break
        self.assertGreaterEqual(len(processes_of(folder)), 4, "roscore, rosmaster, recorder, relay, sleep")
        tool.send_signal(sig)
        return tool, folder

    def assert_gone(self, folder, seconds):
        deadline = time.monotonic() + seconds
        while processes_of(folder) and time.monotonic() < deadline:
            time.sleep(0.1)
        self.assertEqual(processes_of(folder), [])

    def test_ctrl_c_leaves_nothing_behind(self):
        for end in (signal.SIGINT, signal.SIGQUIT):
            tool, folder = self.interrupt(end)
            self.assertIn(b"stopping what was started", tool.stderr.read())
            self.assertEqual(tool.wait(60), 130)
            tool.stderr.close()
            self.assertEqual(processes_of(folder), [], "all is gone when it ends")


if __name__ == "__main__":
    os.makedirs(SCRATCH, exist_ok=True)
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
