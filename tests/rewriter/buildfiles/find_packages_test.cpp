// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/find_packages.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;

TEST(PackagesOfAFolder, are_found_behind_links_as_catkin_finds_them) {
  const tzc::test::TempDir folder;
  for (const char* package :
       {"ws/src/own", "git/robot/drivers/camera", "git/robot/deep/in/it/tool", "git/alone",
        "git/robot/ignored", "ws/install/share/own", "far/away/in/the/disk"})
    folder.write(std::string(package) + "/package.xml", "");
  folder.write("git/robot/ignored/CATKIN_IGNORE", "");
  const auto link = [&](const std::string& to, const std::string& at) {
    fs::create_symlink(folder / to, folder / at);
  };
  link("git/robot", "ws/src/robot");
  link("git/robot", "ws/src/again");
  link("git/alone", "ws/src/alone");
  link("ws", "ws/src/circle");
  link("", "ws/src/all");
  link("ws/src", "git/robot/back");
  link("nowhere", "ws/src/broken");
  const Expected<std::vector<std::string>> packages = find_packages_at(folder / "ws/src");
  ASSERT_TRUE(packages);
  std::string found;
  for (const std::string& package : *packages) found += package.substr(folder.path().size()) + " ";
  EXPECT_EQ(found, "/git/alone /git/robot/drivers/camera /ws/src/own ");
}

}  // namespace
}  // namespace tzc::rewriter
