// SPDX-License-Identifier: BSD-3-Clause
// The package's compiler judges the text that would be written, as the build would.
#include "proof/own_compiler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "edits/files.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tzc::test::TempDir;

/// A workspace with the package "demo" (one unit) and its compile command.
class OwnCompilerTest : public ::testing::Test {
 protected:
  OwnCompilerTest() {
    put("package.xml", "<package/>");
    put("include/demo/a.h", "#pragma once\ninline int a() { return 1; }\n");
    folder.write("tzc/tzc/ros.h", "inline int tzc_sloppy(int unused) { return 0; }\n");
    flags = "-I" + package() + "/include";
  }

  std::string package() const { return folder / "ws/src/demo"; }
  std::string unit() const { return package() + "/src/node.cpp"; }
  void put(const std::string& name, const std::string& content) const {
    folder.write("ws/src/demo/" + name, content);
  }

  /// What the compiler says about the original with these files in place of its own; "" for none.
  std::string check(const std::map<std::string, std::string>& files) {
    folder.write(build_dir + "/compile_commands.json",
                 json::array({{{"directory", folder / build_dir},
                               {"file", file.empty() ? unit() : file},
                               {"command", compiler + " " + flags + " -MD -MF x.d -o x.o -c " +
                                               (file.empty() ? unit() : file)}}})
                     .dump());
    OwnCompiler compiler({{package()}, folder / "ws/src", {folder / build_dir}, {tzc_headers}, {}, 1});
    FileContents contents;
    for (const auto& [name, content] : files) contents[package() + "/" + name] = content;
    const auto errors = compiler.check(contents, {file.empty() ? unit() : canonical_path(file)});
    if (!errors) return to_string(errors.error());
    std::string text;
    for (const CompilerError& error : *errors)
      text += error.where.file.substr(error.where.file.find("demo")) + ":" +
              std::to_string(error.where.line) + " " + error.text + "\n";
    return text;
  }

  TempDir folder;
  std::string compiler = "g++", flags, file, build_dir = "ws/build", tzc_headers = folder / "tzc";
};

TEST_F(OwnCompilerTest, accepts_what_compiles) {
  put("src/node.cpp", "#include <demo/a.h>\nint main() { return a(); }\n");
  EXPECT_EQ(check({{"include/demo/a.h", "#include <tzc/ros.h>\ninline int a() { return 2; }\n"}}), "");
}

/// What the build made, such as headers of messages, is read where it is; sources are those of the port.
TEST_F(OwnCompilerTest, the_package_may_be_its_own_build_folder) {
  build_dir = "ws/src/demo";
  put("CMakeCache.txt", "");
  put("devel/.catkin", "");
  put("devel/include/demo/made.h", "#include <demo/a.h>\ninline int made() { return a(); }\n");
  flags += " -I" + package() + "/devel/include";  // absolute, as CMake writes them
  put("src/node.cpp", "#include <demo/made.h>\nint main() { return made() + a(); }\n");
  EXPECT_EQ(check({{"include/demo/a.h", "#pragma once\nint a();\n"}}), "");
  EXPECT_THAT(check({{"include/demo/a.h", "#pragma once\nint b();\n"}}),
              HasSubstr("demo/src/node.cpp:2 'a' was not declared"));
}

TEST_F(OwnCompilerTest, names_the_users_file_and_line) {
  put("src/node.cpp", "#include <demo/a.h>\nint main() { return a(); }\n");
  EXPECT_THAT(check({{"include/demo/a.h", "\ninline int a() { return b; }\n"}}),
              HasSubstr("demo/include/demo/a.h:2 'b' was not declared"));
  EXPECT_EQ(read_file(package() + "/include/demo/a.h").operator*(),
            "#pragma once\ninline int a() { return 1; }\n");
}

TEST_F(OwnCompilerTest, may_be_clang) {
  compiler = "clang++-19";
  put("src/node.cpp", "#include <demo/a.h>\nint main() { return a(); }\n");
  EXPECT_EQ(check({{"include/demo/a.h", "#include <tzc/ros.h>\ninline int a() { return 2; }\n"}}), "");
  EXPECT_EQ(check({{"include/demo/a.h", "\ninline int a() { return b; }\n"}}),
            "demo/include/demo/a.h:2 use of undeclared identifier 'b'\n");
}

