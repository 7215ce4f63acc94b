// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "posix/file_descriptor.h"
#include "support/temp_dir.h"
#include "trace/recorder.h"
#include "trace/trace_file.h"

namespace tzc {
namespace trace {
namespace {

const char* const warning = "; events are left out of the trace\n";

/// While it lives, no file of this process grows beyond so many bytes, as on a disk that is full then.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit now = before_;
    now.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST(TraceFile, leaves_out_what_finds_no_room_as_a_whole_and_says_so_once) {
  const test::TempDir folder;
  const std::string first(3000, 'a'), large(3000, 'b'), small(500, 'c');
  TraceFile file;
  ASSERT_TRUE(file.open(folder / "trace"));
  ::testing::internal::CaptureStderr();
  {
    const FileSizeLimit limit(4096);
    EXPECT_TRUE(file.append(first));
    EXPECT_FALSE(file.append(large));
    EXPECT_FALSE(file.append(large));
    EXPECT_TRUE(file.append(small));
  }
  EXPECT_TRUE(file.append(large));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "TZC: TZC_TRACE: " + (folder / "trace") + ": " + std::strerror(EFBIG) + warning);
  EXPECT_EQ(folder.read("trace"), "[\n" + first + small + large);
}

TEST(TraceFile, begins_with_what_finds_room_first) {
  const test::TempDir folder;
  TraceFile file;
  ASSERT_TRUE(file.open(folder / "trace"));
  ::testing::internal::CaptureStderr();
  {
    const FileSizeLimit limit(4096);
    EXPECT_FALSE(file.append(std::string(5000, 'a')));
  }
  ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(folder.read("trace"), "");
  EXPECT_TRUE(file.append("{}\n"));
  EXPECT_EQ(folder.read("trace"), "[\n{}\n");
}

TEST(TraceFile, ends_half_a_line_that_cannot_be_taken_away) {
  const posix::FileDescriptor memory(::memfd_create("trace", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  ASSERT_EQ(::fcntl(memory.get(), F_ADD_SEALS, F_SEAL_SHRINK), 0);
  TraceFile file;
  ASSERT_TRUE(file.open("/proc/self/fd/" + std::to_string(memory.get())));
  ::testing::internal::CaptureStderr();
  {
    const FileSizeLimit limit(4096);
    EXPECT_FALSE(file.append(std::string(5000, 'a')));
  }
  ::testing::internal::GetCapturedStderr();
  EXPECT_TRUE(file.append("b\n"));
  EXPECT_TRUE(file.append("c\n"));
  std::string content(6000, '\0');
  const ssize_t size = ::pread(memory.get(), &content[0], content.size(), 0);
  content.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  EXPECT_EQ(content, "[\n" + std::string(4094, 'a') + "\nb\nc\n");
}

constexpr int at_first = 300, later = 50;

/// What a process does whose disk is full for a while. True: it was told so.
bool record(const std::string& file) {
  const Event event{1000, 2000, 7, 0, "/image", 42, Step::take, Arrow::none};
  int ends[2];
  if (::pipe(ends) != 0 || ::dup2(ends[1], STDERR_FILENO) < 0) return false;
  ::setenv("TZC_TRACE", file.c_str(), 1);
  Recorder* recorder = nullptr;
  {
    const FileSizeLimit limit(8192);
    recorder = Recorder::begin();
    if (recorder == nullptr) return false;
    for (int i = 0; i < at_first; ++i) recorder->add(event);
    char text[256];
    for (std::string said; said.find(warning) == std::string::npos;) {
      const ssize_t size = ::read(ends[0], text, sizeof text);
      if (size <= 0) return false;
      said.append(text, static_cast<std::size_t>(size));
    }
  }
  for (int i = 0; i < later; ++i) recorder->add(event);
  return true;
}

/// Of the process that `record` ran in: its file, line by line.
std::vector<std::string> recorded_lines() {
  const test::TempDir folder;
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) std::exit(record(folder / "trace") ? 0 : 1);  // the trace ends with the process
  int status = -1;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  std::istringstream stream(folder.read("trace." + std::to_string(child)));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::ptrdiff_t lines_with(const std::string& words, const std::vector<std::string>& lines) {
  return std::count_if(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

/// As the last counter says.
std::ptrdiff_t left_out(const std::vector<std::string>& lines) {
  const std::string count = "\"events\":";
  std::ptrdiff_t last = 0;
  for (const std::string& line : lines) {
    const std::size_t at = line.find(count);
    if (at != std::string::npos) last = std::atoi(line.c_str() + at + count.size());
  }
  return last;
}

TEST(Recorder, counts_what_the_disk_had_no_room_for) {
  const std::vector<std::string> lines = recorded_lines();
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines.front(), "[");
  EXPECT_EQ(lines.back(), "]");
  for (std::size_t i = 1; i + 1 < lines.size(); ++i)
    EXPECT_TRUE(lines[i].front() == '{' && lines[i].find("}}") != std::string::npos) << lines[i];
  const std::ptrdiff_t events = lines_with("\"ph\":\"X\"", lines);
  EXPECT_GT(left_out(lines), 0);
  EXPECT_GE(events, later);
  EXPECT_EQ(events + left_out(lines), at_first + later);
  EXPECT_GE(lines_with("process_name", lines), 1);  // which were left out, too, at first
  EXPECT_GE(lines_with("thread_name", lines), 1);
}

}  // namespace
}  // namespace trace
}  // namespace tzc
