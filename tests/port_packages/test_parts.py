# SPDX-License-Identifier: BSD-3-Clause
"""The parts of scripts/port-packages that need no build."""
import json
import os
import signal
import subprocess
import sys
import tempfile
import textwrap
import time
import types
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts/lib"))
from port_packages.command import run  # noqa: E402
from port_packages.kept import Kept, digest_of  # noqa: E402
from port_packages.packages import find_packages, with_users  # noqa: E402
from port_packages.repository import Repository  # noqa: E402
from port_packages.sites import summary_of  # noqa: E402
from port_packages.table import table  # noqa: E402
from port_packages.workspace import Workspace, mirror, read_results  # noqa: E402

MANIFEST = ("<package format='2'><name>{}</name><version>1.0.0</version><description>d</description><license>BSD</license>"
            "<maintainer email='a@example.org'>a</maintainer><buildtool_depend>{}</buildtool_depend>{}</package>")


class Folder(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.path = self.temporary.name

    def put(self, name, text=""):
        path = os.path.join(self.path, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)
        return path

    def package(self, folder, needs="", tool="catkin"):
        self.put(f"{folder}/package.xml", MANIFEST.format(os.path.basename(folder), tool, needs))


class Inputs(unittest.TestCase):
    def test_each_repository_has_a_launch_file_and_arguments_that_name_it(self):
        folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "inputs")
        names = sorted(name[:-len(".args")] for name in os.listdir(folder) if name.endswith(".args"))
        self.assertGreaterEqual(len(names), 10)
        self.assertEqual(names, sorted(name[:-len(".launch")] for name in os.listdir(folder) if name.endswith(".launch")))
        for name in names:
            with open(os.path.join(folder, f"{name}.args")) as file:
                words = file.read().splitlines()
            self.assertEqual(words[:3], ["--launch", f"{{inputs}}/{name}.launch", "--bag"])
            self.assertIn(words[3], ("{inputs}/drive.bag", "{inputs}/stand.bag"))
            nodes = ElementTree.parse(os.path.join(folder, f"{name}.launch")).getroot().iter("node")
            self.assertTrue(all({"name", "pkg", "type"} <= set(node.keys()) for node in nodes), name)


class Comparing(Folder):
    def said_by(self, inputs):
        said = []

        class NotBuilt(Repository):
            say = staticmethod(said.append)

            def build_original(self):
                raise RuntimeError("not in this test")

        NotBuilt("wild", self.path, types.SimpleNamespace(out=self.path, inputs=inputs, key="", runtime="", tzc="/tzc")).run()
        return "\n".join(said)

    def test_a_source_without_arguments_is_told(self):
        self.put("inputs/other.args")
        inputs = os.path.join(self.path, "inputs")
        self.assertIn(f"{inputs} has no wild.args", self.said_by(inputs))
        self.put("inputs/wild.args")
        self.assertNotIn("wild.args", self.said_by(inputs))
        self.assertNotIn("wild.args", self.said_by(None))


class Results(Folder):
    """Of a source that could not be built, or whose result was saved by hand."""

    def repository(self, runtime="1"):
        settings = types.SimpleNamespace(out=self.path, inputs=None, key="", runtime=runtime, tzc="/tzc")
        return Repository("wild", os.path.join(self.path, "source"), settings)

    def save(self, **result):
        self.put("wild/result.json", json.dumps(result))

    def test_a_result_is_taken_again_for_what_it_depends_on(self):
        self.put("source/a.cpp", "1")
        depends = self.repository().depends
        self.save(problems=[], depends=depends, units=3)
        self.assertEqual(self.repository().saved()["units"], 3)
        self.assertIsNone(self.repository(runtime="2").saved())
        self.put("source/.git/index", "changes with each look at it")
        self.assertIsNotNone(self.repository().saved())
        self.put("source/a.cpp", "2")
        self.assertIsNone(self.repository().saved())

    def test_one_with_a_problem_is_not(self):
        self.put("source/a.cpp", "1")
        self.save(problems=["No space left on device"], depends=self.repository().depends)
        self.assertIsNone(self.repository().saved())


