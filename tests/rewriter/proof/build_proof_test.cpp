// SPDX-License-Identifier: BSD-3-Clause
// CMake judges the edited build files, in a scratch copy; the user's build, devel and install stay as they are.
#include "proof/build_proof.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <map>

#include "proof/build_proof_case.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST_F(BuildProof, include_folder_standard_and_library) {
  configure(plain);
  EXPECT_EQ(prove_cmake(with_tzc), "");
  EXPECT_THAT(prove_cmake(plain),
              HasSubstr("for the target node, TZC's headers are in none of its include folders"));
  EXPECT_THAT(prove_cmake("find_package(tzc REQUIRED)\n" + plain +
                          "target_include_directories(node PRIVATE ${tzc_INCLUDE_DIRS})\n"),
              HasSubstr("the target node does not link TZC's libraries"));
  EXPECT_THAT(
      prove_cmake("set(STD 11)\nset(CMAKE_CXX_STANDARD ${STD})\n" + with_tzc),
      AllOf(HasSubstr("-std=gnu++11, TZC's headers need C++14"), HasSubstr("set(CMAKE_CXX_STANDARD 14)")));
}

/// A header of TZC that is made only later, or never, is an error of the build that no look at the sources finds.
TEST_F(BuildProof, headers_that_the_build_makes) {
  configure(plain);
  made = {"tzc/demo_msgs/Cloud.h"};
  const std::string include = "#include <tzc/demo_msgs/Cloud.h>\n", main = "int main() {}\n";
  const auto prove_node = [&](const std::string& cmake) {
    return prove({{"CMakeLists.txt", head + cmake}, {"src/node.cpp", include + main}});
  };
  const std::string making =
      "set(CLOUD ${CMAKE_BINARY_DIR}/made/tzc/demo_msgs/Cloud.h)\n"
      "add_custom_command(OUTPUT ${CLOUD}.first ${CLOUD} COMMAND ${CMAKE_COMMAND} -E touch ${CLOUD})\n"
      "add_custom_target(messages_of_demo DEPENDS ${CLOUD})\nadd_custom_target(messages)\n"
      "add_dependencies(messages messages_of_demo)\n" +
      with_tzc;
  const std::string seen = "target_include_directories(node PRIVATE made ${CMAKE_BINARY_DIR}/made)\n";
  EXPECT_THAT(prove_node(with_tzc),
              AllOf(HasSubstr("nothing makes <tzc/demo_msgs/Cloud.h>, which it includes"),
                    HasSubstr("write tzc_generate_messages(demo_msgs)")));
  EXPECT_THAT(prove_node(making), HasSubstr("nothing makes <tzc/demo_msgs/Cloud.h>"));  // where it looks
  EXPECT_THAT(prove_node(making + seen),
              AllOf(HasSubstr("nothing says that messages_of_demo makes <tzc/demo_msgs/Cloud.h> before it"),
                    HasSubstr("add_dependencies(node messages_of_demo)")));
  EXPECT_EQ(prove_node(making + seen + "add_dependencies(node messages)\n"), "");
  // The package leaves the order of roscpp's header to chance, too.
  const std::string stock =
      "add_custom_command(OUTPUT made/demo_msgs/Cloud.h COMMAND ${CMAKE_COMMAND} -E echo)\n"
      "add_custom_target(stock DEPENDS made/demo_msgs/Cloud.h)\n";
  EXPECT_EQ(prove_node(stock + making + seen), "");
  EXPECT_THAT(prove_node(stock + making + seen + "add_dependencies(node stock)\n"),
              HasSubstr("nothing says that messages_of_demo makes"));
  EXPECT_EQ(prove({{"CMakeLists.txt", head + with_tzc}, {"src/node.cpp", main}}), "");
}

