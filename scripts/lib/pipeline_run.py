# SPDX-License-Identifier: BSD-3-Clause
"""Runs the stereo pipeline of two workspaces on one synthetic recording and compares what comes out.

usage: pipeline_run.py SCRATCH ORIGINAL_WORKSPACE PORTED_WORKSPACE

left and right image -> rectified -> disparity -> point cloud. Exit status 0: every message of the original's output is
in the ported one's, equal in every byte (header.seq aside, which counts what was sent), and there are no others.
"""
import hashlib
import io
import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "support"))
import genpy  # noqa: E402
import rosbag  # noqa: E402
from ros_session import RosSession  # noqa: E402
from sensor_msgs.msg import CameraInfo, Image  # noqa: E402
from workspace_env import workspace_env  # noqa: E402

FRAMES, RATE, WIDTH, HEIGHT = 12, 2, 320, 240
TOPICS = ["/stereo/left/image_rect", "/stereo/left/image_rect_color", "/stereo/right/image_rect",
          "/stereo/disparity", "/stereo/points2"]


def picture(frame, shift):
    """Random squares, the same for both cameras but for a shift: something that stereo matching can match."""
    dice = random.Random(frame)
    pixels = bytearray(dice.getrandbits(6) + 90 for _ in range(WIDTH * HEIGHT))
    for _ in range(60):
        x, y, size, grey = dice.randrange(40, WIDTH - 60), dice.randrange(HEIGHT - 30), dice.randrange(8, 30), dice.randrange(256)
        for row in range(y, y + size):
            for column in range(x - shift, x - shift + size):
                pixels[row * WIDTH + column] = (grey + 7 * row + 13 * column + 13 * shift) % 256
    return bytes(pixels)


def image(stamp, frame, shift):
    message = Image(height=HEIGHT, width=WIDTH, encoding="mono8", step=WIDTH, data=picture(frame, shift))
    message.header.stamp, message.header.frame_id = stamp, "stereo"
    return message


def info(stamp, baseline):
    focal = 200.0
    message = CameraInfo(height=HEIGHT, width=WIDTH, distortion_model="plumb_bob", D=[0.05, -0.02, 0.0, 0.0, 0.0])
    message.K = [focal, 0, WIDTH / 2, 0, focal, HEIGHT / 2, 0, 0, 1]
    message.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
    message.P = [focal, 0, WIDTH / 2, -focal * baseline, 0, focal, HEIGHT / 2, 0, 0, 0, 1, 0]
    message.header.stamp, message.header.frame_id = stamp, "stereo"
    return message


def make_recording(path):
    with rosbag.Bag(path, "w") as bag:
        for frame in range(FRAMES):
            stamp = genpy.Time.from_sec(1000 + frame / RATE)
            for side, shift, baseline in (("left", 0, 0.0), ("right", 12, 0.1)):
                bag.write(f"/stereo/{side}/image_raw", image(stamp, frame, shift), stamp)
                bag.write(f"/stereo/{side}/camera_info", info(stamp, baseline), stamp)


def environment(workspace):
    """What a shell has after setup.bash, without what the session decides."""
    of_session = ("ROS_MASTER_URI", "ROS_IP", "ROS_HOSTNAME", "ROS_HOME", "ROS_LOG_DIR")
    return {name: value for name, value in workspace_env(workspace).items() if name not in of_session}


def run(scratch, workspace, recording):
    """The pipeline's output for the recording, as a bag."""
    result = os.path.join(scratch, "output.bag")
    if os.path.exists(result):
        os.remove(result)
    with RosSession(scratch, environment(workspace)) as ros:
        binary = os.path.join(workspace, "devel", "lib", "stereo_image_proc", "stereo_image_proc")
        ros.start([binary, "__ns:=stereo"], name="stereo_image_proc")
        recorder = ros.start(["rosbag", "record", "-O", result] + TOPICS, name="record")
        for side in ("left", "right"):
            ros.wait_until(lambda topic=f"/stereo/{side}/image_raw": ros.subscribers(topic), 60, "the pipeline")
        player = ros.start(["rosbag", "play", "-d", "3", recording], name="play")
        player.wait(120)
        ros.start(["sleep", "2"]).wait(10)
        recorder.stop(timeout=20)
    return result


def contents(path):
    """(topic, digest of every byte but header.seq) of each message, sorted."""
    found = []
    with rosbag.Bag(path) as bag:
        for topic, message, _ in bag.read_messages():
            message.header.seq = 0
            if hasattr(message, "image"):
                message.image.header.seq = 0
            wire = io.BytesIO()
            message.serialize(wire)
            found.append((topic, hashlib.sha256(wire.getvalue()).hexdigest()))
    return sorted(found)


def main():
    scratch, original, ported = sys.argv[1:]
    os.makedirs(scratch, exist_ok=True)
    recording = os.path.join(scratch, "recording.bag")
    make_recording(recording)
    before = contents(run(os.path.join(scratch, "original"), original, recording))
    after = contents(run(os.path.join(scratch, "ported"), ported, recording))
    for topic in TOPICS:
        counts = [sum(1 for entry in side if entry[0] == topic) for side in (before, after)]
        equal = [e for e in before if e[0] == topic] == [e for e in after if e[0] == topic]
        print(f"{topic:<32}{counts[0]:>4} messages before,{counts[1]:>4} after: {'equal' if equal else 'DIFFERENT'}")
    return 0 if before and before == after else 1


if __name__ == "__main__":
    sys.exit(main())
