// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/header_users.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "other_code/unseen_files.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A workspace with the package `lib`, whose include/lib/api.h and include/lib/detail.h are exported.
class HeaderUsers : public ::testing::Test {
 protected:
  HeaderUsers() {
    folder.write("ws/src/lib/include/lib/api.h", "void api();\n");
    folder.write("ws/src/lib/include/lib/detail.h", "void detail();\n");
    folder.write("ws/src/lib/src/lib.cpp", "#include <lib/api.h>\n#include <lib/detail.h>\n");
  }
  std::string in_use() const { return in_use({{folder / "ws"}, {}}); }
  /// "api.h detail.h "
  std::string in_use(const SearchedFolders& searched, const std::vector<Inclusion>& known = {}) const {
    std::string names;
    for (const auto& item : headers_in_use(folder / "ws/src/lib", searched, known))
      names += fs::path(item.first).filename().string() + " ";
    return names;
  }

  tzc::test::TempDir folder;
};

TEST_F(HeaderUsers, the_package_itself_is_no_user) {
  EXPECT_EQ(in_use(), "");
}

TEST_F(HeaderUsers, another_package_is) {
  folder.write("ws/src/node/main.cpp", "  #  include <lib/api.h>  // why\n");
  EXPECT_EQ(in_use(), "api.h ");
}

TEST_F(HeaderUsers, a_compiler_may_read_what_units_include_and_nothing_else) {
  folder.write("ws/src/lib/include/lib/api.h", "#include \"detail.h\"\n");
  folder.write("ws/src/lib/src/lib.cpp", "#include <lib/api.h>\n");
  folder.write("ws/src/lib/test/never.cpp", "#include <lib/api.h>\n");
  const std::string unit = folder / "ws/src/lib/src/lib.cpp", include = folder / "ws/src/lib/include/lib/";
  EXPECT_THAT(reached_by_includes({folder / "ws/src/lib"}, {unit}),
              ElementsAre(include + "api.h", include + "detail.h", unit));
}

TEST_F(HeaderUsers, what_a_used_header_includes_is_in_use_too) {
  folder.write("ws/src/lib/include/lib/api.h", "#include \"detail.h\"\n");
  folder.write("ws/src/node/main.cpp", "#include \"lib/api.h\"\n");
  EXPECT_EQ(in_use(), "api.h detail.h ");
}

TEST_F(HeaderUsers, through_a_header_that_is_not_exported_too) {
  folder.write("ws/src/lib/include/lib/api.h", "#include <hidden.h>\n");
  folder.write("ws/src/lib/private/hidden.h", "#include <lib/detail.h>\n");
  folder.write("ws/src/node/main.cpp", "#include \"lib/api.h\"\n");
  EXPECT_EQ(in_use(), "api.h detail.h hidden.h ");
}

TEST_F(HeaderUsers, a_path_that_leaves_its_folder_counts) {
  folder.write("ws/src/node/main.cpp", "#include \"../lib/include/lib/api.h\"\n");
  EXPECT_EQ(in_use(), "api.h ");
}

TEST_F(HeaderUsers, a_name_without_a_folder_may_mean_the_header) {
  folder.write("ws/src/node/main.cpp", "#include <api.h>\n");
  EXPECT_EQ(in_use(), "api.h ");
}

/// The package that includes <detail.h>, and the one whose header that may be, know each other's folders by CMake files only.
class IncludeFolder : public HeaderUsers {
 protected:
  IncludeFolder() {
    folder.write("ws/src/lib/package.xml", "<package><name>lib</name></package>");
    folder.write("ws/src/lib/include/lib/parts/detail.h", "");
    folder.write("ws/src/node/package.xml", "<package><name>node</name></package>");
    folder.write("ws/src/node/main.cpp", "#include <detail.h>\n");
    lib_says("catkin_package(INCLUDE_DIRS include)\nadd_library(lib src/parts/detail.cpp)\n");
    node_says("add_executable(node main.cpp)\n");
    fs::remove(folder / "ws/src/lib/include/lib/detail.h");
  }
  void lib_says(const std::string& text) { folder.write("ws/src/lib/CMakeLists.txt", text); }
  void node_says(const std::string& text) { folder.write("ws/src/node/CMakeLists.txt", text); }
};

TEST_F(IncludeFolder, that_no_cmake_file_names_does_not_serve_other_packages) {
  EXPECT_EQ(in_use(), "");
  node_says("include_directories(include/node/parts)\n");
  EXPECT_EQ(in_use(), "") << "its own folder of that name";
  lib_says("find_path(x y.h PATH_SUFFIXES z)\nfind_package(PCL COMPONENTS parts)\n");
  EXPECT_EQ(in_use(), "") << "another thing of that name";
  folder.write("ws/src/node/main.cpp", "#include <lib/parts/detail.h>\n");
  EXPECT_EQ(in_use(), "detail.h ");
}

