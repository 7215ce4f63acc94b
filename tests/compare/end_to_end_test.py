# SPDX-License-Identifier: BSD-3-Clause
"""tzc-compare on real nodes: a sample that is left alone, changed, made lossy, and ported; a relay that is fed from a bag.

usage: end_to_end_test.py BUILD_FOLDER REPOSITORY SCRATCH [CASE...]
"""
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
import unittest.mock

from workspaces import (BUILD, COMPARE, SCRATCH, camera_workspace, compare, environment, findings, node_workspace, ported_workspace,
                        processes_of, recording, slow_recording, tool_with_stand_in)

CAMERA = "rosrun camera_pair camera_node _width:=160 _height:=120 _count:=60 _subscribers:=1 __name:=camera"


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
        for mistake in (["--json", SCRATCH], ["--json", "/no/such/folder/a.json"], ["--duration", "nan"], ["--allow-loss", "nan"],
                        ["--clock"], ["--play-args", "x"], ["--quiet-time", "3"]):
            done = subprocess.run([COMPARE, workspace, workspace, "--command", "touch started", *mistake], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True, cwd=SCRATCH, timeout=60, check=False)
            self.assertEqual(done.returncode, 2, mistake)
            self.assertIn(mistake[0], done.stderr)
            self.assertFalse(os.path.exists(os.path.join(SCRATCH, "started")))


class LongInput(unittest.TestCase):
    """A recorder that tells of 400,000 input messages, as after half an hour of an IMU."""

    def test_the_summary_is_read_whole(self):
        tool, workspace = tool_with_stand_in("long_input", recording(), 400000), node_workspace("original", "")
        done = subprocess.run([tool, workspace, workspace, "--quiet", "--runs", "1", "--settle", "0.1", "--duration", "1",
                               "--command", "sleep 5"], env=environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stdout.decode(errors="replace"))


class Stopping(unittest.TestCase):
    def start(self, tool, *arguments, ignored=()):
        """Whatever this process ignores: a script's shell ignores SIGINT for what it starts with `&`."""
        def ignore():
            for which in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
                signal.signal(which, signal.SIG_IGN if which in ignored else signal.SIG_DFL)

        workspace = node_workspace("original", "")
        process = subprocess.Popen([tool, workspace, workspace, *arguments], env=environment(), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, preexec_fn=ignore)
        self.addCleanup(process.stderr.close)
        return process

    def wait_until_it_says(self, words, tool):
        for line in tool.stderr:
            if words in line:
                return
        self.fail(f"it ended before it said {words}")

    def interrupt(self, sig, command="sleep 1000 & rosrun topic_tools relay /in /out", duration="60", ignored=()):
        folder = os.path.join(SCRATCH, "stopped")
        shutil.rmtree(folder, ignore_errors=True)
        tool = self.start(COMPARE, "--keep", folder, "--duration", duration, "--command", command, ignored=ignored)
        self.wait_until_it_says(b"running", tool)
        self.assertGreaterEqual(len(processes_of(folder)), 4, "roscore, rosmaster, recorder, relay, sleep")
        tool.send_signal(sig)
        return tool, folder

    def test_ctrl_c_leaves_nothing_behind(self):
        for end in (signal.SIGINT, signal.SIGQUIT):
            tool, folder = self.interrupt(end)
            self.assertIn(b"stopping what was started", tool.stderr.read())
            self.assertEqual(tool.wait(60), 130)
            self.assertEqual(processes_of(folder), [], "all is gone when it ends")

    def test_a_hangup_that_is_ignored_stops_nothing(self):
        """As under nohup. The run goes on to its own end, at which nothing was published."""
        tool, folder = self.interrupt(signal.SIGHUP, duration="3", ignored=[signal.SIGHUP])
        said = tool.stderr.read()
        self.assertIn(b"published nothing", said)
        self.assertNotIn(b"stopping what was started", said)
        self.assertEqual(tool.wait(60), 2)
        self.assertEqual(processes_of(folder), [])

    def test_nodes_hear_the_signal_that_stops_them_where_the_tool_ignores_it(self):
        """They inherit what is ignored. One that ignores SIGINT runs on for twenty seconds."""
        tool, _ = self.interrupt(signal.SIGTERM, command="rosrun topic_tools relay /in /out & sleep 1000", ignored=[signal.SIGINT])
        begin = time.monotonic()
        tool.stderr.read()
        self.assertEqual(tool.wait(60), 130)
        self.assertLess(time.monotonic() - begin, 19)

    def test_ctrl_c_ends_the_comparison(self):
        tool = self.start(tool_with_stand_in("slow", slow_recording(), 0), "--runs", "1", "--settle", "0.1", "--duration", "1",
                          "--command", "sleep 5")
        self.wait_until_it_says(b"the port with the original", tool)
        tool.send_signal(signal.SIGINT)
        said = tool.stderr.read()
        self.assertEqual(tool.wait(60), 130, said)
        self.assertIn(b"tzc-compare: stopped", said)


if __name__ == "__main__":
    os.makedirs(SCRATCH, exist_ok=True)
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
