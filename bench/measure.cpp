// SPDX-License-Identifier: BSD-3-Clause
#include "measure.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace tzc {
namespace bench {
namespace {

constexpr std::uint64_t warm_up = 20;  // the first messages fault pages in and open segments
constexpr int rest_ms = 100;           // and the scheduler forgets how busy it was
constexpr int patience_ms = 20'000;
constexpr int last_arrivals_ms = 1000;

Board* create_board() {
  void* memory = ::mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : new (memory) Board();
}

pid_t in_child(const std::function<void()>& body) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  body();
  std::exit(0);  // iceoryx cleans its socket files up in a destructor
}

void sleep_ms(int milliseconds) {
  ::usleep(static_cast<useconds_t>(milliseconds) * 1000);
}

bool wait_until_ready(const Board& board, std::size_t subscribers) {
  for (int i = 0; i < patience_ms && board.ready < subscribers; ++i) sleep_ms(1);
  return board.ready >= subscribers;
}

bool complete(const Board& board, const Setup& setup) {
  return std::all_of(board.received, board.received + setup.subscribers,
                     [&](const auto& received) { return received >= setup.count + warm_up; });
}

void wait_until_received(const Board& board, const Setup& setup) {
  for (int i = 0; i < last_arrivals_ms && !complete(board, setup); ++i) sleep_ms(1);
}

void publish_at_rate(const std::function<void(std::uint64_t)>& publish, double rate, std::uint64_t from,
                     std::uint64_t to) {
  const auto period = static_cast<std::int64_t>(1e9 / rate);
  std::int64_t next = now_ns();
  for (std::uint64_t index = from; index < to; ++index) {
    next += period;
    const timespec until{next / 1'000'000'000, next % 1'000'000'000};
    ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
    publish(index);
  }
}

// The warm-up has its own schedule: the measured messages do not catch up on delays of its page faults.
void send_all(Contender& contender, const Setup& setup, Board& board) {
  std::vector<Recorder> here;
  if (contender.in_one_process()) {
    for (std::size_t who = 0; who < setup.subscribers; ++who) here.emplace_back(board, who);
    contender.subscribe_here(setup, here);
  }
  const auto publish = contender.publish(setup);
  if (!wait_until_ready(board, setup.subscribers)) {
    std::fprintf(stderr, "%s: only %u of %zu subscribers came\n", contender.name(), board.ready.load(),
                 setup.subscribers);
    return;
  }
  sleep_ms(rest_ms);
  publish_at_rate(publish, setup.rate, 0, warm_up);
  sleep_ms(rest_ms);
  publish_at_rate(publish, setup.rate, warm_up, setup.count + warm_up);
  wait_until_received(board, setup);
}

void stop_all(const std::vector<pid_t>& children, bool let_them_leave) {
  if (let_them_leave) sleep_ms(500);
  for (const pid_t child : children) ::kill(child, SIGKILL);
  for (const pid_t child : children) ::waitpid(child, nullptr, 0);
}

void collect(const Setup& setup, const Board& board, Samples& samples) {
  samples.sent += setup.count * setup.subscribers;
  for (std::size_t who = 0; who < setup.subscribers; ++who) {
    const std::uint32_t* first = board.latency_ns[who];
    std::copy_if(first, first + setup.count, std::back_inserter(samples.latency_ns),
                 [](std::uint32_t ns) { return ns != 0; });
  }
}

}  // namespace

std::int64_t now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

void Recorder::record(const Stamp& stamp) {
  const std::int64_t latency = now_ns() - stamp.nanoseconds;
  ++board_.received[who_];
  if (stamp.index < warm_up || stamp.index - warm_up >= most_messages) return;
  board_.latency_ns[who_][stamp.index - warm_up] =
      static_cast<std::uint32_t>(std::clamp<std::int64_t>(latency, 1, UINT32_MAX));
}

void measure(Contender& contender, const Setup& setup, Samples& samples) {
  Board* board = create_board();
  contender.prepare(setup);
  std::vector<pid_t> subscribers;
  for (std::size_t who = 0; who < setup.subscribers && !contender.in_one_process(); ++who) {
    subscribers.push_back(in_child([&] {
      Recorder recorder(*board, who);
      contender.subscribe(setup, who, recorder);
    }));
  }
  const pid_t publisher = in_child([&] { send_all(contender, setup, *board); });
  ::waitpid(publisher, nullptr, 0);
  board->stop = true;
  stop_all(subscribers, contender.cleans_up_at_exit());
  collect(setup, *board, samples);
  ::munmap(board, sizeof(Board));
}

Row summarize(const Contender& contender, const Setup& setup, Samples samples) {
  std::vector<std::uint32_t>& all = samples.latency_ns;
  std::sort(all.begin(), all.end());
  Row row{contender.name(), setup.size_bytes, setup.subscribers, samples.sent, all.size(), 0, 0};
  if (all.empty()) return row;
  row.median_us = all[all.size() / 2] / 1000.0;
  row.p99_us = all[all.size() * 99 / 100] / 1000.0;
  return row;
}

}  // namespace bench
}  // namespace tzc