class StoppedTests(Folder):
    ALL, FIRST = {("a", "x"): True, ("a", "y"): True}, {("a", "x"): True}

    def problems_of(self, before, after):
        """Of two versions, as (results of their tests, whether these ended)."""
        settings = types.SimpleNamespace(out=self.path, inputs=None, key="", runtime="", tzc="/tzc", tests=True, timeout=2)
        repository = Repository("a", self.path, settings)
        repository.say = lambda text: None
        repository.original, repository.ported = (
            types.SimpleNamespace(make=lambda *_, **__: types.SimpleNamespace(timed_out=False),
                                  run_tests=lambda *_, ended=ended: ended, test_results=lambda results=results: results)
            for results, ended in (before, after))
        repository.test()
        return repository.result["problems"]

    def test_what_the_port_breaks_is_told_from_what_was_not_waited_for(self):
        self.assertEqual(self.problems_of((self.ALL, True), (self.ALL, True)), [])
        self.assertEqual(self.problems_of((self.ALL, True), (self.FIRST, True)), ["test passed before and not after: a y"])
        stopped = "the tests {} the port were stopped after 2 s: a longer --timeout lets them end"
        self.assertEqual(self.problems_of((self.ALL, True), (self.FIRST, False)), [stopped.format("after")])
        self.assertEqual(self.problems_of((self.FIRST, False), (self.FIRST, False)),
                         [stopped.format("before"), stopped.format("after")])
        self.assertEqual(self.problems_of((self.ALL, True), ({("a", "x"): False}, False)),
                         [stopped.format("after"), "test passed before and not after: a x"])


class KeptSteps(Folder):
    def test_what_a_step_found_is_kept_for_what_it_depends_on(self):
        kept = os.path.join(self.path, "kept.json")
        self.assertIsNone(Kept(kept, ["a"]).read())
        Kept(kept, ["a"]).write({"seconds": 2})
        self.assertEqual(Kept(kept, ["a"]).read(), {"seconds": 2})
        self.assertIsNone(Kept(kept, ["b"]).read())
        self.put("kept.json", "{")
        self.assertIsNone(Kept(kept, ["a"]).read())

    def test_the_diff_of_an_interrupted_rewriting_is_never_taken_for_a_kept_one(self):
        begun = []

        class Rewritten(Repository):
            def rewrite(self, diff):
                begun.append(self.settings.key)
                with open(diff, "w") as file:
                    file.write(self.settings.key)
                if self.settings.key == "interrupted":
                    raise SystemExit(143)
                return {"problems": []}

            def apply(self, diff):
                with open(diff) as file:
                    self.applied = file.read()

        def port(key):
            os.makedirs(os.path.join(self.path, "a/original/src"), exist_ok=True)
            self.put("a/original/build/compile_commands.json", "[]")
            repository = Rewritten("a", "/a", types.SimpleNamespace(out=self.path, key=key, again=False, tzc="/tzc"))
            repository.port()
            return repository.applied

        self.assertEqual([port("first"), port("first")], ["first", "first"])
        self.assertEqual(begun, ["first"])
        self.assertRaises(SystemExit, port, "interrupted")
        self.assertEqual(port("first"), "first")
        self.assertEqual(begun, ["first", "interrupted", "first"])

    def test_the_digest_tells_names_contents_and_links_apart(self):
        def digest():
            return digest_of(os.path.join(self.path, "tree"), os.path.join(self.path, "file"))

        self.put("tree/a/x", "1")
        self.put("file", "1")
        seen = {digest()}
        self.assertEqual({digest()}, seen)
        for change in (lambda: self.put("tree/a/x", "2"), lambda: os.rename(f"{self.path}/tree/a", f"{self.path}/tree/b"),
                       lambda: os.symlink("x", f"{self.path}/tree/b/y"), lambda: self.put("file", "2")):
            change()
            self.assertNotIn(digest(), seen)
            seen.add(digest())


class Packages(Folder):
    def test_they_are_found_at_any_depth_and_not_inside_others(self):
        for folder in ("a", "deep/b", "a/test/inner", ".hidden/c", "ignored/d"):
            self.package(folder)
        self.put("ignored/CATKIN_IGNORE")
        packages, refused = find_packages(self.path)
        self.assertEqual([package.folder for package in packages], ["a", "deep/b"])
        self.assertEqual(refused, {})

    def test_those_of_ros_2_and_broken_manifests_are_named(self):
        self.package("two", tool="ament_cmake")
        self.put("broken/package.xml", "<package>")
        packages, refused = find_packages(self.path)
        self.assertEqual(packages, [])
        self.assertEqual(refused["two"], "is no catkin package")
        self.assertIn("package.xml", refused["broken"])

    def test_conditions_are_those_of_ros_1(self):
        self.put("both/package.xml", """<package format="3">
  <name>both</name><version>1.0.0</version><description>d</description><license>BSD</license>
  <maintainer email="a@example.org">a</maintainer>
  <buildtool_depend condition="$ROS_VERSION == 1">catkin</buildtool_depend>
  <buildtool_depend condition="$ROS_VERSION == 2">ament_cmake</buildtool_depend>
  <depend condition="$ROS_VERSION == 1">roscpp</depend>
  <depend condition="$ROS_VERSION == 2">rclcpp</depend>
  <export><build_type condition="$ROS_VERSION == 2">ament_cmake</build_type></export>
</package>""")
        packages, refused = find_packages(self.path)
        self.assertEqual(refused, {})
        self.assertEqual([package.needs for package in packages], [{"catkin", "roscpp"}])

    def test_only_some(self):
        self.package("image_a")
        self.package("cloud_a")
        self.assertEqual([package.name for package in find_packages(self.path, ["image_*"])[0]], ["image_a"])

    def test_users_of_users_are_left_out_too_and_those_of_tests_are_not(self):
        self.package("a")
        self.package("b", "<depend>a</depend>")
        self.package("c", "<build_depend>b</build_depend>")
        self.package("d", "<test_depend>a</test_depend><exec_depend>a</exec_depend>")
        self.assertEqual(with_users({"a"}, find_packages(self.path)[0]), {"a", "b", "c"})


