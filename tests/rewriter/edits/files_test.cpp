// SPDX-License-Identifier: BSD-3-Clause
// Which files of a package may not change while it is analysed.
#include "edits/files.h"

#include <gtest/gtest.h>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

class SnapshotTest : public ::testing::Test {
 protected:
  SnapshotTest() {
    for (const char* file : {"CMakeLists_ros1.txt", "run.log", "src/node.cpp", "src/node.impl"})
      package.write(file, "before");
  }
  /// Of which the analysis has read these files.
  Snapshot read(const std::set<std::string>& files) const {
    std::set<std::string> paths;
    for (const std::string& file : files) paths.insert(package / file);
    return of_read_files(snapshot(package.path()), paths);
  }
  /// The file that has changed; empty: none has.
  std::string changed_since(const Snapshot& before) const {
    const Expected<void> same = check_unchanged(package.path(), before);
    return same ? "" : same.error().where.substr(package.path().size() + 1);
  }
  tzc::test::TempDir package;
};

TEST_F(SnapshotTest, holds_text_whatever_it_is_called) {
  package.write("map.pgm", std::string("P5") + '\0');
  package.write(".git/config", "");
  std::string names;
  for (const auto& item : snapshot(package.path()))
    names += item.first.substr(package.path().size() + 1) + " ";
  EXPECT_EQ(names, "CMakeLists_ros1.txt run.log src/node.cpp src/node.impl ");
}

TEST_F(SnapshotTest, what_was_read_may_not_change) {
  const Snapshot before = read({"src/node.impl", "CMakeLists_ros1.txt"});
  EXPECT_EQ(changed_since(before), "");
  package.write("src/node.impl", "after");
  EXPECT_EQ(changed_since(before), "src/node.impl");
}

TEST_F(SnapshotTest, a_log_may) {
  const Snapshot before = read({"src/node.impl"});
  package.write("run.log", "more");
  package.write("another.log", "new");
  EXPECT_EQ(changed_since(before), "");
}

TEST_F(SnapshotTest, a_source_may_not_though_nothing_has_read_it) {
  const Snapshot before = read({});
  package.write("src/new.CPP", "");
  EXPECT_EQ(changed_since(before), "src/new.CPP");
}

}  // namespace
}  // namespace tzc::rewriter
