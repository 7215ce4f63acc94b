// SPDX-License-Identifier: BSD-3-Clause
// The package's folder is its build folder, too: sources are told from what CMake makes beside them.
#include <gtest/gtest.h>

#include <filesystem>

#include "golden/case.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;

/// A function that publishes an image.
std::string function_that_publishes(const std::string& name) {
  return "#include <ros/ros.h>\n#include <sensor_msgs/Image.h>\nvoid " + name +
         "(ros::NodeHandle& nh) {\n  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(\"" + name +
         "\", 10);\n  sensor_msgs::Image image;\n  image.data.resize(10);\n  pub.publish(image);\n}\n";
}

/// The files in which the port has sites, edits or notes, for a build in `build_dir` below the package's folder.
std::set<std::string> seen_files(const test::Package& package, const std::string& build_dir) {
  EngineOptions options = package.options({});
  options.build_dirs[package.dir()] = package.dir() + build_dir;
  const Expected<PortPlan> plan = plan_port(options);
  if (!plan) return {to_string(plan.error())};
  std::set<std::string> files;
  for (const Site& site : plan->report.sites) files.insert("site " + site.where.file);
  for (const Edit& edit : plan->edits) files.insert("edit " + edit.file);
  for (const Note& note : plan->report.notes) files.insert("note " + note.where->file);
  return files;
}

TEST(InSource, sources_are_ported_and_what_cmake_made_is_not) {
  const test::Package package({{"src/node.cpp", function_that_publishes("run")},
                               {"CMakeFiles/made.cpp", function_that_publishes("made")},
                               {"CMakeFiles/3.25/CMakeCXXCompilerId.cc", "int main() {}\n"}});
  fs::copy(package.dir() + "/build/compile_commands.json", package.dir());
  const std::string node = package.dir() + "/src/node.cpp";
  const std::set<std::string> expected = {"site " + node, "edit " + node};
  EXPECT_EQ(seen_files(package, ""), expected);
  EXPECT_EQ(seen_files(package, "/build"), expected);
}

TEST(InSource, a_link_to_a_file_that_is_compiled_is_no_other_file) {
  const test::Package package({{"src/node.cpp", function_that_publishes("run")}});
  fs::create_symlink("node.cpp", package.dir() + "/src/alias.cpp");
  const std::string node = package.dir() + "/src/node.cpp";
  EXPECT_EQ(seen_files(package, "/build"), (std::set<std::string>{"site " + node, "edit " + node}));
}

}  // namespace
}  // namespace tzc::rewriter
