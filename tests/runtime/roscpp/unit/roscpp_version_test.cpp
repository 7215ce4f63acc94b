// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/roscpp_version.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/temp_dir.h"

namespace tzc {
namespace detail {
namespace {

constexpr RoscppVersion kDebian12{1, 15, 15};

TEST(RoscppVersion, is_three_numbers) {
  EXPECT_EQ(parse_roscpp_version("1.15.15"), kDebian12);
  EXPECT_EQ(parse_roscpp_version("1.16.0-1focal"), (RoscppVersion{1, 16, 0}));
  for (const char* text : {"", "4d", "1.15", "one.two.three"})
    EXPECT_FALSE(parse_roscpp_version(text)) << text;
}

TEST(RoscppVersion, noetic_ros_o_and_debian_are_known) {
  for (const RoscppVersion version :
       {RoscppVersion{1, 15, 9}, kDebian12, RoscppVersion{1, 16, 0}, RoscppVersion{1, 17, 4}})
    EXPECT_EQ(reason_to_leave_alone(version, version), "");
  EXPECT_EQ(reason_to_leave_alone(kDebian12, RoscppVersion{1, 17, 0}), "");
  EXPECT_EQ(reason_to_leave_alone(kDebian12, std::nullopt), "");
}

TEST(RoscppVersion, older_and_newer_ones_are_not) {
  for (const RoscppVersion version :
       {RoscppVersion{1, 14, 13}, RoscppVersion{1, 15, 8}, RoscppVersion{1, 18, 0}, RoscppVersion{2, 0, 0}}) {
    EXPECT_NE(reason_to_leave_alone(kDebian12, version), "");
    EXPECT_NE(reason_to_leave_alone(version, kDebian12), "");
  }
}

TEST(RoscppVersion, the_reason_names_what_is_there_and_what_is_known) {
  EXPECT_EQ(reason_to_leave_alone(kDebian12, RoscppVersion{1, 18, 2}),
            "it runs on roscpp 1.18.2; this version of TZC knows roscpp 1.15.9 to 1.17");
  EXPECT_EQ(reason_to_leave_alone(RoscppVersion{1, 14, 0}, std::nullopt),
            "TZC was built for roscpp 1.14.0; this version of TZC knows roscpp 1.15.9 to 1.17");
}

class RoscppLibrary : public ::testing::Test {
 protected:
  test::TempDir folder_;
};

TEST_F(RoscppLibrary, says_its_version_in_its_files_name) {
  folder_.write("lib/libroscpp.so.1.15.15", "");
  const std::string link = folder_ / "lib/libroscpp.so.4d";
  std::filesystem::create_symlink("libroscpp.so.1.15.15", link);
  EXPECT_EQ(version_of_library(link), kDebian12);
}

TEST_F(RoscppLibrary, says_its_version_in_its_prefix) {
  const std::string library = folder_.write("lib/libroscpp.so", "");
  EXPECT_FALSE(version_of_library(library));
  folder_.write("share/roscpp/package.xml",
                "<package format=\"2\">\n  <name>roscpp</name>\n  <version>1.16.0</version>\n");
  EXPECT_EQ(version_of_library(library), (RoscppVersion{1, 16, 0}));
  folder_.write("share/roscpp/package.xml",
                "<package>\n  <version compatibility=\"1.0.0\">\n1.17.4</version>\n");
  EXPECT_EQ(version_of_library(library), (RoscppVersion{1, 17, 4}));
}

TEST_F(RoscppLibrary, may_say_nothing) {
  const std::string library = folder_.write("lib/libroscpp.so.4d", "");
  EXPECT_FALSE(version_of_library(library));
  for (const char* text :
       {"", "<version", "<version>", "<version></version>", "<package><name>roscpp</name>"}) {
    folder_.write("share/roscpp/package.xml", text);
    EXPECT_FALSE(version_of_library(library)) << text;
  }
  EXPECT_FALSE(version_of_library(""));
}

}  // namespace
}  // namespace detail
}  // namespace tzc