TEST_F(IncludeFolder, that_its_package_names_does) {
  for (const char* text :
       {"catkin_package(INCLUDE_DIRS include include/lib/parts)\n",
        "catkin_package(INCLUDE_DIRS include include/${PROJECT_NAME}/parts/)\n",
        "target_include_directories(lib PUBLIC $<BUILD_INTERFACE:${X}/parts>)\n",
        "foreach(name parts others)\ninclude_directories(include/lib/${name})\nendforeach()\n",
        "file(GLOB folders include/lib/*)\ninclude_directories(${folders})\n"}) {
    lib_says(text);
    EXPECT_EQ(in_use(), "detail.h ") << text;
  }
}

TEST_F(IncludeFolder, that_the_users_package_names_does) {
  for (const char* text : {"include_directories(../lib/include/lib/parts)\n",
                           "include_directories(${lib_SOURCE_DIR}/include/lib/parts)\n",
                           "find_path(folder detail.h PATHS ${lib}/include/lib PATH_SUFFIXES parts)\n",
                           "include_directories(${lib_folder}/parts)\n",
                           "file(GLOB folders ../lib/include/lib/*)\ninclude_directories(${folders})\n"}) {
    node_says(text);
    EXPECT_EQ(in_use(), "detail.h ") << text;
  }
}

TEST_F(IncludeFolder, that_an_included_cmake_file_of_any_name_names_does) {
  for (const char* name : {"CMakeLists_ros1.txt", "folders.inc"}) {
    const std::string file =
        folder.write(std::string("ws/src/lib/") + name, "catkin_package(INCLUDE_DIRS include/lib/parts)\n");
    lib_says(std::string("include(") + name + ")\n");
    EXPECT_EQ(in_use(), "detail.h ") << name;
    fs::remove(file);
  }
}

TEST_F(IncludeFolder, of_its_own_package_serves_always) {
  folder.write("ws/src/lib/include/lib/api.h", "#include <detail.h>\n");
  folder.write("ws/src/node/main.cpp", "#include <lib/api.h>\n");
  EXPECT_EQ(in_use(), "api.h detail.h ");
}

TEST_F(IncludeFolder, that_nobody_can_tell_does) {
  fs::remove(folder / "ws/src/node/package.xml");
  EXPECT_EQ(in_use(), "detail.h ") << "a file in no package";
}

TEST_F(HeaderUsers, a_file_beside_the_directive_is_meant_first) {
  folder.write("ws/src/node/api.h", "");
  folder.write("ws/src/node/main.cpp", "#include \"api.h\"\n");
  EXPECT_EQ(in_use(), "");
  folder.write("ws/src/node/other.cpp", "#include <api.h>\n");
  EXPECT_EQ(in_use(), "api.h ") << "an angled name does not mean it";
}

TEST_F(HeaderUsers, a_branch_that_is_not_compiled_counts) {
  folder.write("ws/src/node/main.cpp", "#ifdef WITH_LIB\n#include <lib/api.h>\n#endif\n");
  EXPECT_EQ(in_use(), "api.h ");
}

TEST_F(HeaderUsers, another_header_of_the_same_name_does_not) {
  folder.write("ws/src/node/main.cpp", "#include <other/api.h>\n#include <notlib/api.h>\n");
  EXPECT_EQ(in_use(), "");
}

TEST_F(HeaderUsers, packages_behind_symbolic_links_are_searched_once) {
  folder.write("elsewhere/main.cpp", "#include <lib/api.h>\n");
  fs::create_directory_symlink(folder / "elsewhere", folder / "ws/src/node");
  fs::create_directory_symlink(folder / "ws", folder / "ws/src/circle");
  EXPECT_EQ(in_use(), "api.h ");
}

TEST_F(HeaderUsers, a_header_may_be_found_through_links) {
  folder.write("ws/src/lib/src/impl.h", "void impl();\n");
  fs::create_directory_symlink("../src", folder / "ws/src/lib/include/inner");
  fs::create_symlink("../../src/impl.h", folder / "ws/src/lib/include/lib/linked.h");
  for (const char* name : {"<inner/impl.h>", "<lib/linked.h>", "\"../lib/include/inner/impl.h\""}) {
    folder.write("ws/src/node/main.cpp", std::string("#include ") + name + "\n");
    EXPECT_EQ(in_use(), "impl.h ") << name;
  }
}

