// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/temp_dir.h"
#include "tool/process.h"

namespace tzc::rewriter::test {

/// A catkin workspace with one package "demo", ported by a script instead of by analysis (see fake_main.cpp).
class Workspace {
 public:
  Workspace() {
    folder_.write("include/tzc/ros.h", "");
    folder_.write("include/tzc/std_msgs/Header.h", "");
    folder_.write(
        "ws/src/demo/package.xml",
        "<package format=\"2\">\n  <name>demo</name>\n  <buildtool_depend>catkin</buildtool_depend>\n"
        "  <depend>roscpp</depend>\n</package>\n");
    folder_.write("ws/src/demo/CMakeLists.txt",
                  "project(demo)\nfind_package(catkin REQUIRED COMPONENTS roscpp)\n"
                  "include_directories(${catkin_INCLUDE_DIRS})\nadd_executable(node src/node.cpp)\n"
                  "target_link_libraries(node ${catkin_LIBRARIES})\n");
    folder_.write("ws/src/demo/src/node.cpp", "#include <ros/ros.h>\nros::Publisher pub;\nint main() {}\n");
    database("ws/build");
    plan_["edits"] = {{{"file", "src/node.cpp"}, {"find", "ros::Publisher"}, {"replace", "tzc::Publisher"}}};
    plan_["sites"] = {{{"id", "publish:src/node.cpp:main:0"}, {"line", 2}, {"topic", "image"}}};
  }

  void database(const std::string& folder) {
    folder_.write(
        folder + "/compile_commands.json",
        nlohmann::json::array({{{"directory", folder_.path()},
                                {"file", package() + "/src/node.cpp"},
                                {"command", "c++ -o demo/CMakeFiles/node.dir/src/node.cpp.o -c x"}}})
            .dump());
  }

  /// What the planner does, changed by the test before it runs anything.
  nlohmann::json& plan() { return plan_; }

  std::string package() const { return folder_ / "ws/src/demo"; }
  const TempDir& folder() const { return folder_; }
  std::string file(const std::string& name) const { return folder_.read("ws/src/demo/" + name); }

  /// tzc-rewrite WORDS... PACKAGE
  ProcessResult rewrite(std::vector<std::string> words) {
    words.push_back(package());
    return run(std::move(words));
  }

  ProcessResult run(std::vector<std::string> words) {
    folder_.write("ws/src/demo/plan.json", plan_.dump());
    words.insert(words.begin(), {FAKE_REWRITE, "--tzc-include", folder_ / "include"});
    return run_process(words);
  }

  /// A shell command in the workspace; its exit status.
  int shell(const std::string& command) const {
    return std::system(("cd '" + (folder_ / "ws") + "' && { " + command + "; } >/dev/null 2>&1").c_str());
  }

 private:
  TempDir folder_;
  nlohmann::json plan_;
};

}  // namespace tzc::rewriter::test
