// SPDX-License-Identifier: BSD-3-Clause
#include "posix/descriptor_use.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>

namespace {
bool are_files_forbidden = false;
}

/// In place of the C library's, as in a sandbox where no file may be opened.
extern "C" int open(const char* path, int flags, ...) {
  if (are_files_forbidden) return errno = EACCES, -1;
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

namespace tzc {
namespace posix {
namespace {

TEST(DescriptorUse, counts_descriptors_where_no_file_may_be_opened) {
  are_files_forbidden = true;
  const bool has_spare = has_spare_descriptors();
  are_files_forbidden = false;
  EXPECT_TRUE(has_spare);
}

TEST(DescriptorUse, leaves_an_eighth_to_the_program_in_a_child) {
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit limit{200, 200};
    ::setrlimit(RLIMIT_NOFILE, &limit);
    if (!has_spare_descriptors()) ::_exit(1);
    int latest = 0;
    while (latest >= 0 && latest < 175) latest = ::dup(0);
    if (has_spare_descriptors()) ::_exit(2);
    while (latest >= 0) latest = ::dup(0);
    ::_exit(errno == EMFILE && !has_spare_descriptors() ? 0 : 3);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0) << "status " << status;
}

}  // namespace
}  // namespace posix
}  // namespace tzc