TEST_F(HeaderUsers, what_is_compiled_is_code_whatever_it_is_called) {
  const std::string file = folder.write("ws/src/lib/src/other.impl", "#include <lib/api.h>\n"),
                    unit = folder / "ws/src/lib/src/lib.cpp";
  const FolderSet packages(folder / "ws/src/lib");
  IncludeGraph graph(packages);
  EXPECT_TRUE(unseen_files(graph, packages, {{unit, {unit}}}).empty());
  graph.add_compiled(file);
  const std::vector<UnseenFile> found = unseen_files(graph, packages, {{unit, {unit}}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].file, file);
}

TEST_F(HeaderUsers, whatever_a_file_is_called) {
  folder.write("ws/src/lib/include/lib/Api", "#include \"api.h\"\n");
  const std::map<std::string, std::string> users = {
      {"main.cpp.template", "#include <lib/Api>\n"},
      {"other.tpp", "#include <lib/Api>\n"},
      {"CMakeLists.txt", "target_precompile_headers(node PRIVATE\n  \"own.h\" <lib/Api>)\n"}};
  for (const auto& [name, text] : users) {
    const std::string file = folder.write("ws/src/node/" + name, text);
    EXPECT_EQ(in_use(), "Api api.h ") << name;
    fs::remove(file);
    EXPECT_EQ(in_use(), "") << name;
  }
}

TEST_F(HeaderUsers, data_is_not_searched_but_a_package_in_which_somebody_ran_cmake_is) {
  folder.write("ws/src/node/CMakeCache.txt", "");
  folder.write("ws/src/node/package.xml", "");
  folder.write("ws/src/node/map.bin", std::string(1, '\0') + "\n#include <lib/detail.h>\n");
  folder.write("ws/src/node/main.cpp", "#include <lib/api.h>\n");
  EXPECT_EQ(in_use(), "api.h ");
}

TEST_F(HeaderUsers, a_workspace_that_is_built_in_its_source_folder_is_searched) {
  folder.write("ws/src/CMakeCache.txt", "");
  folder.write("ws/src/CMakeLists.txt", "");
  folder.write("ws/src/node/main.cpp", "#include <lib/api.h>\n");
  EXPECT_EQ(in_use(), "api.h ");
}

TEST_F(HeaderUsers, build_folders_are_not_searched) {
  folder.write("ws/build/CMakeCache.txt", "");
  folder.write("ws/build/unity.cxx", "#include \"/x/lib/api.h\"\n");
  EXPECT_EQ(in_use(), "");
}

TEST_F(HeaderUsers, installed_packages_that_depend_on_it_are_searched) {
  folder.write("opt/share/user/package.xml",
               "<package>\n <build_export_depend> lib </build_export_depend>\n</package>");
  folder.write("opt/share/stranger/package.xml", "<package><name>lib</name><depend>lib2</depend></package>");
  folder.write("opt/include/user/user.h", "#include <lib/api.h>\n");
  folder.write("opt/include/stranger/stranger.h", "#include <lib/detail.h>\n");
  EXPECT_EQ(in_use(folders_of_users({"lib"}, folder / "ws", {}, {folder / "opt/share"})), "api.h ");
}

TEST_F(HeaderUsers, an_installed_package_is_not_if_its_sources_are_named) {
  for (const char* name : {"lib", "user"}) {
    const std::string manifest =
        std::string("<package><name>") + name + "</name><depend>lib</depend></package>";
    folder.write("ws/src/" + std::string(name) + "/package.xml", manifest);
    folder.write("opt/share/" + std::string(name) + "/package.xml", manifest);
  }
  folder.write("opt/include/lib/old.h", "#include <lib/detail.h>\n");
  folder.write("opt/include/user/user.h", "#include <lib/api.h>\n");
  const auto in_use_if_named = [&](const std::vector<std::string>& named) {
    return in_use(folders_of_users({"lib"}, folder / "ws", named, {folder / "opt/share"}));
  };
  EXPECT_EQ(in_use_if_named({folder / "ws/src/lib"}), "api.h ") << "user is installed, and stays";
  EXPECT_EQ(in_use_if_named({folder / "ws/src"}), "");
}

TEST_F(HeaderUsers, workspaces_below_are_searched) {
  folder.write("under/devel/.catkin", (folder / "under/src") + ";" + (folder / "gone"));
  folder.write("under/src/node/main.cpp", "#include <lib/detail.h>\n");
  fs::create_directories(folder / "under/devel/share");
  EXPECT_EQ(in_use(folders_of_users({"lib"}, folder / "ws", {}, {folder / "under/devel/share"})),
            "detail.h ");
}

TEST_F(HeaderUsers, tzc_in_a_workspace_below_is_not) {
  folder.write("under/devel/.catkin", folder / "under/src");
  folder.write("under/src/tzc/package.xml", "<package><name>tzc</name></package>");
  folder.write("under/src/tzc/tests/pcl.cpp", "#include <lib/detail.h>\n");
  folder.write("under/src/node/main.cpp", "#include <lib/api.h>\n");
  fs::create_directories(folder / "under/devel/share");
  EXPECT_EQ(in_use(folders_of_users({"lib"}, folder / "ws", {}, {folder / "under/devel/share"})), "api.h ");
}