class WorkspaceOf(Folder):
    def setUp(self):
        super().setUp()
        self.workspace = Workspace(os.path.join(self.path, "ws"), types.SimpleNamespace(tzc="/tzc"))

    def culprit(self, output, *folders):
        for folder in folders:
            self.package(folder)
        packages = find_packages(self.path)[0]
        return self.workspace.culprit(packages, {}, self.put("log", output))

    def test_the_first_error_names_the_package(self):
        output = ("-- fine at one/CMakeLists.txt:1\nCMake Error at deep/two/CMakeLists.txt:20 (find_package):\n  Could not\n\n"
                  "CMake Error at one/CMakeLists.txt:2\n")
        self.assertEqual(self.culprit(output, "one", "deep/two"), "two")

    def test_an_error_in_a_module_names_it_in_the_calls(self):
        output = ("CMake Error at /usr/share/cmake/Modules/Find.cmake:230 (message):\n  Could NOT find Bullet\n"
                  "Call Stack (most recent call first):\n  one/cmake/own.cmake:3 (find_package)\n  one/CMakeLists.txt:9 (x)\n")
        self.assertEqual(self.culprit(output, "one", "one_more"), "one")

    def test_an_error_of_no_package(self):
        self.assertIsNone(self.culprit("CMake Error at /usr/share/catkin/all.cmake:1:\n  no\n", "one"))
        self.assertIsNone(self.culprit("killed\n", "one"))

    def test_a_mirror_keeps_the_times_of_what_is_equal(self):
        self.put("from/a/same.h", "x")
        self.put("from/a/changed.h", "x")
        self.put("to/a/same.h", "x")
        self.put("to/a/changed.h", "y")
        self.put("to/a/gone/old.h", "y")
        os.utime(os.path.join(self.path, "to/a/same.h"), (1, 1))
        mirror(os.path.join(self.path, "from"), os.path.join(self.path, "to"))
        self.assertEqual(os.stat(os.path.join(self.path, "to/a/same.h")).st_mtime, 1)
        with open(os.path.join(self.path, "to/a/changed.h")) as file:
            self.assertEqual(file.read(), "x")
        self.assertEqual(sorted(os.listdir(os.path.join(self.path, "to/a"))), ["changed.h", "same.h"])

    def test_what_was_built_whatever_the_folder_is_called(self):
        workspace = Workspace(os.path.join(self.path, "python-ports", "ws"), types.SimpleNamespace(tzc="/tzc"))
        for name in ("pkg/node", "libpkg.so", "python3/dist-packages/pkg/msg.py"):
            self.put(f"python-ports/ws/devel/lib/{name}")
        self.assertEqual(workspace.artefacts(), {"pkg/node", "libpkg.so"})

    def test_results_of_tests(self):
        path = self.put("r.xml", "<testsuites><testsuite><testcase classname='a' name='x'/><testcase classname='a' name='y'>"
                        "<failure/></testcase></testsuite></testsuites>")
        self.assertEqual(read_results(path), {("a", "x"): True, ("a", "y"): False})
        self.assertEqual(list(read_results(self.put("s.xml", "<testsuite>")).values()), [False])


