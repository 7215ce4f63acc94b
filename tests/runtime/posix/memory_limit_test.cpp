// SPDX-License-Identifier: BSD-3-Clause
// Control groups as files of a folder of the test's own; tests/runtime/channel/exhaustion_test.cpp has a real
// one.
#include "posix/memory_limit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

namespace tzc {
namespace posix {
namespace {

namespace fs = std::filesystem;

class MemoryLimit : public ::testing::Test {
 protected:
  MemoryLimit() : root_(fs::temp_directory_path() / ("tzc-memory-limit-" + std::to_string(::getpid()))) {}
  ~MemoryLimit() override { fs::remove_all(root_); }

  void write(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text << "\n";
  }
  void second_version(const std::string& group) {
    write("proc/self/mountinfo",
          "1 1 0:1 / / rw - ext4 /dev/x rw\n2 1 0:2 / /cg rw,nosuid - cgroup2 cgroup2 rw,nsdelegate");
    write("proc/self/cgroup", "0::" + group);
  }
  std::size_t headroom() const { return memory_headroom(root_.string()); }

  const fs::path root_;
};

TEST_F(MemoryLimit, NoControlGroups) {
  EXPECT_EQ(headroom(), SIZE_MAX);
}

TEST_F(MemoryLimit, SecondVersionCountsCacheAsFree) {
  second_version("/robot");
  write("cg/robot/memory.max", "1000");
  write("cg/robot/memory.current", "700");
  write("cg/robot/memory.stat", "anon 300\ninactive_file 100\nactive_file 50\nshmem 200");
  EXPECT_EQ(headroom(), 450u);
}

TEST_F(MemoryLimit, SecondVersionWithoutALimit) {
  second_version("/robot");
  write("cg/robot/memory.max", "max");
  write("cg/robot/memory.current", "700");
  EXPECT_EQ(headroom(), SIZE_MAX);
}

TEST_F(MemoryLimit, TheTightestAncestorCounts) {
  second_version("/outer/inner");
  write("cg/outer/inner/memory.max", "5000");
  write("cg/outer/inner/memory.current", "100");
  write("cg/outer/memory.max", "1000");
  write("cg/outer/memory.current", "990");
  EXPECT_EQ(headroom(), 10u);
}

TEST_F(MemoryLimit, NothingLeft) {
  second_version("/");
  write("cg/memory.max", "1000");
  write("cg/memory.current", "1200");
  EXPECT_EQ(headroom(), 0u);
}

TEST_F(MemoryLimit, FirstVersionInAContainer) {
  write("proc/self/mountinfo", "3 1 0:3 /docker/a /cg/memory rw - cgroup cgroup rw,memory");
  write("proc/self/cgroup", "5:cpu,cpuacct:/docker/a\n4:memory:/docker/a/node");
  write("cg/memory/node/memory.limit_in_bytes", "2000");
  write("cg/memory/node/memory.usage_in_bytes", "1500");
  write("cg/memory/node/memory.stat", "inactive_file 1\ntotal_inactive_file 300\ntotal_active_file 200");
  write("cg/memory/memory.limit_in_bytes", "9223372036854771712");
  write("cg/memory/memory.usage_in_bytes", "1500");
  EXPECT_EQ(headroom(), 1000u);
}

}  // namespace
}  // namespace posix
}  // namespace tzc
