// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "contenders.h"
#include "processes.h"

namespace tzc {
namespace bench {
namespace {

constexpr char config[] =
    "[general]\nversion = 1\n[[segment]]\n[[segment.mempool]]\nsize = 8192\ncount = 256\n"
    "[[segment.mempool]]\nsize = 1049600\ncount = 64\n[[segment.mempool]]\nsize = 4196352\ncount = 64\n";

bool write_config(const char* path) {
  std::FILE* file = std::fopen(path, "w");
  if (file == nullptr) return false;
  const bool written = std::fputs(config, file) >= 0;
  return std::fclose(file) == 0 && written;
}

void run_daemon(const char* config_path) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // SIGKILL would leave its files in /dev/shm
  const int null = ::open("/dev/null", O_RDWR);
  ::dup2(null, 1);
  ::dup2(null, 2);
  ::execlp("iox-roudi", "iox-roudi", "-c", config_path, "-m", "off", static_cast<char*>(nullptr));
  ::_exit(127);
}

}  // namespace

RouDi::RouDi() {
  char path[] = "/tmp/tzc-bench-roudi-XXXXXX";
  const int fd = ::mkstemp(path);
  if (fd < 0 || !write_config(path)) return;
  ::close(fd);
  pid_ = in_child([&path] { run_daemon(path); });
  ::sleep(2);
  ::unlink(path);
  if (::waitpid(pid_, nullptr, WNOHANG) == pid_)
    pid_ = -1;  // already gone: another one runs, or none is installed
}

RouDi::~RouDi() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGTERM);
  ::waitpid(pid_, nullptr, 0);
}

}  // namespace bench
}  // namespace tzc
