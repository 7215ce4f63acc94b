// SPDX-License-Identifier: BSD-3-Clause
// Workspaces of several packages: nothing of the others is touched, and the one that fails is left out.
#include <gtest/gtest.h>

#include <filesystem>

#include "proof/build_proof_case.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;

/// A workspace of two packages, of which `one` is tried.
class BuildProofOfWorkspace : public BuildProof {
 protected:
  void configure_with(const std::string& cmake_of_two) {
    fs::remove(folder / "demo/package.xml");
    put("one/package.xml", "<package/>");
    put("one/CMakeLists.txt", plain);
    put("one/src/node.cpp", "int main() {}\n");
    put("two/package.xml", "<package/>");
    put("two/CMakeLists.txt", cmake_of_two);
    configure("add_subdirectory(one)\nadd_subdirectory(two)\n");
  }

  std::string prove_one(bool build) {
    const std::string one = folder / "demo/one";
    const auto failures =
        unproved_packages(*UserBuild::find(folder / build_dir),
                          {{"one", one, {{one + "/CMakeLists.txt", with_tzc}}, {one + "/src/node.cpp"}}},
                          {{folder / "tzc"}, build, nullptr, 1, {}});
    return failures.empty() ? "" : to_string(failures.begin()->second);
  }
};

/// The source folder is the build folder.
TEST_F(BuildProofOfWorkspace, nothing_that_is_built_in_source_is_touched) {
  build_dir = "demo";
  configure_with("configure_file(package.xml ${CMAKE_CURRENT_BINARY_DIR}/copy.xml)\n");
  const auto before = files_in("demo");
  EXPECT_EQ(prove_one(false), "");
  EXPECT_EQ(files_in("demo"), before);
}

/// A header with a path, as many packages make one, and programs beside the sources: with the scratch folder's path they would be
/// of no use when it is gone.
TEST_F(BuildProofOfWorkspace, nothing_that_another_package_writes_beside_its_sources_is_touched) {
  put("two/config.h.in", "#define DATA \"@CMAKE_CURRENT_SOURCE_DIR@\"\n");
  put("two/main.cpp", "#include \"config.h\"\nconst char* data = DATA;\nint main() {}\n");
  configure_with(
      "configure_file(config.h.in ${CMAKE_CURRENT_SOURCE_DIR}/config.h)\n"
      "file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/where ${CMAKE_CURRENT_SOURCE_DIR})\n"
      "set(EXECUTABLE_OUTPUT_PATH ${CMAKE_CURRENT_SOURCE_DIR}/bin)\nadd_executable(two main.cpp)\n");
  const auto before = files_in("demo");
  ASSERT_EQ(before.count(folder / "demo/two/config.h"), 1u);
  EXPECT_EQ(prove_one(true), "");
  EXPECT_EQ(files_in("demo"), before);
}

/// Packages of one workspace, which its user has configured.
class BuildProofOfSeveral : public BuildProof {
 protected:
  void have(const std::vector<std::string>& names) {
    std::string top = head;
    for (const std::string& name : names) {
      top += "add_subdirectory(" + name + ")\n";
      add(name, "ws/src/" + name);
    }
    folder.write("ws/src/CMakeLists.txt", top);
    const std::string command = "cmake -S " + (folder / "ws/src") + " -B " + (folder / "build") +
                                " -G Ninja > " + (folder / "log") + " 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }
  void add(const std::string& name, const std::string& package) {
    const std::string target = "add_executable(" + name + " " + name + ".cpp)\n";
    folder.write(package + "/package.xml", "<package/>");
    folder.write(package + "/" + name + ".cpp", "int main() {}\n");
    folder.write(package + "/CMakeLists.txt", target);
    packages.push_back({name,
                        folder / package,
                        {{folder / (package + "/CMakeLists.txt"),
                          "find_package(tzc REQUIRED)\ninclude_directories(${tzc_INCLUDE_DIRS})\n" + target +
                              "target_link_libraries(" + name + " ${tzc_LIBRARIES})\n"}},
                        {folder / (package + "/" + name + ".cpp")}});
  }
  /// Names of the packages that are refused.
  std::string refused() {
    ProofOptions options{{folder / "tzc"}, false, nullptr, 1, {}};
    options.progress = [this](const std::string&) { ++steps; };
    std::string names;
    for (const auto& [package, error] :
         unproved_packages(*UserBuild::find(folder / "build"), packages, options))
      names += fs::path(package).filename().string() + " ";
    return names;
  }

  std::vector<PortedPackage> packages;
  unsigned steps = 0;
};

TEST_F(BuildProofOfSeveral, the_one_that_fails_is_left_out) {
  have({"one", "two"});
  packages[1].contents.begin()->second += "include(missing)\n";
  EXPECT_EQ(refused(), "two ");
}

/// Each step configures the whole workspace: all, none, the one that is named, the rest.
TEST_F(BuildProofOfSeveral, the_one_that_cmake_names_is_tried_first) {
  have({"a", "b", "c", "d", "e"});
  packages[3].contents.begin()->second += "include(missing)\n";
  EXPECT_EQ(refused(), "d ");
  EXPECT_EQ(steps, 4u);
}

TEST_F(BuildProofOfSeveral, where_cmake_names_another_each_is_tried) {
  have({"a", "b", "c"});
  folder.write("ws/src/CMakeLists.txt", folder.read("ws/src/CMakeLists.txt") +
                                            "if(SPOILED)\n  message(FATAL_ERROR spoiled)\nendif()\n");
  packages[1].contents.begin()->second += "set(SPOILED ON PARENT_SCOPE)\n";
  EXPECT_EQ(refused(), "b ");
}

}  // namespace
}  // namespace tzc::rewriter