TEST_F(HeaderUsers, a_package_of_a_workspace_below_is_not_if_other_sources_of_it_are_named) {
  for (const char* place : {"ws/src/lib", "under/src/lib"})
    folder.write(std::string(place) + "/package.xml", "<package><name>lib</name></package>");
  folder.write("under/devel/.catkin", (folder / "under/src"));
  folder.write("under/src/lib/lib.cpp", "#include <lib/detail.h>\n");
  folder.write("under/src/node/main.cpp", "#include <lib/api.h>\n");
  fs::create_directories(folder / "under/devel/share");
  const auto in_use_if_named = [&](const std::string& named) {
    return in_use(folders_of_users({"lib"}, folder / "ws", {named}, {folder / "under/devel/share"}));
  };
  EXPECT_EQ(in_use_if_named(folder / "ws/src/lib"), "api.h ");
  EXPECT_EQ(in_use_if_named(folder / "under/src/lib"), "api.h detail.h ")
      << "named itself: it is another set's";
}

TEST_F(HeaderUsers, the_note_names_what_stays_and_who_uses_it) {
  folder.write("ws/src/node/main.cpp", "#include <lib/api.h>\n");
  const std::string package = folder / "ws/src/lib";
  const Note note = note_on_users(package, headers_in_use(package, {{folder / "ws"}, {}}));
  EXPECT_THAT(note.text, HasSubstr("stay: include/lib/api.h (by " + (folder / "ws/src/node/main.cpp") + ")"));
  EXPECT_THAT(note_on_users(package, {}).text, HasSubstr("none of them includes one"));
}

TEST_F(HeaderUsers, sites_that_wait_for_a_header_are_counted_for_the_one_who_keeps_them) {
  Report report;
  report.package_dir = "/ws/src/lib";
  report.sites.resize(2);
  EXPECT_FALSE(note_on_kept_headers(report));
  report.sites[1].in_exported_header = true;
  const std::optional<Note> note = note_on_kept_headers(report);
  ASSERT_TRUE(note);
  EXPECT_EQ(note->code, "TZC1005");
  EXPECT_THAT(note->text, HasSubstr("1 site waits for headers that other packages may include"));
  EXPECT_THAT(note->text, HasSubstr("--exported-headers=change"));
  report.sites[0].in_exported_header = true;
  EXPECT_THAT(note_on_kept_headers(report)->text, HasSubstr("2 sites wait for"));
}

TEST_F(HeaderUsers, an_inclusion_that_is_known_counts_like_one_from_outside) {
  folder.write("ws/src/lib/include/lib/api.h", "#include \"detail.h\"\n");
  EXPECT_EQ(in_use({}, {{folder / "ws/src/node/old.cpp", folder / "ws/src/lib/include/lib/api.h"}}),
            "api.h detail.h ");
}

TEST_F(HeaderUsers, packages_that_include_headers_of_each_other_belong_together) {
  folder.write("ws/src/node/main.cpp", "#include <lib/api.h>\n");
  folder.write("ws/src/more/more.cpp", "#include <node/node.h>\n");
  folder.write("ws/src/node/include/node/node.h", "");
  folder.write("ws/src/other/other.cpp", "#include <vector>\n");
  std::vector<std::string> packages;
  for (const char* name : {"lib", "more", "node", "other"}) packages.push_back((folder / "ws/src/") + name);
  const auto sets = joined_by_headers(packages);
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(sets[0], (std::vector<std::string>{packages[0], packages[1], packages[2]}));
  EXPECT_EQ(sets[1], std::vector<std::string>{packages[3]});
  EXPECT_EQ(inclusions_between(packages).size(), 2u);
}

TEST_F(HeaderUsers, a_package_is_no_user_of_those_that_are_solved_with_it) {
  folder.write("ws/src/node/main.cpp", "#include <lib/api.h>\n");
  folder.write("ws/src/other/main.cpp", "#include <lib/detail.h>\n");
  const FolderSet packages({folder / "ws/src/lib", folder / "ws/src/node"});
  const auto users = headers_in_use(packages, {{folder / "ws"}, {}});
  ASSERT_EQ(users.size(), 1u);
  EXPECT_EQ(users.begin()->second, folder / "ws/src/other/main.cpp");
  EXPECT_THAT(note_on_users(folder / "ws/src/lib", users, {"node"}).text,
              HasSubstr("as one with it: node; these"));
}

}  // namespace
}  // namespace tzc::rewriter
