// SPDX-License-Identifier: BSD-3-Clause
#include "run/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "run/failure.h"
#include "run/process_tree.h"

namespace tzc::compare {
namespace {

constexpr int kill_step_ms = 20;

std::set<pid_t>& held() {
  static std::set<pid_t> pids;
  return pids;
}

/// Not interrupted: stopping what was started must go on after a stop request.
void pause_ms(int milliseconds) {
  const timespec time{milliseconds / 1000, milliseconds % 1000 * 1'000'000L};
  ::nanosleep(&time, nullptr);
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> all;
  for (std::string& string : strings) all.push_back(string.data());
  all.push_back(nullptr);
  return all;
}

/// Where the command is, by the PATH of its own environment.
std::string find_program(const std::string& name, const Environment& environment) {
  if (name.find('/') != std::string::npos) return name;
  const auto path = environment.find("PATH");
  std::istringstream folders(path == environment.end() ? "/usr/bin:/bin" : path->second);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = folder + "/" + name;
    if (::access(file.c_str(), X_OK) == 0) return file;
  }
  throw Failure(name + " is not on the PATH", "install it, or source ROS's setup.bash first");
}

}  // namespace

Child::Child(const std::vector<std::string>& command, const Environment& environment, std::string log_file,
             Input input)
    : log_file_(std::move(log_file)) {
  std::vector<std::string> arguments = command;
  arguments[0] = find_program(command[0], environment);
  int in[2] = {-1, -1}, out[2] = {-1, -1};
  if (input == Input::pipe && (::pipe2(in, O_CLOEXEC) != 0 || ::pipe2(out, O_CLOEXEC) != 0))
    throw Failure(std::string("no pipe: ") + std::strerror(errno));
  pid_ = ::fork();
  if (pid_ < 0) throw Failure(std::string("no process: ") + std::strerror(errno));
  if (pid_ == 0) run(arguments, environment, in[0], out[1]);
  held().insert(pid_);
  if (input == Input::pipe) {
    ::close(in[0]);
    ::close(out[1]);
    input_ = in[1];
    output_ = out[0];
  }
}

void Child::run(const std::vector<std::string>& command, const Environment& environment, int input,
                int output) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  ::setsid();
  const int null = ::open("/dev/null", O_RDONLY);
  const int log = ::open(log_file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(input >= 0 ? input : null, STDIN_FILENO);
  ::dup2(output >= 0 ? output : log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  // The first is ignored by this program, the others perhaps by what started it; stop() begins with SIGINT.
  for (const int signal : {SIGPIPE, SIGINT, SIGQUIT}) ::signal(signal, SIG_DFL);
  std::vector<std::string> arguments = command, variables;
  for (const auto& [name, value] : environment) variables.push_back(name + "=" + value);
  ::execve(command[0].c_str(), pointers(arguments).data(), pointers(variables).data());
  ::dprintf(STDERR_FILENO, "%s: %s\n", command[0].c_str(), std::strerror(errno));
  ::_exit(127);
}

Child::~Child() {
  stop();
  close_input();
  if (output_ >= 0) ::close(output_);
  held().erase(pid_);
}

std::optional<int> Child::status() {
  int status = 0;
  if (!status_ && ::waitpid(pid_, &status, WNOHANG) == pid_)
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return status_;
}

bool Child::is_running() {
  return !status();
}

bool Child::wait(int timeout_ms) {
  for (int left = timeout_ms; is_running() && left > 0; left -= kill_step_ms) pause_ms(kill_step_ms);
  return !is_running();
}

void Child::stop(int patience_ms) {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    if (!is_running()) return;
    ::kill(-pid_, SIGCONT);  // a stopped process does not hear the others
    ::kill(-pid_, signal);
    ::kill(pid_, signal);  // it may not have its own session yet
    wait(signal == SIGINT ? patience_ms : patience_ms / 4);
  }
}

void Child::write(const std::string& text) {
  if (::write(input_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    throw Failure("a process that was started has ended: " + log_tail());
}

void Child::close_input() {
  if (input_ >= 0) ::close(input_);
  input_ = -1;
}

std::string Child::read_output(int timeout_ms) {
  pollfd waiting{output_, POLLIN, 0};
  if (::poll(&waiting, 1, timeout_ms) <= 0) return "";
  std::string text(65536, '\0');
  const ssize_t size = ::read(output_, text.data(), text.size());
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return text;
}

std::string Child::log_tail() const {
  constexpr std::size_t most_lines = 15;
  std::ifstream log(log_file_);
  std::vector<std::string> lines;
  for (std::string line; std::getline(log, line);) lines.push_back(line);
  std::string tail;
  for (std::size_t i = lines.size() > most_lines ? lines.size() - most_lines : 0; i < lines.size(); ++i)
    tail += "\n    " + lines[i];
  return tail.empty() ? " (it said nothing)" : tail;
}

void adopt_orphans() {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
}

void kill_orphans() {
  for (int round = 0; round < 10; ++round) {  // what an orphan leaves behind comes to us in turn
    bool found = false;
    for (const pid_t pid : children_of(::getpid())) {
      if (held().count(pid) != 0) continue;
      found = true;
      ::kill(pid, SIGKILL);
      ::waitpid(pid, nullptr, 0);
    }
    if (!found) return;
  }
}

}  // namespace tzc::compare