TEST_F(OwnCompilerTest, sees_the_branch_that_clang_does_not) {
  put("src/node.cpp", "int main() {}\n");
  EXPECT_THAT(check({{"src/node.cpp", "#ifndef __clang__\nint x = y;\n#endif\nint main() {}\n"}}),
              HasSubstr("demo/src/node.cpp:2 'y'"));
}

TEST_F(OwnCompilerTest, keeps_the_flags_of_the_build) {
  put("src/node.cpp", "int main() {}\n");
  const std::map<std::string, std::string> port = {{"src/node.cpp", "int main() { int unused; }\n"}};
  EXPECT_EQ(check(port), "");
  flags += " -Wall -Werror";
  EXPECT_THAT(check(port), HasSubstr("unused variable 'unused'"));
}

TEST_F(OwnCompilerTest, tzc_headers_are_system_headers) {
  put("src/node.cpp", "int main() {}\n");
  flags += " -Wall -Wextra -Werror";
  EXPECT_EQ(check({{"src/node.cpp", "#include <tzc/ros.h>\nint main() {}\n"}}), "");
}

TEST_F(OwnCompilerTest, tzc_may_be_installed_among_the_systems_headers) {
  tzc_headers = "/usr/include";
  put("src/node.cpp", "int main() {}\n");
  EXPECT_EQ(check({{"src/node.cpp", "#include <cstdlib>\nint main() { return std::abs(0); }\n"}}), "");
}

TEST_F(OwnCompilerTest, errors_of_the_original_do_not_count) {
  put("src/node.cpp", "int x = missing;\nint main() {}\n");
  EXPECT_EQ(check({{"src/node.cpp", "// ported\nint x = missing;\nint main() {}\n"}}), "");
  EXPECT_EQ(check({{"src/node.cpp", "int x = missing;\nint main() { return other; }\n"}}),
            "demo/src/node.cpp:2 'other' was not declared in this scope\n");
}

TEST_F(OwnCompilerTest, file_macros_say_what_they_say_in_the_build) {
  const std::string text = "constexpr char name[] = __FILE__;\nstatic_assert(sizeof(name) == " +
                           std::to_string(unit().size() + 1) + ", \"\");\nint main() {}\n";
  put("src/node.cpp", text);
  EXPECT_EQ(check({{"src/node.cpp", text + "// ported\n"}}), "");
}

TEST_F(OwnCompilerTest, absolute_includes_lead_to_the_port) {
  put("src/node.cpp", "#include \"" + package() + "/include/demo/a.h\"\nint main() { return a(); }\n");
  EXPECT_THAT(check({{"include/demo/a.h", "inline void a() {}\n"}}), HasSubstr("node.cpp:2"));
}

TEST_F(OwnCompilerTest, relative_includes_lead_to_the_port_and_to_packages_beside_it) {
  folder.write("ws/src/other/other.h", "inline int other() { return 1; }\n");
  put("src/node.cpp",
      "#include \"../include/demo/a.h\"\n#include \"../../other/other.h\"\n"
      "int main() { return a() + other(); }\n");
  EXPECT_EQ(check({{"include/demo/a.h", "inline int a() { return 3; }\n"}}), "");
  EXPECT_THAT(check({{"include/demo/a.h", "inline void a() {}\n"}}), HasSubstr("node.cpp:3"));
}

TEST_F(OwnCompilerTest, a_package_that_is_linked_into_the_workspace) {
  put("src/node.cpp", "#include <demo/a.h>\nint main() { return a(); }\n");
  fs::rename(package(), folder / "demo");
  fs::create_directory_symlink(folder / "demo", package());
  file = package() + "/src/node.cpp";
  OwnCompilerTest::check({});
  OwnCompiler compiler({{folder / "demo"}, folder / "ws/src", {folder / "ws/build"}, {}, {}, 1});
  const auto errors = compiler.check({{folder / "demo/include/demo/a.h", "inline void a() {}\n"}},
                                     {folder / "demo/src/node.cpp"});
  ASSERT_TRUE(errors);
  ASSERT_EQ(errors->size(), 1u);
  EXPECT_EQ((*errors)[0].where.file, folder / "demo/src/node.cpp");
}