TEST_F(BuildProof, headers_that_are_there_and_headers_that_a_changed_header_includes) {
  put("src/other.cpp", "#include \"absent.h\"\nint main() {}\n");
  const std::string both = with_tzc +
                           "add_executable(other src/other.cpp)\n"
                           "target_include_directories(other PRIVATE ${tzc_INCLUDE_DIRS})\n"
                           "target_link_libraries(other ${tzc_LIBRARIES})\n";
  configure(plain + "add_executable(other src/other.cpp)\n");
  made = {"tzc/demo_msgs/Cloud.h"};
  const std::map<std::string, std::string> files = {{"CMakeLists.txt", head + both},
                                                    {"src/node.h", "#include <tzc/demo_msgs/Cloud.h>\n"},
                                                    {"src/node.cpp", "#include \"node.h\"\nint main() {}\n"}};
  EXPECT_EQ(prove(files, false, {"src/other.cpp"}), "");
  EXPECT_THAT(prove(files, false, {"src/node.cpp", "src/other.cpp"}),
              AllOf(HasSubstr("src/node.cpp"), HasSubstr("nothing makes <tzc/demo_msgs/Cloud.h>")));
  folder.write("tzc/include/tzc/demo_msgs/Cloud.h", "");
  EXPECT_EQ(prove(files, false, {"src/node.cpp", "src/other.cpp"}), "");
}

/// Narrowing is an error from C++11 on. The analysis does not ask the compiler about a unit that the port does not touch.
TEST_F(BuildProof, a_raised_standard_that_rejects_what_the_port_does_not_touch) {
  put("src/lib.cpp", "int numbers[] = {4000000000u};\n");
  const std::string lib = "add_library(lib OBJECT src/lib.cpp)\n",
                    old = "add_compile_options(-std=gnu++98)\n";
  configure(old + lib + plain);
  EXPECT_THAT(prove_cmake("add_compile_options(-std=gnu++14)\n" + lib + with_tzc),
              AllOf(HasSubstr("src/lib.cpp"), HasSubstr("ask for C++14, as which"), HasSubstr("narrow")));
  EXPECT_EQ(prove_cmake(lib +
                        "target_compile_options(lib PRIVATE -std=gnu++98)\n"
                        "set(CMAKE_CXX_STANDARD 14)\n" +
                        with_tzc),
            "");
  put("src/lib.cpp", "int numbers[] = {4};\n");
  EXPECT_EQ(prove_cmake("add_compile_options(-std=gnu++14)\n" + lib + with_tzc), "");
}

TEST_F(BuildProof, a_standard_may_be_named_with_two_dashes) {
  configure(plain);
  EXPECT_THAT(prove_cmake("add_compile_options(--std=c++11)\n" + with_tzc),
              HasSubstr("it is compiled with --std=c++11, TZC's headers need C++14"));
}

TEST_F(BuildProof, nothing_of_the_users_trees_is_touched) {
  configure(
      "configure_file(package.xml ${CMAKE_BINARY_DIR}/copy.xml)\ninstall(FILES package.xml DESTINATION x)\n" +
      plain);
  folder.write("install/mine", "1");
  const auto build = files_in("build"), install = files_in("install"), package = files_in("demo");
  EXPECT_EQ(prove({{"CMakeLists.txt", head + with_tzc}}, true), "");
  EXPECT_EQ(files_in("build"), build);
  EXPECT_EQ(files_in("install"), install);
  EXPECT_EQ(files_in("demo"), package);
}

/// The cache of an in-source build lies among the sources, and so does what the build made.
TEST_F(BuildProof, nothing_of_an_in_source_build_is_touched) {
  build_dir = "demo";
  configure(
      "set(SOURCE ${CMAKE_SOURCE_DIR}/src/node.cpp CACHE FILEPATH \"\")\n"
      "configure_file(package.xml ${CMAKE_BINARY_DIR}/copy.xml)\n" +
      plain);
  const auto package = files_in("demo");
  ASSERT_EQ(package.count(folder / "demo/CMakeCache.txt"), 1u);
  const std::string port = "if(NOT EXISTS ${SOURCE} OR SOURCE STREQUAL \"" + (folder / "demo/src/node.cpp") +
                           "\" OR EXISTS ${CMAKE_SOURCE_DIR}/CMakeCache.txt)\n"
                           "  message(FATAL_ERROR ${SOURCE})\nendif()\n"
                           "configure_file(package.xml ${CMAKE_BINARY_DIR}/copy.xml)\n";
  EXPECT_EQ(prove_cmake(port + with_tzc), "");
  EXPECT_EQ(prove({{"CMakeLists.txt", head + port + with_tzc}}, true), "");
  EXPECT_THAT(prove_cmake(port + plain), HasSubstr("TZC's headers are in none of its include folders"));
  EXPECT_EQ(files_in("demo"), package);
}

