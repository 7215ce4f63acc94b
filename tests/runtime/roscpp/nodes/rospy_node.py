# SPDX-License-Identifier: BSD-3-Clause
"""A rospy node on the topic "image": listens and prints what the C++ listener prints, or talks (~count images)."""
import json

import rospy
from sensor_msgs.msg import Image


def pattern(size, number):
    return bytes((i * 31 + i // 256 + number * 7) & 0xff for i in range(size))


def on_image(image):
    number = int(image.header.frame_id)
    right = image.data == pattern(len(image.data), number)
    print(json.dumps({"number": number, "seq": image.header.seq, "right": right, "shared": False}), flush=True)


def talk(count):
    publisher = rospy.Publisher("image", Image, queue_size=100)
    while not rospy.is_shutdown() and publisher.get_num_connections() < 1:
        rospy.sleep(0.01)
    rospy.sleep(0.5)
    for number in range(count):
        image = Image(height=1, width=5000, step=5000, encoding="mono8", data=pattern(5000, number))
        image.header.frame_id = str(number)
        image.header.stamp = rospy.Time.now()
        publisher.publish(image)
        rospy.sleep(0.01)
    rospy.sleep(0.5)


rospy.init_node("rospy_node", anonymous=True)
if rospy.get_param("~count", 0):
    talk(rospy.get_param("~count"))
else:
    rospy.Subscriber("image", Image, on_image, queue_size=1000)
    rospy.spin()
