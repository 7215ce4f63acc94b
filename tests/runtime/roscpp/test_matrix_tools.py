# SPDX-License-Identifier: BSD-3-Clause
"""Ported nodes among rospy nodes, command-line tools, bags and unmodified programs."""
import glob
import os
import re
import signal
import time

from topic_case import TZC_RUN, Listener, TopicCase, main

ROSPY_NODE = [os.path.join("/usr/bin", "python3"), os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                                                "nodes", "rospy_node.py")]


class ToolCase(TopicCase):
    def tool(self, command, topic="image", name=None):
        """A command that subscribes to a topic; the master knows it."""
        before = len(self.ros.subscribers(self.name(topic)))
        process = self.ros.start(command, name=name or command[0])
        self.ros.wait_until(lambda: len(self.ros.subscribers(self.name(topic))) > before, 20, " ".join(command))
        return process

    def rospy(self, **parameters):
        return ROSPY_NODE + [f"__ns:={self.ns}"] + [f"_{key}:={value}" for key, value in parameters.items()]

    def image_saver(self):
        """The binary of image_view that needs no display, unmodified; it writes a picture of each image."""
        pictures = os.path.join(self.scratch, f"{self.ns[1:]}_%04d.pgm")
        return self.tool(TZC_RUN + ["/usr/lib/image_view/image_saver", f"image:={self.name('image')}", "_encoding:=mono8",
                                    f"_filename_format:={pictures}"], name="image_saver")

    def pictures(self):
        return sorted(glob.glob(os.path.join(self.scratch, f"{self.ns[1:]}_*.pgm")))

    def numbers_in_pictures(self):
        """The images' numbers, modulo 256, after a look at every pixel."""
        numbers = []
        for path in self.pictures():
            with open(path, "rb") as picture:
                pixels = picture.read().split(b"255\n", 1)[1]
            numbers.append((pixels[0] * pow(7, -1, 256)) % 256)  # the pattern's first byte is 7 n
            expected = bytes((i * 31 + i // 256 + numbers[-1] * 7) & 0xff for i in range(len(pixels)))
            self.assertEqual(pixels, expected, path)
        return numbers

    def record(self, bag):
        return self.tool(["rosbag", "record", "-O", bag, self.name("image")])

    def end_recording(self, recorder, bag):
        """rosbag's Python front may end before its recorder has given the finished bag its name."""
        recorder.popen.send_signal(signal.SIGINT)
        recorder.wait(20)
        self.ros.wait_until(lambda: os.path.exists(bag), 20, bag)

    def assert_bag(self, bag, numbers):
        """These messages, in order, with the right bytes."""
        status, output = self.ros.run(["/usr/bin/python3", "-c", (
            "import rosbag, sys\n"
            "for _, m, _ in rosbag.Bag(sys.argv[1]).read_messages():\n"
            "    right = bytes((i * 31 + i // 256 + int(m.header.frame_id) * 7) & 0xff for i in range(m.width))\n"
            "    print(m.header.frame_id, m.data == right)"), bag], timeout=120)
        self.assertEqual(status, 0, output)
        self.assertEqual(output.splitlines(), [f"{number} True" for number in numbers])


class PortedToTools(ToolCase):
    def test_rospy(self):
        rospy, shared = Listener(self.tool(self.rospy())), self.listen()
        self.talk(count=50, bytes=5000, subscribers=2, queue=200)
        self.assert_got(rospy, range(50))
        self.assert_seq_as_tcpros(rospy)
        self.assert_got(shared, range(50), shared=True)

    def test_rostopic_echo_hz_bw(self):
        talker = self.start_talker(count=150, rate=50, bytes=20000, subscribers=3, queue=200)  # echo asks for the topic's type
        echo = self.tool(["rostopic", "echo", "--noarr", self.name("image")])
        hz = self.tool(["rostopic", "hz", self.name("image")])
        bandwidth = self.tool(["rostopic", "bw", self.name("image")])
        self.assertEqual(talker.wait(40), 0, talker.tail())
        self.ros.wait_until(lambda: 'frame_id: "149"' in echo.log(), 10, "the last message")
        self.assertEqual(re.findall(r'frame_id: "(\d+)"', echo.log()), [str(i) for i in range(150)])
        self.assertEqual(re.findall(r"seq: (\d+)", echo.log()), [str(i) for i in range(150)])
        rates = [float(rate) for rate in re.findall(r"average rate: ([\d.]+)", hz.log())]
        self.assertTrue(rates and 35 < rates[-1] < 65, hz.log())
        self.assertIn("mean: 20.0", bandwidth.log())

    def test_rosbag_record(self):
        bag = os.path.join(self.scratch, f"record{self.ns[1:]}.bag")
        recorder, shared = self.record(bag), self.listen()
        self.talk(count=100, rate=50, subscribers=2, queue=200)
        self.end_recording(recorder, bag)
        self.assert_bag(bag, range(100))
        self.assert_got(shared, range(100), shared=True)

    def test_topic_tools_relay_and_throttle(self):
        relay = self.tool(["/usr/lib/topic_tools/relay", "image", "relayed", f"__ns:={self.ns}"])
        throttle = self.tool(["/usr/lib/topic_tools/throttle", "messages", "image", "10", "throttled",
                              f"__ns:={self.ns}"])
        shared = self.listen()
        behind_relay = self.listen(topics="relayed", topic="relayed")
        behind_throttle = self.listen(topics="throttled", topic="throttled")
        self.talk(count=150, rate=50, subscribers=3, settle=1.5, queue=200)
        self.assert_got(shared, range(150), shared=True)
        numbers = behind_relay.numbers()  # topic_tools advertise with the first message, and lose what comes at first
        self.assertGreater(len(numbers), 50)
        self.assertEqual(numbers, list(range(numbers[0], 150)))
        slower = behind_throttle.numbers()
        self.assertEqual(slower, sorted(set(slower)))
        self.assertTrue(10 < len(slower) < 60, slower)
        self.assertTrue(all(m["right"] for m in behind_relay.messages() + behind_throttle.messages()))
        self.assertTrue(relay.alive() and throttle.alive())

    def test_image_saver_under_tzc_run(self):
        """An unmodified binary of image_view, without a display: reads shared memory, writes right pictures."""
        saver = self.image_saver()
        talker = self.start_talker(count=0, rate=20, bytes=30000)
        self.ros.wait_until(lambda: len(self.pictures()) >= 20, 20, "20 pictures")
        self.assertEqual(self.shared_transports(self.name("talker")), [self.name("image")])
        talker.stop()
        self.ros.wait_until(lambda: time.sleep(0.5) is None, 5, "the last picture")
        numbers = self.numbers_in_pictures()
        self.assertEqual(numbers, [i % 256 for i in range(len(numbers))])
        self.assertTrue(saver.alive())


class ToolsToPorted(ToolCase):
    def test_rospy(self):
        listener = self.listen()
        talker = self.ros.start(self.rospy(count=50), name="rospy_talker")
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(listener, range(50), shared=False)

    def test_record_then_play(self):
        bag = os.path.join(self.scratch, f"play{self.ns[1:]}.bag")
        recorder = self.record(bag)
        self.talk("stock", count=60, rate=60)
        self.end_recording(recorder, bag)
        listener, plain = self.listen(), self.listen("plain")
        status, output = self.ros.run(["rosbag", "play", "-q", "-d", "1", bag], timeout=60)
        self.assertEqual(status, 0, output)
        self.assert_got(listener, range(60), shared=False)
        self.assert_got(plain, range(60), shared=False)


class Together(ToolCase):
    def test_all_at_once(self):
        bag = os.path.join(self.scratch, f"all{self.ns[1:]}.bag")
        talker = self.start_talker(count=100, rate=50, bytes=5000, subscribers=13, settle=1.5, queue=200)
        recorder = self.record(bag)
        echo = self.tool(["rostopic", "echo", "--noarr", self.name("image")])
        hz = self.tool(["rostopic", "hz", self.name("image")])
        bandwidth = self.tool(["rostopic", "bw", self.name("image")])
        saver = self.image_saver()
        self.tool(["/usr/lib/topic_tools/relay", "image", "relayed", f"__ns:={self.ns}"])
        self.tool(["/usr/lib/topic_tools/throttle", "messages", "image", "10", "throttled", f"__ns:={self.ns}"])
        behind_relay = self.listen("plain", remaps=["image:=relayed"], topic="relayed", queue=200)
        behind_throttle = self.listen("plain", remaps=["image:=throttled"], topic="throttled")
        rospy = Listener(self.tool(self.rospy()))
        plain = self.listen("plain")
        preloaded = self.listen("plain", runner=TZC_RUN)
        listeners = {mode: self.listen(mode) for mode in ("pointer", "value", "direct")}
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.end_recording(recorder, bag)
        self.assert_bag(bag, range(100))
        self.assertEqual(re.findall(r'frame_id: "(\d+)"', echo.log()), [str(i) for i in range(100)])
        self.assertIn("average rate", hz.log())
        self.assertIn("mean: 5.", bandwidth.log())
        pictures = self.numbers_in_pictures()  # its queue holds one image
        self.assertTrue(pictures and saver.alive())
        self.assertEqual(pictures, sorted(set(pictures)))
        self.assert_got(rospy, range(100))
        self.assert_got(plain, range(100), shared=False)
        self.assert_got(preloaded, range(100), shared=True)
        for mode, listener in listeners.items():
            self.assert_got(listener, range(100), shared=None if mode == "value" else True)
            self.assert_seq_as_tcpros(listener)
        numbers = behind_relay.numbers()
        self.assertEqual(numbers, list(range(numbers[0], 100)))
        slower = behind_throttle.numbers()
        self.assertTrue(slower and slower == sorted(set(slower)), slower)
        self.assertTrue(all(m["right"] for m in behind_relay.messages() + behind_throttle.messages()))
        self.assertIn('"copied_bytes": 0', talker.log())


if __name__ == "__main__":
    main()