TEST_F(BuildProof, the_users_cache_counts) {
  configure("if(NOT WITH_NODE)\n  message(FATAL_ERROR \"no node\")\nendif()\n" + plain, "-DWITH_NODE=ON");
  EXPECT_EQ(prove_cmake("if(NOT WITH_NODE)\n  message(FATAL_ERROR \"no node\")\nendif()\n" + with_tzc), "");
  configure(plain, "-DCMAKE_CXX_STANDARD=11");
  EXPECT_THAT(prove_cmake(with_tzc), HasSubstr("TZC's headers need C++14"));
}

TEST_F(BuildProof, a_path_of_the_build_tree_in_the_cache_leads_to_the_copy) {
  configure("set(OUT ${CMAKE_BINARY_DIR}/out CACHE PATH \"\")\n" + plain);
  const std::string cmake = "file(WRITE ${OUT}/written \"x\")\n" + with_tzc;
  EXPECT_EQ(prove_cmake(cmake), "");
  EXPECT_FALSE(fs::exists(folder / "build/out"));
}

TEST_F(BuildProof, an_included_file_and_a_function_with_keywords) {
  const std::string function =
      "function(demo_program name)\n  add_executable(${name} ${ARGN})\n"
      "  target_include_directories(${name} SYSTEM PRIVATE ${tzc_INCLUDE_DIRS})\n"
      "  target_link_libraries(${name} PRIVATE ${tzc_LIBRARIES})\nendfunction()\n";
  put("cmake/programs.cmake", function);
  configure("include(cmake/programs.cmake)\ndemo_program(node src/node.cpp)\n");
  EXPECT_EQ(
      prove_cmake(
          "find_package(tzc REQUIRED)\ninclude(cmake/programs.cmake)\ndemo_program(node src/node.cpp)\n"),
      "");
  EXPECT_THAT(
      prove_cmake(
          "find_package(tzc REQUIRED)\ninclude(cmake/programs.cmake)\ndemo_program(node src/node.cpp)\n"
          "target_link_libraries(node ${tzc_LIBRARIES})\n"),
      HasSubstr("keyword signature"));
  EXPECT_THAT(prove_cmake("include(cmake/programs.cmake)\ndemo_program(node src/node.cpp)\n"),
              HasSubstr("TZC's headers are in none"));
}

TEST_F(BuildProof, targets_made_in_a_loop) {
  const std::string loop =
      "foreach(name node other)\n  add_executable(${name} src/node.cpp)\n"
      "  target_link_libraries(${name} ${tzc_LIBRARIES})\nendforeach()\n";
  configure(loop);
  EXPECT_EQ(prove_cmake("find_package(tzc REQUIRED)\ninclude_directories(${tzc_INCLUDE_DIRS})\n" + loop), "");
  EXPECT_THAT(prove_cmake("find_package(tzc REQUIRED)\n" + loop +
                          "target_include_directories(node PRIVATE ${tzc_INCLUDE_DIRS})\n"),
              HasSubstr("for the target other"));
}

