#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""usage: make_inputs.py DIR

Makes inputs for `scripts/port-packages --inputs DIR`: copies the launch files and arguments beside this script, and writes what
they name: drive.bag, ten seconds of a robot that drives through a room with pillars (/scan, /points, /camera/... and /tf);
stand.bag, the same robot before it starts, with one scan again and again, for nodes whose output depends on when they run; and
map.yaml, the room as a map. The same in every run. Needs Debian's python3-rosbag, python3-sensor-msgs and python3-tf2-msgs.
"""
import math
import os
import random
import shutil
import struct
import sys

import rosbag
import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import CameraInfo, Image, LaserScan, PointCloud2, PointField
from tf2_msgs.msg import TFMessage

HZ, SECONDS, START = 10, 10, 1000
ROOM = 6.0  # half of its side, in metres
PILLARS = [(2.0, 1.5, 0.3), (-2.5, 2.0, 0.4), (1.0, -3.0, 0.25), (-3.0, -2.5, 0.5), (4.0, -1.0, 0.35)]
WIDTH, HEIGHT = 320, 240


def pose(t):
    """x, y and heading after t seconds."""
    return 0.8 * math.sin(0.3 * t), 0.3 * t - 1.5, 0.2 * math.sin(0.4 * t)


def distance(x, y, angle):
    """To the nearest wall or pillar."""
    dx, dy = math.cos(angle), math.sin(angle)
    best = min([(math.copysign(ROOM, d) - p) / d for p, d in ((x, dx), (y, dy)) if abs(d) > 1e-9])
    for cx, cy, radius in PILLARS:
        along = (cx - x) * dx + (cy - y) * dy
        off = (cx - x) ** 2 + (cy - y) ** 2 - along ** 2
        if along > 0 and off < radius ** 2:
            best = min(best, along - math.sqrt(radius ** 2 - off))
    return best


def scan_at(t, noise):
    x, y, heading = pose(t)
    message = LaserScan(angle_min=-2.35, angle_max=2.35, angle_increment=0.00654, time_increment=0.0, scan_time=1 / HZ,
                        range_min=0.1, range_max=30.0)
    beams = int((message.angle_max - message.angle_min) / message.angle_increment) + 1
    message.ranges = [distance(x, y, heading + message.angle_min + i * message.angle_increment) + noise.gauss(0, 0.005)
                      for i in range(beams)]
    message.intensities = [1000.0 / max(r, 0.1) for r in message.ranges]
    return message


def cloud_at(t, noise):
    """Sixteen rings, as a spinning laser sees the room."""
    x, y, heading = pose(t)
    names = ("x", "y", "z", "intensity")
    message = PointCloud2(height=1, is_bigendian=False, point_step=20, is_dense=True)
    message.fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate(names)]
    message.fields.append(PointField("ring", 16, PointField.UINT16, 1))
    points = bytearray()
    for column in range(900):
        angle = math.radians(column * 0.4) - math.pi
        far = distance(x, y, heading + angle)
        for ring in range(16):
            up = math.radians(2 * ring - 15)
            r = far + noise.gauss(0, 0.005)
            z = r * math.tan(up)
            if z < -0.5:  # the floor
                r, z = -0.5 / math.tan(up), -0.5
            points += struct.pack("<4fHH", r * math.cos(angle), r * math.sin(angle), z, 100.0 / max(r, 0.1), ring, 0)
    message.width = len(points) // message.point_step
    message.row_step, message.data = len(points), bytes(points)
    return message


def picture_at(t):
    """Coloured squares and a disc that moves."""
    cx, cy = 160 + 100 * math.cos(t), 120 + 60 * math.sin(t)
    rows = []
    for v in range(HEIGHT):
        for u in range(WIDTH):
            if (u - cx) ** 2 + (v - cy) ** 2 < 900:
                rows.append(b"\x20\x40\xf0")
            else:
                rows.append(bytes(((u // 40) * 30, (v // 40) * 40, ((u + v) // 80) * 35)))
    return Image(height=HEIGHT, width=WIDTH, encoding="bgr8", step=3 * WIDTH, data=b"".join(rows))


def depth_at(t):
    """The room ahead, in millimetres."""
    x, y, heading = pose(t)
    row = b"".join(struct.pack("<H", int(1000 * distance(x, y, heading - math.atan((u - 160) / 277.0)))) for u in range(WIDTH))
    return Image(height=HEIGHT, width=WIDTH, encoding="16UC1", step=2 * WIDTH, data=row * HEIGHT)


def camera_info():
    return CameraInfo(height=HEIGHT, width=WIDTH, distortion_model="plumb_bob", D=[0.0] * 5,
                      K=[277.0, 0, 160, 0, 277.0, 120, 0, 0, 1], R=[1, 0, 0, 0, 1, 0, 0, 0, 1],
                      P=[277.0, 0, 160, 0, 0, 277.0, 120, 0, 0, 0, 1, 0])


def transform(stamp, parent, child, x, y, heading):
    message = TransformStamped(child_frame_id=child)
    message.header.stamp, message.header.frame_id = stamp, parent
    message.transform.translation.x, message.transform.translation.y = x, y
    message.transform.rotation.z, message.transform.rotation.w = math.sin(heading / 2), math.cos(heading / 2)
    return message


def transforms_at(t, stamp):
    return TFMessage([transform(stamp, "odom", "base_link", *pose(t)), transform(stamp, "base_link", "laser", 0.1, 0, 0),
                      transform(stamp, "base_link", "camera", 0.15, 0, 0)])


def write_drive(path):
    noise = random.Random(1)
    with rosbag.Bag(path, "w") as bag:
        for i in range(HZ * SECONDS):
            t = i / HZ
            stamp = rospy.Time(START) + rospy.Duration(t)

            def write(topic, frame, message):
                message.header.seq, message.header.stamp, message.header.frame_id = i, stamp, frame
                bag.write(topic, message, stamp)

            bag.write("/tf", transforms_at(t, stamp), stamp)
            write("/scan", "laser", scan_at(t, noise))
            write("/points", "laser", cloud_at(t, noise))
            write("/camera/image_raw", "camera", picture_at(t))
            write("/camera/camera_info", "camera", camera_info())
            write("/camera/depth/image_raw", "camera", depth_at(t))
            write("/camera/depth/camera_info", "camera", camera_info())
        # A node that waits for transforms may answer the last of these a little later: the recording, and with it the clock, goes on.
        for i in range(HZ):
            stamp = rospy.Time(START + SECONDS) + rospy.Duration(i / HZ)
            bag.write("/tf", transforms_at(SECONDS + i / HZ, stamp), stamp)


def write_stand(path):
    scan = scan_at(0, random.Random(1))
    with rosbag.Bag(path, "w") as bag:
        for i in range(HZ * SECONDS):
            stamp = rospy.Time(START) + rospy.Duration(i / HZ)
            scan.header.seq, scan.header.stamp, scan.header.frame_id = i, stamp, "laser"
            bag.write("/tf", transforms_at(0, stamp), stamp)
            bag.write("/scan", scan, stamp)


def write_map(folder):
    cells = int(2 * ROOM / 0.05)

    def cell(u, v):
        x, y = (u + 0.5) * 0.05 - ROOM, ROOM - (v + 0.5) * 0.05
        wall = max(abs(x), abs(y)) > ROOM - 0.1 or any(math.hypot(x - px, y - py) < r for px, py, r in PILLARS)
        return 0 if wall else 254

    with open(os.path.join(folder, "map.pgm"), "wb") as file:
        file.write(b"P5 %d %d 255\n" % (cells, cells) + bytes(cell(u, v) for v in range(cells) for u in range(cells)))
    with open(os.path.join(folder, "map.yaml"), "w") as file:
        file.write(f"image: map.pgm\nresolution: 0.05\norigin: [{-ROOM}, {-ROOM}, 0.0]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n")


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    folder, here = sys.argv[1], os.path.dirname(os.path.abspath(__file__))
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(here):
        if name.endswith((".launch", ".args")) and os.path.abspath(folder) != here:
            shutil.copy(os.path.join(here, name), folder)
    write_map(folder)
    for name, write in (("drive.bag", write_drive), ("stand.bag", write_stand)):
        write(os.path.join(folder, name + ".new"))
        os.replace(os.path.join(folder, name + ".new"), os.path.join(folder, name))


if __name__ == "__main__":
    main()
