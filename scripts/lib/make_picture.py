# SPDX-License-Identifier: BSD-3-Clause
"""Writes a 1920x1080 test picture as PPM. usage: make_picture.py FILE"""
import sys

WIDTH, HEIGHT = 1920, 1080


def main():
    row = [bytes(((x // 8) & 255, (x // 3) & 255, 128)) for x in range(WIDTH)]
    with open(sys.argv[1], "wb") as picture:
        picture.write(b"P6\n%d %d\n255\n" % (WIDTH, HEIGHT))
        for y in range(HEIGHT):
            shift = (y * 7) % WIDTH
            picture.write(b"".join(row[shift:] + row[:shift]))


if __name__ == "__main__":
    main()
