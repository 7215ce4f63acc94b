// SPDX-License-Identifier: BSD-3-Clause
#include "processes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <tuple>

#include "page.h"
#include "posix/file_descriptor.h"
#include "statistics/page_layout.h"

namespace tzc::monitor {
namespace {

namespace fs = std::filesystem;

/// A page is updated once a second; on a busy machine later.
constexpr double silent_after_s = 5;

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// Names of numbers in a folder; empty when it may not be read, or is gone.
std::vector<std::string> numbers_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    if (std::string name = entry->path().filename().string(); is_number(name)) names.push_back(name);
  return names;
}

bool may_be_watched(const std::string& process) {
  struct stat status{};
  if (::stat(process.c_str(), &status) != 0) return false;
  return ::geteuid() == 0 || status.st_uid == ::geteuid();
}

/// The process's descriptor of its page, as a path. Its link names the file: "/memfd:NAME (deleted)".
std::optional<std::string> find_page(const std::string& process) {
  const std::string wanted = std::string("/memfd:") + statistics::page_name + " (deleted)";
  for (const std::string& number : numbers_in(process + "/fd")) {
    const std::string path = process + "/fd/" + number;
    char target[64];
    const ssize_t size = ::readlink(path.c_str(), target, sizeof target);
    if (size > 0 && std::string(target, static_cast<std::size_t>(size)) == wanted) return path;
  }
  return std::nullopt;
}

/// Opened in two steps: what is no regular file any more (the number may be another file's by now) is never opened.
int open_regular(const std::string& path) {
  const posix::FileDescriptor handle(::open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat status{};
  if (handle.get() < 0 || ::fstat(handle.get(), &status) != 0 || !S_ISREG(status.st_mode)) return -1;
  return ::open(fmt::format("/proc/self/fd/{}", handle.get()).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

/// The third field of /proc/PID/stat, after the name, which may hold parentheses. '?': the process is gone.
char state_of(const std::string& process) {
  std::ifstream file(process + "/stat");
  std::string line;
  std::getline(file, line);
  const std::size_t name_end = line.rfind(')');
  return name_end != std::string::npos && line.size() > name_end + 2 ? line[name_end + 2] : '?';
}

bool is_stopped(char state) {
  return state == 'T' || state == 't';
}

/// The process's number in its own namespace, by which its page knows it.
std::uint32_t own_pid(const std::string& process, std::uint32_t pid) {
  std::ifstream file(process + "/status");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("NSpid:", 0) != 0) continue;
    std::istringstream numbers(line.substr(6));
    while (numbers >> pid) continue;
  }
  return pid;
}

double age_of(std::uint64_t time_ns) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  const double now_s = static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
  return std::max(0.0, now_s - static_cast<double>(time_ns) * 1e-9);
}

/// In a container it knows its peers by the numbers that they have there; here these may be anybody's.
void forget_peers(Node& node) {
  for (Topic& topic : node.topics)
    for (Connection& connection : topic.connections) connection.pid = 0;
  for (Subscription& subscription : node.subscriptions) subscription.pid = 0;
}

void judge_state(const std::string& proc, const std::string& process, Node& node) {
  node.age_s = node.updated_ns != 0 ? age_of(node.updated_ns) : 0;
  if (is_stopped(state_of(process)))
    node.state = State::stopped;
  else if (node.age_s > silent_after_s)
    node.state = State::silent;
  const auto is_other_stopped = [&](std::uint32_t pid) {
    return pid != 0 && is_stopped(state_of(fmt::format("{}/{}", proc, pid)));
  };
  for (Topic& topic : node.topics)
    for (Connection& connection : topic.connections) connection.is_stopped = is_other_stopped(connection.pid);
  for (Subscription& subscription : node.subscriptions)
    subscription.is_stopped = is_other_stopped(subscription.pid);
}

/// The page has them in the order in which roscpp met them, which changes when a node starts anew.
void sort_rows(Node& node) {
  std::sort(node.topics.begin(), node.topics.end(),
            [](const Topic& a, const Topic& b) { return a.name < b.name; });
  for (Topic& topic : node.topics)
    std::stable_sort(topic.connections.begin(), topic.connections.end(),
                     [](const Connection& a, const Connection& b) { return a.subscriber < b.subscriber; });
  std::stable_sort(node.subscriptions.begin(), node.subscriptions.end(),
                   [](const Subscription& a, const Subscription& b) {
                     return std::tie(a.topic, a.publisher) < std::tie(b.topic, b.publisher);
                   });
}

void look_at(const std::string& proc, const std::string& number, Sample& sample) {
  const std::string process = proc + "/" + number;
  if (!may_be_watched(process)) return;
  const std::optional<std::string> path = find_page(process);
  if (!path) return;
  const posix::FileDescriptor page(open_regular(*path));
  if (page.get() < 0) return;
  Node node;
  std::string trouble;
  const auto read_at = [&](void* to, std::size_t bytes, std::uint64_t offset) {
    const ssize_t size = ::pread(page.get(), to, bytes, static_cast<off_t>(offset));
    return size < 0 ? std::size_t{0} : static_cast<std::size_t>(size);
  };
  if (!read_page(read_at, node, trouble)) {
    sample.troubles.push_back(
        fmt::format("process {}: its statistics page is left out: {}", number, trouble));
    return;
  }
  const auto pid = static_cast<std::uint32_t>(std::strtoul(number.c_str(), nullptr, 10));
  if (node.pid != own_pid(process, pid)) return;  // a forked child has a copy of its parent's descriptor
  if (node.pid != pid) forget_peers(node);
  node.pid = pid;
  judge_state(proc, process, node);
  sample.nodes.push_back(std::move(node));
}

}  // namespace

Sample take_sample(const std::string& proc) {
  Sample sample;
  for (const std::string& number : numbers_in(proc)) look_at(proc, number, sample);
  std::sort(sample.nodes.begin(), sample.nodes.end(),
            [](const Node& a, const Node& b) { return std::tie(a.name, a.pid) < std::tie(b.name, b.pid); });
  for (Node& node : sample.nodes) sort_rows(node);
  return sample;
}

}  // namespace tzc::monitor
