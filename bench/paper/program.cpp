// SPDX-License-Identifier: BSD-3-Clause
#include "paper/program.h"

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

constexpr int not_run = 127;  // as in a shell

std::string path_of(const std::string& name) {
  std::error_code unknown;
  const auto beside = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / name;
  return !unknown && ::access(beside.c_str(), X_OK) == 0 ? beside.string() : name;
}

[[noreturn]] void become(const std::vector<std::string>& command, int output, int error) {
  take_interrupts_again();
  ::dup2(output, STDOUT_FILENO);
  ::dup2(error, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execvp(path_of(command.front()).c_str(), arguments.data());
  ::dprintf(STDERR_FILENO, "cannot run %s: %s\n", command.front().c_str(), std::strerror(errno));
  ::_exit(not_run);
}

/// As waitpid has it.
int status_of(pid_t child) {
  for (int status = 0;;) {
    if (::waitpid(child, &status, 0) == child) return status;
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "cannot wait for a process");
  }
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
  try {
    const pid_t child = in_child([&] { become(command, output.fd(), error.fd()); });
    const int status = status_of(child);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), output.text(), error.text()};
  } catch (const std::system_error& failure) {
    return {not_run, "", failure.what()};
  }
}

}  // namespace bench
}  // namespace tzc
