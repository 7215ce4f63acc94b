# SPDX-License-Identifier: BSD-3-Clause
"""The message types of generated programs and how their fields are set."""


class Element:
    """The element type of an array."""

    def __init__(self, cpp, fields=()):
        self.cpp, self.fields = cpp, fields

    def value(self, index="i"):
        """An expression for an element's value."""
        if self.fields:
            return f"fuzz::element<{self.cpp}>({index}, k)"
        return f"static_cast<{self.cpp}>(fuzz::value({index}, k))"

    def put(self, target, index="i"):
        """A statement that writes the element `target`, perhaps not all of its fields."""
        if self.fields:
            return " ".join(f"{target}.{field} = fuzz::value({index}, k);" for field in self.fields)
        return f"{target} = {self.value(index)};"


class Message:
    def __init__(self, ros, arrays, meta=(), header=True):
        self.ros, self.arrays, self.meta, self.header = ros, arrays, meta, header
        self.package, self.name = ros.split("/")
        self.cpp = f"{self.package}::{self.name}"
        self.include = f"{ros}.h"

    def set_meta(self, access):
        """Statements that set the fields besides the arrays; `access` is "msg." or "msg->"."""
        lines = []
        if self.header:
            lines.append(f"{access}header.stamp = ros::Time(100 + k, 5);")
            lines.append(f'{access}header.frame_id = "camera";')
        return lines + [f"{access}{line}" for line in self.meta]


U8, I8, F32 = Element("uint8_t"), Element("int8_t"), Element("float")
POINT = Element("geometry_msgs::Point", ("x", "z"))
POINT32 = Element("geometry_msgs::Point32", ("x", "y", "z"))
COLOR = Element("std_msgs::ColorRGBA", ("r", "a"))

IMAGE = Message("sensor_msgs/Image", [("data", U8)],
                ['encoding = "mono8";', "height = 1;", "width = fuzz::size(k, 3);", "step = fuzz::size(k, 3);"])
CLOUD2 = Message("sensor_msgs/PointCloud2", [("data", U8)], ["height = 1;", "width = 4 + k;", "point_step = 16;"])
ALL = [
    IMAGE,
    CLOUD2,
    Message("sensor_msgs/LaserScan", [("ranges", F32), ("intensities", F32)], ["angle_min = -1.5f;"]),
    Message("sensor_msgs/PointCloud", [("points", POINT32)]),
    Message("sensor_msgs/CompressedImage", [("data", U8)], ['format = "jpeg";']),
    Message("nav_msgs/OccupancyGrid", [("data", I8)], ["info.width = 7;", "info.resolution = 0.5f;"]),
    Message("std_msgs/Float32MultiArray", [("data", F32)], ["layout.data_offset = k;"], header=False),
    Message("visualization_msgs/Marker", [("points", POINT), ("colors", COLOR)], ["id = k;", 'ns = "fuzz";']),
    Message("stereo_msgs/DisparityImage", [("image.data", U8)], ["f = 1.5f;", 'image.encoding = "32FC1";']),
]
WEIGHTS = [6, 4, 3, 1, 1, 2, 2, 2, 1]


def choose(rng):
    return rng.choices(ALL, WEIGHTS)[0]
