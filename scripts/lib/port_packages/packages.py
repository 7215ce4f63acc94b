# SPDX-License-Identifier: BSD-3-Clause
"""The catkin packages of a repository."""
import fnmatch
import os
import xml.etree.ElementTree

IGNORED = ("CATKIN_IGNORE", "AMENT_IGNORE", "COLCON_IGNORE")


class Package:
    def __init__(self, folder, manifest):
        self.folder = folder  # relative to the repository
        self.name = manifest.findtext("name", "").strip()
        kind = manifest.findtext("export/build_type", "catkin").strip()
        tools = [entry.text.strip() for entry in manifest.findall("buildtool_depend") if entry.text]
        self.is_catkin = kind == "catkin" and any(tool.startswith("catkin") for tool in tools)
        self.needs = {entry.text.strip() for entry in manifest if entry.tag.endswith("depend") and entry.text
                      and entry.tag not in ("test_depend", "doc_depend", "run_depend", "exec_depend")}


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
            package = Package(relative, xml.etree.ElementTree.parse(os.path.join(folder, "package.xml")).getroot())
        except xml.etree.ElementTree.ParseError as error:
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
