// SPDX-License-Identifier: BSD-3-Clause
// Which files of a package are its sources, and which of them were not read.
#include <gtest/gtest.h>

#include <filesystem>

#include "buildfiles/build_trees.h"
#include "buildfiles/unread_files.h"
#include "edits/files.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;

const char* const site = "\n  publisher.publish(message);\n";

class PackageFiles : public ::testing::Test {
 protected:
  PackageFiles() { write({"demo/CMakeLists.txt", "demo/src/a.cpp"}); }
  void write(const std::vector<std::string>& files) const {
    for (const std::string& file : files) folder.write(file, site);
  }
  bool is_generated(const std::string& file, const std::string& build_dir) const {
    return generated_folders(folder / build_dir, folder / "demo").hold(folder / ("demo/" + file));
  }
  /// "FILE: TEXT" of each note, when these files were read.
  std::string unread(const std::set<std::string>& read) const {
    const FolderSet generated = generated_folders("", folder / "demo");
    std::set<std::string> paths;
    for (const std::string& file : read) paths.insert(canonical_path(folder / ("demo/" + file)));
    std::string text;
    for (const auto& notes : {unread_sources(folder / "demo", generated, paths),
                              unread_headers(folder / "demo", generated, paths)})
      for (const Note& note : notes)
        text += note.where->file.substr((folder / "demo/").size()) + ": " + note.text + "\n";
    return text;
  }
  tzc::test::TempDir folder;
};

const char* const by_no_target = ": no target of this configuration compiles this file\n";
const char* const outside = ": this link leads to a file outside of the package, which was not looked at\n";
const char* const in_line_2 =
    ": no unit of the package that was read includes this header; possible sites in lines 2\n";

TEST_F(PackageFiles, a_build_folder_holds_no_sources_unless_it_is_the_packages_or_above) {
  for (const char* build : {"demo/build", "demo/../demo/build"}) {
    EXPECT_FALSE(builds_in_source(folder / build, folder / "demo"));
    EXPECT_FALSE(is_generated("src/a.cpp", build));
  }
  EXPECT_TRUE(is_generated("build/x.cpp", "demo/build"));
  for (const char* build : {"demo", "."}) {
    EXPECT_TRUE(builds_in_source(folder / build, folder / "demo"));
    EXPECT_FALSE(is_generated("src/a.cpp", build));
  }
}

TEST_F(PackageFiles, what_cmake_and_catkin_make_is_no_source_wherever_the_build_is) {
  write({"demo/CMakeFiles/3.25/x.cpp", "demo/node_autogen/moc.cpp", "demo/CMakeFiles/node_autogen.dir/x",
         "demo/catkin_generated/x.h", "demo/devel/.catkin", "demo/devel/include/x.h",
         "demo/build2/CMakeCache.txt", "demo/build2/x.cpp"});
  write({"demo/my_autogen/x.cpp", "demo/development/x.cpp", "demo/part/CMakeCache.txt",
         "demo/part/CMakeLists.txt", "demo/part/x.cpp"});
  for (const char* build : {"demo", "build"}) {
    for (const char* file : {"CMakeFiles/3.25/x.cpp", "node_autogen/moc.cpp", "catkin_generated/x.h",
                             "devel/include/x.h", "build2/x.cpp"})
      EXPECT_TRUE(is_generated(file, build)) << file;
    for (const char* file : {"my_autogen/x.cpp", "development/x.cpp", "part/x.cpp"})
      EXPECT_FALSE(is_generated(file, build)) << file;
  }
}

TEST_F(PackageFiles, what_a_target_compiles_from_elsewhere_is_named) {
  write({"demo/src/read.cpp", "shared/common.cpp", "shared/read.cpp", "build/demo/made.cpp",
         "other/src/b.cpp"});
  folder.write("build/demo/plain.cpp", "int number;\n");
  std::string entries;
  const auto add = [&](const std::string& target_dir, const std::string& file) {
    entries += (entries.empty() ? "" : ",") + std::string(R"({"directory":")") + (folder / "build") +
               R"(","file":")" + (folder / file) + R"(","output":")" + target_dir +
               R"(/CMakeFiles/node.dir/x.o","command":"c++"})";
  };
  for (const char* file : {"demo/src/a.cpp", "shared/common.cpp", "shared/read.cpp", "build/demo/made.cpp",
                           "build/demo/plain.cpp"})
    add("demo", file);
  add("other", "other/src/b.cpp");
  folder.write("build/compile_commands.json", "[" + entries + "]");
  std::string text;
  for (const Note& note : unread_compiled(folder / "demo", folder / "build",
                                          generated_folders(folder / "build", folder / "demo"),
                                          {canonical_path(folder / "shared/read.cpp")}))
    text += note.where->file + ": " + note.text + "\n";
  const std::string
      begin = folder / "demo/CMakeLists.txt: a target compiles ",
      end =
          ", which is generated or lies outside of the package, and was not looked at; possible "
          "sites in lines 2\n";
  EXPECT_EQ(text,
            begin + (folder / "build/demo/made.cpp") + end + begin + (folder / "shared/common.cpp") + end);
}

TEST_F(PackageFiles, so_is_what_a_target_compiles_that_has_no_file_of_the_package) {
  write({"demo/CMakeLists.txt", "other/src/b.cpp", "other/src/c.cpp"});
  const auto entry = [&](const std::string& target_dir, const std::string& file) {
    return std::string(R"({"directory":")") + (folder / "build") + R"(","file":")" + (folder / file) +
           R"(","output":")" + target_dir + R"(/CMakeFiles/node.dir/x.o","command":"c++"})";
  };
  folder.write("build/compile_commands.json",
               "[" + entry("demo", "other/src/b.cpp") + "," + entry("other", "other/src/c.cpp") + "]");
  const auto notes = [&] { return unread_compiled(folder / "demo", folder / "build", FolderSet(), {}); };
  EXPECT_TRUE(notes().empty());
  folder.write("build/CMakeCache.txt", "demo_BINARY_DIR:STATIC=" + (folder / "build/demo") +
                                           "\ndemo_SOURCE_DIR:STATIC=" + (folder / "demo") + "\n");
  ASSERT_EQ(notes().size(), 1u);
  EXPECT_NE(notes()[0].text.find("a target compiles " + (folder / "other/src/b.cpp")), std::string::npos);
}

