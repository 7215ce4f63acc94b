// SPDX-License-Identifier: BSD-3-Clause
#include "run/workspace.h"

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "run/failure.h"

namespace tzc::compare {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

std::string setup_file(const std::string& workspace) {
  const fs::path path = workspace;
  if (fs::is_regular_file(path)) return fs::absolute(path);
  for (const char* place : {"devel/setup.bash", "install/setup.bash", "setup.bash"})
    if (fs::exists(path / place)) return fs::absolute(path / place);
  throw Failure(path.string() + " has neither devel/setup.bash nor install/setup.bash",
                "build the workspace, or name its setup.bash");
}

Environment workspace_environment(const std::string& path) {
  const std::string setup = setup_file(path);
  const std::string command = "bash -c '. \"$0\" >&2 && env -0' " + quoted(setup) + " 2>/dev/null";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  if (!pipe) throw Failure("cannot run bash");
  Environment environment;
  std::string entry;
  for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) {
    if (c != 0) {
      entry += static_cast<char>(c);
      continue;
    }
    const std::size_t equals = entry.find('=');
    if (equals != std::string::npos) environment[entry.substr(0, equals)] = entry.substr(equals + 1);
    entry.clear();
  }
  if (environment.count("PATH") == 0)
    throw Failure(setup + " cannot be sourced", "try it: bash -c '. \"$0\"' " + quoted(setup));
  for (const char* name : {"ROS_MASTER_URI", "ROS_IP", "ROS_HOSTNAME", "ROS_LOG_DIR", "TZC_STATISTICS", "_"})
    environment.erase(name);
  return environment;
}

}  // namespace tzc::compare