class Commands(Folder):
    def assert_ends(self, pid):
        """Soon; until its new parent has looked it may be a zombie."""
        for _ in range(200):
            try:
                with open(f"/proc/{pid}/stat") as file:
                    if file.read().rpartition(")")[2].split()[0] == "Z":
                        return
            except FileNotFoundError:
                return
            time.sleep(0.1)
        self.fail(f"process {pid} still runs")

    def test_one_that_hangs_is_stopped_with_its_children(self):
        log = os.path.join(self.path, "log/hang.log")
        outcome = run(["sh", "-c", "echo begun; sleep 100 & wait"], log, timeout=0.5)
        self.assertTrue(outcome.timed_out)
        self.assertLess(outcome.wall, 20)
        with open(log) as file:
            self.assertEqual(file.read(), "begun\n")

    def start(self, log, ignored=()):
        """A program that runs a command, and the number of what that has started."""
        def ignore():  # and nothing else, whatever this process ignores
            for which in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
                signal.signal(which, signal.SIG_IGN if which in ignored else signal.SIG_DFL)

        program = ("import sys; from port_packages.command import ended_by_signals, run; ended_by_signals();"
                   "run(['sh', '-c', 'sleep 100 & echo $!; wait'], sys.argv[1])")
        tool = subprocess.Popen([sys.executable, "-c", program, log], env=dict(os.environ, PYTHONPATH=sys.path[0]),
                                preexec_fn=ignore)
        text = ""
        while not text.endswith("\n") and tool.poll() is None:
            time.sleep(0.05)
            if os.path.exists(log):
                with open(log) as file:
                    text = file.read()
        return tool, int(text)

    def test_a_signal_ends_what_was_started(self):
        log = os.path.join(self.path, "signal.log")
        for which in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            tool, started = self.start(log)
            tool.send_signal(which)
            self.assertEqual(tool.wait(60), 128 + which)
            with self.subTest(which):
                self.assert_ends(started)
            os.remove(log)

    def test_a_signal_that_is_ignored_ends_nothing(self):
        """As under nohup."""
        tool, started = self.start(os.path.join(self.path, "signal.log"), ignored=[signal.SIGHUP])
        tool.send_signal(signal.SIGHUP)
        tool.send_signal(signal.SIGTERM)
        self.assertEqual(tool.wait(60), 128 + signal.SIGTERM)
        self.assert_ends(started)

    def test_a_signal_waits_until_what_is_started_is_known(self):
        """The command sends it while its start is not yet over for this program."""
        program = textwrap.dedent("""\
            import os, signal, subprocess, sys
            from port_packages.command import ended_by_signals, run
            ended_by_signals()

            class Interrupted(subprocess.Popen):
                def __init__(self, *arguments, **options):
                    super().__init__(*arguments, **options)
                    print(self.pid, flush=True)
                    os.kill(os.getpid(), signal.SIGTERM)

            subprocess.Popen = Interrupted
            run(["sleep", "100"], sys.argv[1])
            """)
        tool = subprocess.run([sys.executable, "-c", program, os.path.join(self.path, "log")], stdout=subprocess.PIPE, text=True,
                              env=dict(os.environ, PYTHONPATH=sys.path[0]), check=False)
        self.assertEqual(tool.returncode, 128 + signal.SIGTERM)
        self.assert_ends(int(tool.stdout))

    def test_its_status_is_kept(self):
        outcome = run(["sh", "-c", "exit 3"], os.path.join(self.path, "log"))
        self.assertEqual((outcome.status, outcome.timed_out), (3, False))


class Table(Folder):
    REPORT = {"package": "p", "summary": {"lines_added": 5, "lines_removed": 2}, "sites": [
        {"kind": "publish", "message_type": "sensor_msgs/Image", "level": "zero_copy", "file": "a", "line": 1, "code": "",
         "reason": ""},
        {"kind": "publish", "message_type": "sensor_msgs/Image", "level": "plain", "file": "b.cpp", "line": 7, "code": "TZC1017",
         "reason": "why"},
        {"kind": "subscribe", "message_type": "sensor_msgs/Image", "level": "shared", "file": "a", "line": 3, "code": "",
         "reason": ""}]}

    def test_sites_of_one_package_and_of_several(self):
        for report in (self.REPORT, {"packages": [self.REPORT]}):
            summary = summary_of(self.put("r.json", json.dumps(report)))
            self.assertEqual(summary["counts"]["large zero_copy"], 1)
            self.assertEqual(summary["median_lines"], 7)
            self.assertEqual(summary["large_left"], ["p/b.cpp:7 sensor_msgs/Image plain TZC1017 why"])

    def test_a_source_that_failed_has_a_line_and_its_reason(self):
        text = table([{"name": "bad", "problems": ["build original: no package could be configured"]}])
        self.assertIn("bad: build original: no package could be configured", text)

    def test_levels_stand_in_their_columns(self):
        summary = summary_of(self.put("r.json", json.dumps(self.REPORT)))
        text = table([{"name": "good", "problems": [], "packages": ["p"], "sites": summary, "compiled": 3, "compiled_after": 3,
                       "rewrite_seconds": 10, "own_seconds": 6, "syntax_seconds": 5, "megabytes": [100, 300]}])
        self.assertRegex(text, r"good +1 +3, 3 +1/0/1/0 +1/0/0/0 +1/0/1 +7 +- +- +6\+4 +1.20 +100, 300 +0\n")
        self.assertIn("large publish sites: 2; zero_copy 50 %, one_copy 0, plain 1", text)


if __name__ == "__main__":
    unittest.main()
