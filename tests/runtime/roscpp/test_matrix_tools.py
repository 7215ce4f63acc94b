# SPDX-License-Identifier: BSD-3-Clause
"""Ported nodes among rospy nodes, command-line tools, bags and unmodified programs."""
import glob
import json
import os
import re
import signal
import sys
import time

from topic_case import TZC_RUN, Listener, TopicCase, main

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))
from virtual_screen import VirtualScreen  # noqa: E402

ROSPY_NODE = [os.path.join("/usr/bin", "python3"), os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                                                "nodes", "rospy_node.py")]


IMAGE_MD5SUM = "060021388200f6f0f447d0fcd9c64743"
READ_BAG = """
import json, rosbag, sys
for topic, m, _ in rosbag.Bag(sys.argv[1]).read_messages():
    print(json.dumps([topic, m._md5sum, m.header.seq, m.header.stamp.to_nsec(), m.header.frame_id, m.height, m.width,
                      m.encoding, m.is_bigendian, m.step, m.data.hex()]))
"""


def pattern(size, number):
    """The bytes of a talker's image."""
    return bytes((i * 31 + i // 256 + number * 7) & 0xff for i in range(size))


class ToolCase(TopicCase):
    def tool(self, command, topic="image", name=None, env=None):
        """A command that subscribes to a topic; the master knows it."""
        before = len(self.ros.subscribers(self.name(topic)))
        process = self.ros.start(command, name=name or command[0], env=env)
        self.ros.wait_until(lambda: len(self.ros.subscribers(self.name(topic))) > before, 20, " ".join(command))
        return process

    def rospy(self, **parameters):
        return ROSPY_NODE + [f"__ns:={self.ns}"] + [f"_{key}:={value}" for key, value in parameters.items()]

    def image_saver(self):
        """The binary of image_view that needs no display, unmodified; it writes a picture of each image."""
        pictures = os.path.join(self.scratch, f"{self.ns[1:]}_%04d.pgm")
        return self.tool(TZC_RUN + ["/usr/lib/image_view/image_saver", f"image:={self.name('image')}",
                                    "_encoding:=mono8", f"_filename_format:={pictures}"], name="image_saver")

    def pictures(self):
        return sorted(glob.glob(os.path.join(self.scratch, f"{self.ns[1:]}_*.pgm")))

    def numbers_in_pictures(self):
        """The images' numbers, modulo 256, after a look at every pixel."""
        numbers = []
        for path in self.pictures():
            with open(path, "rb") as picture:
                pixels = picture.read().split(b"255\n", 1)[1]
            numbers.append((pixels[0] * pow(7, -1, 256)) % 256)  # the pattern's first byte is 7 n
            self.assertEqual(pixels, pattern(len(pixels), numbers[-1]), path)
        return numbers

    def record(self, bag):
        return self.tool(["rosbag", "record", "-O", bag, self.name("image")])

    def end_recording(self, recorder, bag):
        """rosbag's Python front may end before its recorder has given the finished bag its name."""
        recorder.popen.send_signal(signal.SIGINT)
        recorder.wait(20)
        self.ros.wait_until(lambda: os.path.exists(bag), 20, bag)

    def assert_bag(self, bag, numbers, rows, line):
        """These messages, in order, every field of them and no other one."""
        status, output = self.ros.run(["/usr/bin/python3", "-c", READ_BAG, bag], timeout=120)
        self.assertEqual(status, 0, output)
        lines = [json.loads(text) for text in output.splitlines()]
        self.assertEqual([fields[4] for fields in lines], [str(number) for number in numbers])
        for index, (topic, md5sum, seq, stamp, frame, *image) in enumerate(lines):
            self.assertEqual((topic, md5sum, seq), (self.name("image"), IMAGE_MD5SUM, index))
            self.assertEqual(image, [rows, line, "mono8", 0, line, pattern(rows * line, int(frame)).hex()])
            self.assertTrue(index == 0 or stamp > lines[index - 1][3], "stamps")

    def assert_echo(self, echo, numbers, rows, line):
        """What `rostopic echo` printed: these messages, in order, every field of them, each byte."""
        self.ros.wait_until(lambda: echo.log().count("---\n") >= len(numbers), 20, "the last message")
        images = [dict(re.findall(r"^ *(\w+): (.+)$", text, re.M)) for text in echo.log().split("---\n")[:-1]]
        self.assertEqual([image["frame_id"] for image in images], [f'"{number}"' for number in numbers])
        for index, (image, number) in enumerate(zip(images, numbers)):
            data = bytes(int(byte) for byte in image["data"].strip("[]").split(","))
            self.assertEqual(data, pattern(rows * line, number))
            self.assertEqual([image[field] for field in ("seq", "height", "width", "encoding", "is_bigendian", "step")],
                             [str(index), str(rows), str(line), '"mono8"', "0", str(line)])
        stamps = [int(image["secs"]) + int(image["nsecs"]) * 1e-9 for image in images]
        self.assertEqual(stamps, sorted(set(stamps)))
        return stamps

    def assert_hz(self, hz, stamps):
        """It has counted every message, and its rate is theirs as far as a machine that stands still now and then lets it see."""
        self.ros.wait_until(lambda: f"window: {len(stamps)}\n" in hz.log(), 20, "hz to count them all")
        rate, least, most, window = [float(figure) for figure in re.findall(
            r"average rate: (\S+)\n\tmin: (\S+)s max: (\S+)s .* window: (\d+)", hz.log())[-1]]
        self.assertEqual(window, len(stamps))
        published = (len(stamps) - 1) / (stamps[-1] - stamps[0])
        self.assertTrue(0.5 * published < rate < 2 * published, f"{rate}, not {published}")
        self.assertTrue(least <= 1 / rate <= most)

    def assert_bw(self, bandwidth, stamps, size):
        """It has counted every message, each as long as it is on the wire; its bandwidth is theirs, over a time that ended
        after the last message and before now."""
        wire = size + 42 + 3  # header, other fields, three digits of a number
        figures = f"mean: {wire / 1000:.2f}KB min: {wire / 1000:.2f}KB max: {wire / 1000:.2f}KB window: {len(stamps)}\n"
        self.ros.wait_until(lambda: figures in bandwidth.log(), 20, f"bw to say {figures}")
        average = float(re.findall(r"average: (\S+)KB/s\n\t" + figures, bandwidth.log())[0])
        kilobytes = len(stamps) * wire / 1000
        least, most = kilobytes / (time.time() - stamps[0]), kilobytes / (stamps[-1] - stamps[0])
        self.assertTrue(0.99 * least < average < 2 * most, f"{least}, {most}: {bandwidth.log()}")

    def relay_and_throttle(self):
        """Both, and a listener behind each. topic_tools advertise when the first message comes, which is lost: a talker
        of its own publishes it."""
        named = [f"__ns:={self.ns}"]
        tools = {"relayed": self.tool(["/usr/lib/topic_tools/relay", "image", "relayed", "__name:=relay"] + named),
                 "throttled": self.tool(["/usr/lib/topic_tools/throttle", "messages", "image", "10", "throttled",
                                         "__name:=throttle"] + named)}
        listeners = [self.listen(topics=topic, topic=topic, queue=200) for topic in tools]
        opener = self.start_talker("plain", name="opener", first=999999, count=1, subscribers=2, linger=0)
        self.assertEqual(opener.wait(30), 0, opener.tail())
        for node, topic in (("relay", "relayed"), ("throttle", "throttled")):
            self.ros.wait_until(lambda: self.transports(self.name(node), topic) == {"TCPROS"}, 20, f"{node}'s listener")
        return listeners + list(tools.values())

    def assert_throttled(self, listener, among, seconds):
        """At most ten a second, in order; and not much less."""
        numbers = listener.numbers()
        self.assertEqual(numbers, sorted(set(numbers)))
        self.assertTrue(set(numbers) <= set(among), numbers)
        self.assertTrue(5 * seconds < len(numbers) <= 10 * seconds + 2, f"{len(numbers)} in {seconds} s")
        self.assertTrue(all(m["right"] for m in listener.messages()))

    def window(self, runner, screen):
        """image_view's window, on a screen of its own, as large as the picture; it republishes what it shows."""
        return self.tool(list(runner) + ["/usr/lib/image_view/image_view", "image:=image", "_autosize:=true",
                                         f"__ns:={self.ns}", "__name:=window"], name="image_view", env=screen.env)

    def screen(self):
        screen = VirtualScreen(self.scratch)
        self.addCleanup(screen.__exit__)
        return screen.__enter__()

    def assert_shows(self, screen, rows):
        self.ros.wait_until(lambda: screen.shows(rows), 20, "the last image on the screen")


class PortedToTools(ToolCase):
    def test_rospy(self):
        rospy, shared = Listener(self.tool(self.rospy())), self.listen()
        self.talk(count=50, bytes=5000, subscribers=2, shared=1)
        self.assert_got(rospy, range(50))
        self.assert_seq_as_tcpros(rospy)
        self.assert_got(shared, range(50), shared=True)

    def test_rostopic_echo_hz_bw(self):
        shared = self.listen()
        talker = self.start_talker(first=100, count=150, rate=30, bytes=5000, subscribers=4, shared=1)
        echo = self.tool(["rostopic", "echo", self.name("image")])  # asks for the topic's type
        hz = self.tool(["rostopic", "hz", self.name("image")])
        bandwidth = self.tool(["rostopic", "bw", "-w", "1000", self.name("image")])
        self.assertEqual(talker.wait(40), 0, talker.tail())
        stamps = self.assert_echo(echo, range(100, 250), 1, 5000)
        self.assert_hz(hz, stamps)
        self.assert_bw(bandwidth, stamps, 5000)
        self.assert_got(shared, range(100, 250), shared=True)

    def test_rosbag_record(self):
        bag = os.path.join(self.scratch, f"record{self.ns[1:]}.bag")
        recorder, shared = self.record(bag), self.listen()
        self.talk(count=100, rate=50, bytes=20000, subscribers=2, shared=1)
        self.end_recording(recorder, bag)
        self.assert_bag(bag, range(100), 1, 20000)
        self.assert_got(shared, range(100), shared=True)

    def test_topic_tools_relay_and_throttle(self):
        behind_relay, behind_throttle, relay, throttle = self.relay_and_throttle()
        shared = self.listen()
        self.talk(count=150, rate=50, subscribers=3, shared=1)
        self.assert_got(shared, range(150), shared=True)
        self.assert_got(behind_relay, range(150), shared=False)
        self.assert_throttled(behind_throttle, range(150), 3)
        self.assertTrue(relay.alive() and throttle.alive())

    def test_image_view(self):
        """The binary with the window, unmodified, plain and under tzc-run. It takes one image after the other,
        republishes each of them, and the last one stays on the screen, pixel by pixel."""
        rows, line = 100, 3 * 1600  # wider than the window's tool bar: the window does not scale it
        for runner in ([], TZC_RUN):
            with self.subTest(runner=runner):
                screen = self.screen()
                window = self.window(runner, screen)
                shown = self.listen(topics="window/output", topic="window/output")
                transport = "TZC" if runner else "TCPROS"
                self.ros.wait_until(lambda: self.transports(self.name("window"), "window/output") == {transport}, 20,
                                    "the window's listener")
                counters = self.talk(count=30, rows=rows, bytes=rows * line, encoding="bgr8", echo="window/output",
                                     shared=len(runner))
                self.assertEqual((counters["shared"], counters["copied_bytes"]), (30 * len(runner), 0))
                self.assert_got(shown, range(30))
                self.assert_seq_as_tcpros(shown)
                image = pattern(rows * line, 29)
                self.assert_shows(screen, [image[i:i + line] for i in range(0, len(image), line)])
                self.assertTrue(window.alive())
                self.ros.stop_since(self.before)

    def test_image_saver_under_tzc_run(self):
        """An unmodified binary of image_view, without a display: reads shared memory, writes right pictures."""
        saver = self.image_saver()
        talker = self.start_talker(count=0, rate=20, bytes=30000)
        self.ros.wait_until(lambda: len(self.pictures()) >= 20, 20, "20 pictures")
        self.assertEqual(self.shared_transports(self.name("talker")), [self.name("image")])
        end = self.finish(talker)["last"] + 1
        self.ros.wait_until(lambda: sum(os.path.getsize(path) > 30000 for path in self.pictures()) >= end, 20,
                            "the last picture")
        self.assertEqual(self.numbers_in_pictures(), [i % 256 for i in range(end)])
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
        self.talk("stock", count=60, rate=60, shared=0)
        self.end_recording(recorder, bag)
        self.assert_bag(bag, range(60), 1, 100000)
        listener, plain = self.listen(), self.listen("plain")
        status, output = self.ros.run(["rosbag", "play", "-q", "-d", "1", bag], timeout=60)
        self.assertEqual(status, 0, output)
        self.assert_got(listener, range(60), shared=False)
        self.assert_got(plain, range(60), shared=False)


class Together(ToolCase):
    def test_all_at_once(self):
        rows, line = 10, 1600
        size = rows * line
        bag = os.path.join(self.scratch, f"all{self.ns[1:]}.bag")
        behind_relay, behind_throttle, *_ = self.relay_and_throttle()
        screen = self.screen()
        on_shared_memory = ("pointer", "value", "direct", "preloaded", "saver", "window")
        talker = self.start_talker(first=100, count=150, rate=30, bytes=size, rows=rows, subscribers=14,
                                   shared=len(on_shared_memory))
        recorder = self.record(bag)
        echo = self.tool(["rostopic", "echo", self.name("image")])
        hz = self.tool(["rostopic", "hz", self.name("image")])
        bandwidth = self.tool(["rostopic", "bw", "-w", "1000", self.name("image")])
        saver, window = self.image_saver(), self.window(TZC_RUN, screen)
        rospy = Listener(self.tool(self.rospy()))
        plain = self.listen("plain", queue=200)
        preloaded = self.listen("plain", runner=TZC_RUN, queue=200)
        listeners = {mode: self.listen(mode, queue=200) for mode in ("pointer", "value", "direct")}
        self.assertEqual(talker.wait(90), 0, talker.tail())
        counters = self.counters(talker)
        self.end_recording(recorder, bag)
        numbers = range(100, 250)
        self.assert_bag(bag, numbers, rows, line)
        stamps = self.assert_echo(echo, numbers, rows, line)
        self.assert_hz(hz, stamps)
        self.assert_bw(bandwidth, stamps, size)
        self.assert_got(rospy, numbers)
        self.assert_got(plain, numbers, shared=False)
        self.assert_got(preloaded, numbers, shared=True)
        for mode, listener in listeners.items():
            self.assert_got(listener, numbers, shared=None if mode == "value" else True)
            self.assert_seq_as_tcpros(listener)
        self.assert_got(behind_relay, numbers, shared=False)
        self.assert_throttled(behind_throttle, numbers, stamps[-1] - stamps[0])
        self.assertEqual((counters["shared"], counters["copied_bytes"]), (len(on_shared_memory) * len(numbers), 0))
        pictures = self.numbers_in_pictures()  # its queue holds one image
        self.assertTrue(pictures and pictures == sorted(set(pictures)), pictures)
        image = pattern(size, 249)
        self.assert_shows(screen, [bytes(byte for byte in image[i:i + line] for _ in range(3))
                                   for i in range(0, size, line)])
        self.assertTrue(saver.alive() and window.alive())


if __name__ == "__main__":
    main()
