// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <new>
#include <utility>
#include <vector>

#include "measure.h"
#include "processes.h"
#include "roscpp/crowd.h"

namespace tzc {
namespace bench {
namespace {

constexpr std::size_t message_bytes = 4096;
constexpr useconds_t between_looks_us = 20'000;  // looking at each topic costs the time of those that connect
constexpr useconds_t until_at_rest_us = 3'000'000;  // sockets are lent for a second or two

/// Memory that the processes of one crowd share.
struct CrowdBoard {
  std::int64_t start_ns = 0;
  std::int64_t connected_ns = 0;
  std::int64_t upgraded_ns = 0;
  std::size_t connected = 0;
  std::size_t upgraded = 0;
  std::atomic<std::size_t> received{0};
  std::atomic<bool> done{false};
};

std::string topic(std::size_t number) {
  return "/crowd" + std::to_string(number);
}

void limit_descriptors(std::size_t most) {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = most == 0 ? limit.rlim_max : static_cast<rlim_t>(most);
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

void start_node(const Crowd& crowd) {
  limit_descriptors(crowd.descriptors);
  ros::M_string remappings;
  ros::init(remappings, "crowd" + std::to_string(::getpid()), ros::init_options::NoSigintHandler);
}

/// A count that grows towards an end.
class Progress {
 public:
  Progress(std::function<std::size_t()> count, std::size_t end) : count_(std::move(count)), end_(end) {}

  void look() {
    const std::size_t now = count_();
    if (now > reached_) grown_ns_ = now_ns();
    reached_ = std::max(reached_, now);
  }
  std::size_t reached() const { return reached_; }
  /// When it last grew, or at first the time of its making.
  std::int64_t grown_ns() const { return grown_ns_; }
  bool complete() const { return reached_ >= end_; }

 private:
  const std::function<std::size_t()> count_;
  const std::size_t end_;
  std::size_t reached_ = 0;
  std::int64_t grown_ns_ = now_ns();
};

/// Looks until all are complete, or none has grown for so long.
void wait_for_all(std::vector<Progress*> all, std::size_t patience_s) {
  const auto patience_ns = static_cast<std::int64_t>(patience_s) * 1'000'000'000;
  for (;;) {
    std::int64_t grown_ns = 0;
    bool complete = true;
    for (Progress* one : all) {
      one->look();
      grown_ns = std::max(grown_ns, one->grown_ns());
      complete = complete && one->complete();
    }
    if (complete || now_ns() - grown_ns > patience_ns) return;
    ::usleep(between_looks_us);
  }
}

void publish_all(const Crowd& crowd, Transport transport, CrowdBoard& board) {
  start_node(crowd);
  const auto topics = crowd_transport(transport);
  for (std::size_t i = 0; i < crowd.topics; ++i) topics->advertise(topic(i), crowd.memory_bytes);
  const std::size_t all = crowd.connections();
  Progress connected([&] { return topics->connected(); }, all);
  Progress upgraded([&] { return topics->upgraded(); }, topics->shares_memory() ? all : 0);
  wait_for_all({&connected, &upgraded}, crowd.patience_s);
  board.connected = connected.reached();
  board.connected_ns = connected.grown_ns();
  board.upgraded = upgraded.reached();
  board.upgraded_ns = std::max(upgraded.grown_ns(), connected.grown_ns());
  topics->publish(message_bytes);
  Progress received([&] { return board.received.load(); }, board.connected);
  wait_for_all({&received}, crowd.patience_s);
  ::usleep(until_at_rest_us);
  board.done = true;
  for (;;) ::pause();
}

void subscribe_all(const Crowd& crowd, Transport transport, CrowdBoard& board) {
  start_node(crowd);
  const auto topics = crowd_transport(transport);
  for (std::size_t i = 0; i < crowd.topics; ++i) topics->subscribe(topic(i), [&board] { ++board.received; });
  ros::spin();
}

bool wait_until_done(const CrowdBoard& board, const std::vector<pid_t>& processes) {
  while (!board.done) {
    if (!all_run(processes)) return false;
    ::usleep(between_looks_us);
  }
  return true;
}

CrowdResult collect(const CrowdBoard& board, const std::vector<pid_t>& processes) {
  CrowdResult result;
  result.connected_s = static_cast<double>(board.connected_ns - board.start_ns) / 1e9;
  result.upgraded_s = static_cast<double>(board.upgraded_ns - board.connected_ns) / 1e9;
  result.connected = board.connected;
  result.upgraded = board.upgraded;
  result.delivered = board.received;
  result.publisher = needs_of(processes.front());
  for (std::size_t i = 1; i < processes.size(); ++i)
    result.subscriber = most(result.subscriber, needs_of(processes[i]));
  return result;
}

}  // namespace

bool run_crowd(const Crowd& crowd, Transport transport, CrowdResult& result) {
  void* memory =
      ::mmap(nullptr, sizeof(CrowdBoard), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return false;
  auto& board = *new (memory) CrowdBoard();
  board.start_ns = now_ns();
  const std::vector<pid_t> processes = in_children(1 + crowd.subscribers, [&](std::size_t number) {
    number == 0 ? publish_all(crowd, transport, board) : subscribe_all(crowd, transport, board);
  });
  const bool done = wait_until_done(board, processes);
  if (done) result = collect(board, processes);
  stop(processes);
  ::munmap(memory, sizeof(CrowdBoard));
  return done;
}

}  // namespace bench
}  // namespace tzc
