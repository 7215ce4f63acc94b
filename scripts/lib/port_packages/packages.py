# SPDX-License-Identifier: BSD-3-Clause
"""The catkin packages of a repository."""
import fnmatch
import os

from catkin_pkg.package import InvalidPackage, parse_package

IGNORED = ("CATKIN_IGNORE", "AMENT_IGNORE", "COLCON_IGNORE")
CONDITIONS = {"ROS_VERSION": "1", "ROS_PYTHON_VERSION": "3", "ROS_DISTRO": os.environ.get("ROS_DISTRO", "noetic")}


class Package:
    def __init__(self, root, folder):
        manifest = parse_package(os.path.join(root, folder), warnings=[])
        manifest.evaluate_conditions(CONDITIONS)
        self.folder = folder  # relative to the repository
        self.name = manifest.name
        tools = self._names(manifest.buildtool_depends)
        kinds = [export.content.strip() for export in manifest.exports
                 if export.tagname == "build_type" and export.evaluated_condition]
        self.is_catkin = kinds in ([], ["catkin"]) and any(tool.startswith("catkin") for tool in tools)
        self.needs = tools | self._names(manifest.build_depends) | self._names(manifest.build_export_depends)

    @staticmethod
    def _names(dependencies):
        return {dependency.name for dependency in dependencies if dependency.evaluated_condition}


def find_packages(root, only=()):
    """(packages, {folder: reason} of what is none that can be built)"""
    packages, refused = [], {}
    for folder, subfolders, files in os.walk(root):
        if any(name in files for name in IGNORED):
            subfolders.clear()
            continue
        subfolders[:] = sorted(name for name in subfolders if not name.startswith("."))
        if "package.xml" not in files:
            continue
        subfolders.clear()
        relative = os.path.relpath(folder, root)
        try:
            package = Package(root, relative)
        except InvalidPackage as error:
            refused[relative] = f"package.xml: {error}"
            continue
        if not package.is_catkin:
            refused[package.name] = "is no catkin package"
        elif not only or any(fnmatch.fnmatch(package.name, glob) for glob in only):
            packages.append(package)
    return packages, refused


def with_users(names, packages):
    """The packages of these names, and those that need them, directly or not."""
    found = set(names)
    while True:
        more = {package.name for package in packages if package.needs & found} - found
        if not more:
            return found
        found |= more
