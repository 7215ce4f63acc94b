// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>

#include "contenders.h"
#include "processes.h"

namespace tzc {
namespace bench {
namespace {

constexpr char config[] =
    "[general]\nversion = 1\n[[segment]]\n[[segment.mempool]]\nsize = 8192\ncount = 256\n"
    "[[segment.mempool]]\nsize = 1049600\ncount = 64\n[[segment.mempool]]\nsize = 4196352\ncount = 64\n";

/// A file with it, as long as it exists.
class ConfigFile {
 public:
  ConfigFile()
      : fd_(::mkostemp(path_, O_CLOEXEC)),
        written_(fd_ >= 0 && ::write(fd_, config, size) == static_cast<ssize_t>(size)) {}
  ~ConfigFile() {
    if (fd_ < 0) return;
    ::close(fd_);
    ::unlink(path_);
  }
  ConfigFile(const ConfigFile&) = delete;
  ConfigFile& operator=(const ConfigFile&) = delete;

  bool written() const { return written_; }
  const char* path() const { return path_; }

 private:
  static constexpr std::size_t size = sizeof config - 1;

  char path_[sizeof "/tmp/tzc-bench-roudi-XXXXXX"] = "/tmp/tzc-bench-roudi-XXXXXX";
  const int fd_;
  const bool written_;
};

void run_daemon(const char* config_path) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // SIGKILL would leave its files in /dev/shm
  ::setpgid(0, 0);                     // it handles a terminal's signals, and would end before its clients
  const int null = ::open("/dev/null", O_RDWR);
  ::dup2(null, 1);
  ::dup2(null, 2);
  ::execlp("iox-roudi", "iox-roudi", "-c", config_path, "-m", "off", static_cast<char*>(nullptr));
  ::_exit(127);
}

}  // namespace

RouDi::RouDi() {
  const ConfigFile file;
  if (!file.written()) return;
  pid_ = in_child([&file] { run_daemon(file.path()); });
  ::sleep(2);
  if (all_run({pid_})) return;
  stop({pid_});
  pid_ = -1;  // already gone: another one runs, or none is installed
}

RouDi::~RouDi() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGTERM);
  ::waitpid(pid_, nullptr, 0);
}

}  // namespace bench
}  // namespace tzc
