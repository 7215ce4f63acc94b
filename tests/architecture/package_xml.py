# SPDX-License-Identifier: BSD-3-Clause
"""package.xml names every ROS package whose headers the product includes, so that rosdep installs it: an include
<PACKAGE/...> of a package that is installed here as one. The adapters' headers are the user's to include, who then has
those packages."""
import os
import re
import subprocess

from problem import Problem

_DEPENDENCY = re.compile(r"<(?:build_|exec_|buildtool_)?depend>\s*([a-z0-9_]+)\s*</")
_USERS_CHOICE = "runtime/adapters/"
_PACKAGE_OF_FOLDER = {"rosbag": "rosbag_storage"}


def check(tree, ros_packages=None):
    ros_packages = _installed() if ros_packages is None else ros_packages
    declared = _declared(tree.root)
    for path in tree.files:
        if path.startswith(_USERS_CHOICE):
            continue
        for include in tree.includes(path):
            package = _package_of(include)
            if package in ros_packages and package not in declared:
                yield Problem(package, f"{path}:{include.line}", f"includes <{include.spelled}>; package.xml lacks {package}")


def _package_of(include):
    folder = include.spelled.partition("/")[0]
    return None if include.target else _PACKAGE_OF_FOLDER.get(folder, folder)


def _declared(root):
    with open(os.path.join(root, "package.xml"), encoding="utf-8") as file:
        return set(_DEPENDENCY.findall(re.sub(r"<!--.*?-->", "", file.read(), flags=re.S)))


def _installed():
    names = subprocess.run(["rospack", "list-names"], check=True, stdout=subprocess.PIPE, text=True).stdout.split()
    if "roscpp" not in names:
        raise SystemExit("rospack knows no roscpp: is ROS_PACKAGE_PATH set to something else?")
    return set(names)
