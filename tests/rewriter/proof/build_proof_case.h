// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "edits/files.h"
#include "proof/build_proof.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {

constexpr const char* head = "cmake_minimum_required(VERSION 3.13)\nproject(demo CXX)\n";

/// A plain CMake package, configured by its user, and an installation of TZC that CMake can find.
class BuildProof : public ::testing::Test {
 protected:
  BuildProof() {
    put("package.xml", "<package/>");
    put("src/node.cpp", "int main() {}\n");
    put("src/lib.cpp", "int lib() { return 1; }\n");
    folder.write("tzc/include/tzc/ros.h", "inline int tzc_answer() { return 42; }\n");
    folder.write("tzc/lib/libtzc_roscpp.so", "");
    folder.write("tzc/share/tzc/cmake/tzcConfig.cmake", "set(tzc_INCLUDE_DIRS " + (folder / "tzc/include") +
                                                            ")\nset(tzc_LIBRARIES " +
                                                            (folder / "tzc/lib/libtzc_roscpp.so") + ")\n");
  }

  void put(const std::string& name, const std::string& content) const {
    folder.write("demo/" + name, content);
  }

  /// Configures the package as its user did.
  void configure(const std::string& cmake, const std::string& options = "") const {
    put("CMakeLists.txt", head + cmake);
    const std::string command =
        "cmake -S " + (folder / "demo") + " -B " + (folder / build_dir) +
        " -G Ninja -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_INSTALL_PREFIX=" + (folder / "install") + " " +
        options + " > " + (folder / "log") + " 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << folder.read("log");
  }

  /// Why the package with these files is refused; "" when it is proved.
  std::string prove(const std::map<std::string, std::string>& files, bool build = false,
                    const std::set<std::string>& units = {"src/node.cpp"}) {
    PortedPackage package{"demo", folder / "demo", {}, {}, {}, made};
    for (const auto& [name, content] : files) package.contents[folder / ("demo/" + name)] = content;
    for (const std::string& unit : units) package.units.insert(folder / ("demo/" + unit));
    const std::unique_ptr<UserBuild> user = UserBuild::find(folder / build_dir);
    if (!user) return "no build";
    const auto failures = unproved_packages(*user, {package}, {{folder / "tzc"}, build, nullptr, 1, {}});
    return failures.empty() ? "" : to_string(failures.at(folder / "demo"));
  }
  std::string prove_cmake(const std::string& cmake) { return prove({{"CMakeLists.txt", head + cmake}}); }

  /// Path -> content of every file below a folder.
  std::map<std::string, std::string> files_in(const std::string& name) const {
    std::map<std::string, std::string> files;
    if (!std::filesystem::exists(folder / name)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / name))
      if (entry.is_regular_file()) files[entry.path()] = read_file(entry.path()).operator*();
    return files;
  }

  tzc::test::TempDir folder;
  std::string build_dir = "build";
  std::set<std::string> made;  ///< TZC's headers that the build has to make
  const std::string plain = "add_executable(node src/node.cpp)\n";
  const std::string with_tzc =
      "find_package(tzc REQUIRED)\nadd_executable(node src/node.cpp)\n"
      "target_include_directories(node PRIVATE ${tzc_INCLUDE_DIRS})\ntarget_link_libraries(node "
      "${tzc_LIBRARIES})\n";
};

}  // namespace tzc::rewriter
