# SPDX-License-Identifier: BSD-3-Clause
"""What a report of tzc-rewrite says of sites and lines."""
import collections
import json
import statistics

# Types that are large in use, whatever a message of them holds.
LARGE = {"sensor_msgs/Image", "sensor_msgs/CompressedImage", "sensor_msgs/PointCloud", "sensor_msgs/PointCloud2",
         "sensor_msgs/LaserScan", "sensor_msgs/MultiEchoLaserScan", "nav_msgs/OccupancyGrid", "nav_msgs/Path",
         "map_msgs/OccupancyGridUpdate", "stereo_msgs/DisparityImage", "visualization_msgs/Marker",
         "visualization_msgs/MarkerArray", "octomap_msgs/Octomap", "grid_map_msgs/GridMap"}


def summary_of(path):
    with open(path) as file:
        report = json.load(file)
    reports = report.get("packages", [report])
    counts = collections.Counter()
    left = []
    for package in reports:
        for site in package["sites"]:
            counts[f"{site['kind']} {site['level']}"] += 1
            if site["kind"] == "publish" and site["message_type"] in LARGE:
                counts[f"large {site['level']}"] += 1
                if site["level"] != "zero_copy":
                    left.append(f"{package['package']}/{site['file']}:{site['line']} {site['message_type']} {site['level']} "
                                f"{site['code'] or ''} {site['reason'] or ''}".strip())
    lines = {package["package"]: package["summary"]["lines_added"] + package["summary"]["lines_removed"]
             for package in reports}
    changed = [count for count in lines.values() if count]
    return {"counts": counts, "lines": lines, "median_lines": statistics.median(changed) if changed else 0,
            "large_left": left}
