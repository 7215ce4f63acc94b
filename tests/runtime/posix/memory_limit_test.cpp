// SPDX-License-Identifier: BSD-3-Clause
// Control groups as files of a folder of the test's own; tests/runtime/channel/exhaustion_test.cpp has a real
// one.
#include "posix/memory_limit.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "support/temp_dir.h"

namespace tzc {
namespace posix {
namespace {

class MemoryLimit : public ::testing::Test {
 protected:
  void write(const std::string& path, const std::string& text) { folder_.write(path, text + "\n"); }
  void second_version(const std::string& group) {
    write("proc/self/mountinfo",
          "1 1 0:1 / / rw - ext4 /dev/x rw\n2 1 0:2 / /cg rw,nosuid - cgroup2 cgroup2 rw,nsdelegate");
    write("proc/self/cgroup", "0::" + group);
  }
  std::size_t headroom() const { return memory_headroom(folder_.path()); }

  const test::TempDir folder_;
};

TEST_F(MemoryLimit, no_control_groups) {
  EXPECT_EQ(headroom(), SIZE_MAX);
}

TEST_F(MemoryLimit, the_machine_has_what_is_available_and_its_swap) {
  write("proc/meminfo",
        "MemTotal:  9000 kB\nMemFree: 1 kB\nMemAvailable:  3 kB\nSwapTotal: 5 kB\nSwapFree: 2 kB\n"
        "HugePages_Total:       0\nHugepagesize:       2048 kB");
  EXPECT_EQ(headroom(), 5u * 1024);
}

TEST_F(MemoryLimit, the_machine_and_the_group_both_limit) {
  second_version("/");
  write("cg/memory.max", "10000");
  write("cg/memory.current", "0");
  write("proc/meminfo", "MemAvailable:  3 kB");
  EXPECT_EQ(headroom(), 3u * 1024);
}

TEST_F(MemoryLimit, second_version_counts_cache_as_free) {
  second_version("/robot");
  write("cg/robot/memory.max", "1000");
  write("cg/robot/memory.current", "700");
  write("cg/robot/memory.stat", "anon 300\ninactive_file 100\nactive_file 50\nshmem 200");
  EXPECT_EQ(headroom(), 450u);
}

TEST_F(MemoryLimit, second_version_without_a_limit) {
  second_version("/robot");
  write("cg/robot/memory.max", "max");
  write("cg/robot/memory.current", "700");
  EXPECT_EQ(headroom(), SIZE_MAX);
}

TEST_F(MemoryLimit, the_tightest_ancestor_counts) {
  second_version("/outer/inner");
  write("cg/outer/inner/memory.max", "5000");
  write("cg/outer/inner/memory.current", "100");
  write("cg/outer/memory.max", "1000");
  write("cg/outer/memory.current", "990");
  EXPECT_EQ(headroom(), 10u);
}

TEST_F(MemoryLimit, nothing_left) {
  second_version("/");
  write("cg/memory.max", "1000");
  write("cg/memory.current", "1200");
  EXPECT_EQ(headroom(), 0u);
}

TEST_F(MemoryLimit, first_version_in_a_container) {
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