TEST_F(OwnCompilerTest, what_the_command_includes_is_found_as_the_compiler_finds_it) {
  put("src/node.cpp", "int main() { return a() + std::abs(0); }\n");
  flags += " -include cstdlib -include demo/a.h";  // of the system, and by way of -I
  EXPECT_EQ(check({{"src/node.cpp", "// ported\nint main() { return a() + std::abs(0); }\n"}}), "");
  EXPECT_THAT(check({{"include/demo/a.h", "inline void a() {}\n"}}), HasSubstr("node.cpp:1"));
}

TEST_F(OwnCompilerTest, what_the_command_includes_is_looked_for_where_the_compiler_runs_first) {
  put("src/node.cpp", "int main() { return a() + b; }\n");
  folder.write("ws/build/demo/a.h", "#include \"" + package() + "/include/demo/a.h\"\nconst int b = 0;\n");
  flags += " -include demo/a.h";
  EXPECT_EQ(check({{"src/node.cpp", "// ported\nint main() { return a() + b; }\n"}}), "");
  EXPECT_THAT(check({{"include/demo/a.h", "inline void a() {}\n"}}), HasSubstr("node.cpp:1"));
}

TEST_F(OwnCompilerTest, a_precompiled_header_is_read_as_text) {
  put("src/node.cpp", "int main() { return a(); }\n");
  const std::string pch =
      folder.write("ws/build/cmake_pch.hxx", "#include \"" + package() + "/include/demo/a.h\"\n");
  ASSERT_EQ(std::system(("g++ -x c++-header " + pch + " -o " + pch + ".gch").c_str()), 0);
  flags += " -Winvalid-pch -include " + pch;
  EXPECT_EQ(check({{"src/node.cpp", "// ported\nint main() { return a(); }\n"}}), "");
  EXPECT_THAT(check({{"include/demo/a.h", "inline void a() {}\n"}}), HasSubstr("node.cpp:1"));
}

TEST_F(OwnCompilerTest, a_unity_build) {
  put("src/node.cpp", "#include <demo/a.h>\nint main() { return a(); }\n");
  file = folder.write("ws/build/demo/Unity/unity_0_cxx.cxx", "#include \"" + unit() + "\"\n");
  EXPECT_EQ(check({{"src/node.cpp", "#include <demo/a.h>\nint main() { return a() + 1; }\n"}}), "");
  EXPECT_THAT(check({{"include/demo/a.h", "inline void a() {}\n"}}), HasSubstr("demo/src/node.cpp:2"));
}

TEST_F(OwnCompilerTest, an_old_standard_is_raised_as_in_the_build_files) {
  put("src/node.cpp", "int main() {}\n");
  const std::string none = flags;
  for (const char* standard : {"-std=c++11", "--std=c++11"}) {
    flags = none + " " + standard + " -pedantic-errors";
    EXPECT_EQ(check({{"src/node.cpp", "auto f = [](auto x) { return x; };\nint main() {}\n"}}), "")
        << standard;
  }
}

TEST_F(OwnCompilerTest, a_second_check_has_no_text_of_the_first) {
  put("src/node.cpp", "#include <demo/a.h>\nint main() { return a(); }\n");
  check({});
  OwnCompiler compiler({{package()}, folder / "ws/src", {folder / "ws/build"}, {}, {}, 1});
  const FileContents broken = {{package() + "/include/demo/a.h", "inline void a() {}\n"}};
  EXPECT_THAT(*compiler.check(broken, {unit()}), ::testing::SizeIs(1));
  EXPECT_THAT(*compiler.check({}, {unit()}), IsEmpty());
}

TEST_F(OwnCompilerTest, a_compiler_that_is_not_there) {
  put("src/node.cpp", "int main() {}\n");
  compiler = "/nonexistent/g++";
  EXPECT_EQ(check({{"src/node.cpp", "int main() { }\n"}}), "") << "the original fails, too";
}

TEST_F(OwnCompilerTest, the_original_alone) {
  put("src/node.cpp", "#include \"generated.h\"\nint main() {}\n");
  check({});
  OwnCompiler compiler({{package()}, folder / "ws/src", {folder / "ws/build"}, {}, {}, 1});
  const auto errors = compiler.errors_of_original(unit());
  ASSERT_TRUE(errors);
  ASSERT_EQ(errors->size(), 1u);
  EXPECT_THAT((*errors)[0].text, HasSubstr("generated.h"));
}

}  // namespace
}  // namespace tzc::rewriter
