// SPDX-License-Identifier: BSD-3-Clause
#include "paper/program.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "processes.h"

namespace tzc {
namespace bench {
namespace {

std::string path_of(const std::string& name) {
  std::error_code unknown;
  const auto beside = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / name;
  return !unknown && ::access(beside.c_str(), X_OK) == 0 ? beside.string() : name;
}

[[noreturn]] void become(const std::vector<std::string>& command, int output, int error) {
  ::signal(SIGINT, SIG_DFL);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(error, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execvp(path_of(command.front()).c_str(), arguments.data());
  ::dprintf(STDERR_FILENO, "cannot run %s: %s\n", command.front().c_str(), std::strerror(errno));
  ::_exit(127);
}

/// A file without a name, so that a program's output needs no reader while it runs.
class Capture {
 public:
  Capture() : file_(std::tmpfile()) {}
  ~Capture() {
    if (file_ != nullptr) std::fclose(file_);
  }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  int fd() const { return file_ != nullptr ? ::fileno(file_) : -1; }
  std::string text() const {
    std::string text;
    if (file_ == nullptr) return text;
    std::rewind(file_);
    char part[4096];
    for (std::size_t size = 0; (size = std::fread(part, 1, sizeof part, file_)) > 0;) text.append(part, size);
    return text;
  }

 private:
  std::FILE* const file_;
};

}  // namespace

ProgramResult run_program(const std::vector<std::string>& command) {
  const Capture output, error;
  const pid_t child = in_child([&] { become(command, output.fd(), error.fd()); });
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), output.text(), error.text()};
}

}  // namespace bench
}  // namespace tzc