/// CMake compiles it as C++ if its LANGUAGE is CXX.
TEST_F(PackageFiles, what_a_target_compiles_under_another_name_is_named) {
  write({"demo/src/node.impl", "demo/src/read.impl", "demo/src/driver.c"});
  folder.write("demo/src/plain.impl", "int number;\n");
  std::string entries;
  const auto add = [&](const std::string& compiler, const std::string& file) {
    entries += (entries.empty() ? "" : ",") + std::string(R"({"directory":")") + (folder / "build") +
               R"(","file":")" + (folder / file) + R"(","command":")" + compiler + " -c " + (folder / file) +
               R"("})";
  };
  for (const char* name : {"node", "read", "plain"})
    add("/usr/bin/c++ -O2", std::string("demo/src/") + name + ".impl");
  add("cc", "demo/src/driver.c");
  folder.write("build/compile_commands.json", "[" + entries + "]");
  const std::vector<Note> notes = unread_compiled(folder / "demo", folder / "build", FolderSet(),
                                                  {canonical_path(folder / "demo/src/read.impl")});
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].where->file, folder / "demo/src/node.impl");
  EXPECT_EQ(notes[0].text,
            "a target compiles this file as C++, and it was not looked at because its name is none of a C++ "
            "source; possible sites in lines 2");
}

TEST_F(PackageFiles, a_copy_does_without_the_build) {
  write({"demo/CMakeCache.txt", "demo/CMakeFiles/x.cpp"});
  EXPECT_EQ(build_paths(folder / "build", {folder / "demo"}), std::vector<std::string>{folder / "build"});
  EXPECT_EQ(build_paths(folder / "demo", {folder / "demo"}),
            (std::vector<std::string>{folder / "demo/CMakeFiles", folder / "demo/CMakeCache.txt"}));
}

TEST_F(PackageFiles, sources_that_no_target_compiles) {
  write({"demo/src/b.cc", "demo/src/c.CPP", "demo/CMakeFiles/x.cpp", "demo/.hidden/x.cpp",
         "demo/src/notes.txt"});
  EXPECT_EQ(unread({"src/a.cpp"}), std::string("src/b.cc") + by_no_target + "src/c.CPP" + by_no_target);
  EXPECT_EQ(unread({"src/a.cpp", "src/b.cc", "src/c.CPP"}), "");
}

TEST_F(PackageFiles, cuda_with_possible_sites) {
  write({"demo/src/kernel.cu", "demo/src/kernel.cuh"});
  folder.write("demo/src/other.cu", "__global__ void run();\n");
  EXPECT_EQ(unread({"src/a.cpp"}),
            std::string("src/kernel.cu: CUDA is not analysed; possible sites in lines 2\nsrc/kernel.cuh") +
                in_line_2);
}

/// A link is the file that it leads to.
TEST_F(PackageFiles, links) {
  write({"elsewhere/x.cpp", "elsewhere/x.hpp"});
  fs::create_symlink("a.cpp", folder / "demo/src/alias.cpp");
  EXPECT_EQ(unread({"src/a.cpp"}), "");
  EXPECT_EQ(unread({}), std::string("src/a.cpp") + by_no_target);
  fs::create_symlink(folder / "elsewhere/x.cpp", folder / "demo/src/x.cpp");
  fs::create_symlink(folder / "elsewhere/x.hpp", folder / "demo/src/x.hpp");
  EXPECT_EQ(unread({"src/a.cpp"}), std::string("src/x.cpp") + outside + "src/x.hpp" + in_line_2);
  EXPECT_EQ(unread({"src/a.cpp", "../elsewhere/x.cpp"}).find("x.cpp"), std::string::npos)
      << "of another package";
}

TEST_F(PackageFiles, headers_with_possible_sites_whatever_they_are_called) {
  for (const char* name :
       {"x.h", "x.hh", "x.hpp", "x.hxx", "x.icc", "x.inc", "x.inl", "x.ipp", "x.tcc", "x.tpp", "x.txx"}) {
    const std::string file = folder.write(std::string("demo/include/") + name, site);
    EXPECT_EQ(unread({"src/a.cpp"}), std::string("include/") + name + in_line_2);
    EXPECT_EQ(unread({"src/a.cpp", std::string("include/") + name}), "");
    fs::remove(file);
  }
}

TEST_F(PackageFiles, headers_without_sites_need_no_note) {
  folder.write("demo/include/x.h",
               "/**\n * publish(message) is called\n */\n// advertise<M>(name)\nint publisher;\n");
  EXPECT_EQ(unread({"src/a.cpp"}), "");
}

TEST_F(PackageFiles, lines_that_look_like_a_site) {
  const std::string file =
      folder.write("x.h",
                   "publisher.publish(message);\n\nnh.advertise<M>(\"a\", 1);\n"
                   "it.advertiseCamera(\"b\", 1);\nnh.subscribe (\"c\");\nunpublished();\n");
  EXPECT_EQ(lines_with_sites(file), "1, 3, 4, 5");
  EXPECT_EQ(lines_with_sites(folder / "absent.h"), "");
}

}  // namespace
}  // namespace tzc::rewriter
