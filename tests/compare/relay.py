# SPDX-License-Identifier: BSD-3-Clause
"""Publishes what it receives on /in again.

usage: relay.py [--output TOPIC] [--lose-each N]
"""
import argparse

import rospy
from sensor_msgs.msg import Image


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--output", default="/out")
    parser.add_argument("--lose-each", type=int, default=0)
    options = parser.parse_args()
    rospy.init_node("relay")
    output = rospy.Publisher(options.output, Image, queue_size=100)
    count = 0

    def relay(message):
        nonlocal count
        count += 1
        if not options.lose_each or count % options.lose_each:
            output.publish(message)

    rospy.Subscriber("/in", Image, relay, queue_size=100)
    rospy.spin()


if __name__ == "__main__":
    main()