TEST_F(BuildProof, libraries_are_judged_where_they_are_linked) {
  const std::string object =
      "find_package(tzc REQUIRED)\ninclude_directories(${tzc_INCLUDE_DIRS})\n"
      "add_library(objects OBJECT src/lib.cpp)\nadd_library(archive STATIC src/lib.cpp)\n"
      "add_executable(node src/node.cpp $<TARGET_OBJECTS:objects>)\n";
  configure(plain);
  const std::set<std::string> units = {"src/lib.cpp"};
  EXPECT_THAT(prove({{"CMakeLists.txt", head + object}}, false, units),
              HasSubstr("the target node does not link TZC's libraries"));
  EXPECT_EQ(prove({{"CMakeLists.txt", head + object + "target_link_libraries(node ${tzc_LIBRARIES})\n"}},
                  false, units),
            "");
  const std::string archive =
      "find_package(tzc REQUIRED)\ninclude_directories(${tzc_INCLUDE_DIRS})\n"
      "add_library(archive STATIC src/lib.cpp)\nadd_executable(node src/node.cpp)\n"
      "target_link_libraries(node archive)\n";
  EXPECT_THAT(prove({{"CMakeLists.txt", head + archive}}, false, units),
              HasSubstr("the target node does not link"));
  EXPECT_EQ(prove({{"CMakeLists.txt", head + archive + "target_link_libraries(archive ${tzc_LIBRARIES})\n"}},
                  false, units),
            "");
}

TEST_F(BuildProof, unity_builds_and_precompiled_headers) {
  put("include/pch.h", "#include <vector>\n");
  const std::string more =
      "set_target_properties(node PROPERTIES UNITY_BUILD ON)\n"
      "target_precompile_headers(node PRIVATE include/pch.h)\n";
  configure(plain + more);
  EXPECT_EQ(prove_cmake(with_tzc + more), "");
  EXPECT_THAT(prove_cmake(plain + more), HasSubstr("TZC's headers are in none"));
}

TEST_F(BuildProof, a_unit_that_no_target_compiles_any_more) {
  configure(plain);
  EXPECT_THAT(prove_cmake("find_package(tzc REQUIRED)\nadd_executable(other src/lib.cpp)\n"),
              HasSubstr("src/node.cpp: no target of the configured copy compiles it"));
}

TEST_F(BuildProof, what_cmake_refuses_is_said_in_the_users_paths) {
  configure(plain);
  const std::string why = prove_cmake(with_tzc + "include(missing)\n");
  EXPECT_THAT(why, HasSubstr("CMake Error at CMakeLists.txt"));
  EXPECT_THAT(why, HasSubstr("missing"));
  EXPECT_THAT(why, ::testing::Not(HasSubstr("tzc-rewrite-")));
}

TEST_F(BuildProof, a_workspace_that_cannot_be_configured_without_the_port_either) {
  configure(plain);
  put("CMakeLists.txt", std::string(head) + "include(missing)\n");
  EXPECT_THAT(prove_cmake(with_tzc + "include(missing)\n"), HasSubstr("even without the port"));
}

TEST_F(BuildProof, the_copy_is_built_on_request) {
  configure(plain);
  const std::string own =
      "find_package(tzc REQUIRED)\ninclude_directories(${tzc_INCLUDE_DIRS})\n"
      "add_library(tzc_roscpp SHARED src/lib.cpp)\n" +
      plain + "target_link_libraries(node tzc_roscpp)\n";
  const std::string good = "#include <tzc/ros.h>\nint main() { return tzc_answer(); }\n";
  EXPECT_EQ(prove({{"CMakeLists.txt", head + own}, {"src/node.cpp", good}}, true), "");
  EXPECT_THAT(
      prove({{"CMakeLists.txt", head + own}, {"src/node.cpp", "int lib(int);\nint main() { lib(1); }\n"}},
            true),
      HasSubstr("the build of the scratch copy fails"));
}

TEST_F(BuildProof, what_lies_beside_the_package_is_found) {
  folder.write("common/flags.cmake", "set(COMMON ../common)\n");
  folder.write("common/more.cpp", "#include \"more.h\"\n");
  const std::string use = "include(../common/flags.cmake)\n",
                    more = "target_sources(node PRIVATE ${COMMON}/more.cpp)\n";
  configure(use + plain + more);
  EXPECT_EQ(prove_cmake(use + with_tzc + more), "");
}

TEST_F(BuildProof, no_cache_no_proof) {
  EXPECT_EQ(prove_cmake(with_tzc), "no build");
}

}  // namespace
}  // namespace tzc::rewriter
