// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <string>

namespace tzc::test {

/// Whether this process has any, whose ends were waited for or not.
inline bool has_children() {
  return ::waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

/// How a process ended, and what it wrote on standard error.
struct ProcessEnd {
  int status = 0;  // waitpid's
  std::string said;

  bool exited_with(int code) const { return WIFEXITED(status) && WEXITSTATUS(status) == code; }
};

/// The code with which a poor process exits that cannot be made poor on this machine, and the reason.
constexpr int not_possible = 77;
constexpr char why_not_possible[] =
    "root may not become another user here, as in a container without CAP_SETUID, and no limit of processes "
    "binds root";

/// The limit of processes does not bind root; what is killed by mistake should belong to nobody else.
inline bool became_nobody() {
  const auto user = static_cast<uid_t>(50'000 + ::getpid() % 9'000);
  return ::geteuid() != 0 || ::setresuid(user, user, user) == 0;
}

/// Runs body, whose result is the exit code, in a process that can start so many more at a time. None at all where the test
/// is not root, since its user has others.
inline ProcessEnd in_poor_process(rlim_t more, const std::function<int()>& body) {
  ProcessEnd end;
  int ends[2];
  if (::pipe(ends) != 0) return end;
  const rlimit limit{::geteuid() == 0 ? 1 + more : 0, ::geteuid() == 0 ? 1 + more : 0};
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    if (!became_nobody() || ::setrlimit(RLIMIT_NPROC, &limit) != 0) ::_exit(not_possible);
    ::_exit(body());
  }
  ::close(ends[1]);
  char part[4096];
  for (ssize_t size = 0; (size = ::read(ends[0], part, sizeof part)) > 0;)
    end.said.append(part, static_cast<std::size_t>(size));
  ::close(ends[0]);
  ::waitpid(child, &end.status, 0);
  return end;
}

}  // namespace tzc::test
