// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "proof/process.h"
#include "support/temp_dir.h"

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

  /// From now on the program may do what the modes of files say, and no more, also when root runs the tests.
  void respect_modes() {
    if (::geteuid() == 0) launcher_ = {"setpriv", "--bounding-set=-dac_override,-dac_read_search"};
  }

  /// What the planner does, changed by the test before it runs anything.
  nlohmann::json& plan() { return plan_; }

  std::string package() const { return folder_ / "ws/src/demo"; }
  const tzc::test::TempDir& folder() const { return folder_; }
  std::string file(const std::string& name) const { return folder_.read("ws/src/demo/" + name); }

  /// tzc-rewrite WORDS... PACKAGE
  ProcessResult rewrite(std::vector<std::string> words, std::map<std::string, std::string> environment = {}) {
    words.push_back(package());
    return run(std::move(words), std::move(environment));
  }

  /// The cache and what undoes a port lie in the folder, too.
  ProcessResult run(std::vector<std::string> words, std::map<std::string, std::string> environment = {}) {
    folder_.write("ws/src/demo/plan.json", plan_.dump());
    if (!names_verification(words)) words.insert(words.begin(), "--verify=source");
    words.insert(words.begin(), {FAKE_REWRITE, "--tzc-include", folder_ / "include"});
    words.insert(words.begin(), launcher_.begin(), launcher_.end());
    environment.insert({{"XDG_STATE_HOME", folder_ / "state"}, {"XDG_CACHE_HOME", folder_ / "xdg"}});
    return run_process(Command{words, "", environment});
  }

  /// A shell command in the workspace; its exit status.
  int shell(const std::string& command) const {
    return std::system(("cd '" + (folder_ / "ws") + "' && { " + command + "; } >/dev/null 2>&1").c_str());
  }

 private:
  /// What is not said otherwise runs without CMake: there is nothing to configure here.
  static bool names_verification(const std::vector<std::string>& words) {
    return std::any_of(words.begin(), words.end(),
                       [](const std::string& word) { return word.rfind("--verify", 0) == 0; });
  }

  tzc::test::TempDir folder_;
  nlohmann::json plan_;
  std::vector<std::string> launcher_;
};

}  // namespace tzc::rewriter::test
