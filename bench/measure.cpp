// SPDX-License-Identifier: BSD-3-Clause
#include "measure.h"

#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <system_error>
#include <vector>

#include "processes.h"
#include "real_time.h"

namespace tzc {
namespace bench {
namespace {

constexpr std::uint64_t warm_up = 20;              // the first messages fault pages in and open segments
constexpr int rest_ms = 100;                       // and the scheduler forgets how busy it was
constexpr std::chrono::seconds time_to_leave{20};  // with messages of 64 MB it takes seconds
constexpr std::chrono::milliseconds between_looks{10};
constexpr std::chrono::milliseconds undisturbed{60'000};  // the ends of processes are told at once
constexpr int silence_ms = 1000;  // after this long without an arrival nothing more is expected

Board* create_board() {
  void* memory = ::mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : new (memory) Board();
}

void sleep_ms(int milliseconds) {
  ::usleep(static_cast<useconds_t>(milliseconds) * 1000);
}

/// Whether each subscriber has got so many messages.
bool complete(const Board& board, const Setup& setup, std::uint64_t messages) {
  return std::all_of(board.received, board.received + setup.subscribers,
                     [&](const auto& received) { return received >= messages; });
}

std::uint64_t received(const Board& board, const Setup& setup) {
  std::uint64_t all = 0;
  for (std::size_t who = 0; who < setup.subscribers; ++who) all += board.received[who];
  return all;
}

void wait_until_received(const Board& board, const Setup& setup, std::uint64_t messages) {
  std::uint64_t before = received(board, setup);
  for (int silent = 0; silent < silence_ms && !complete(board, setup, messages) && !board.stop; ++silent) {
    sleep_ms(1);
    const std::uint64_t now = received(board, setup);
    if (now != before) silent = 0;
    before = now;
  }
}

void enter(Member& member, const Setup& setup) {
  if (setup.real_time && !become_real_time()) ::_exit(1);
  member.process = ::getpid();
  count_into(&member.counts);
}

/// Notes what each member has spent between the two calls.
class Spending {
 public:
  Spending(Board& board, const Setup& setup) {
    members_.push_back(&board.publisher);
    for (std::size_t who = 0; who < setup.subscribers; ++who) members_.push_back(&board.subscriber[who]);
  }
  // The publisher's process looks: what that costs it must not count.
  void begin() {
    for (auto member = members_.rbegin(); member != members_.rend(); ++member)
      (*member)->spent = spent_by(**member);
  }
  void end() {
    for (Member* member : members_) member->spent = spent_by(*member) - member->spent;
  }

 private:
  static Cost spent_by(const Member& member) {
    return member.process != 0 ? cost_of(member.process, member.counts) : Cost();
  }

  std::vector<Member*> members_;
};

void publish_at_rate(const std::function<void(std::uint64_t)>& publish, double rate, std::uint64_t from,
                     std::uint64_t to, Board& board) {
  const auto period = static_cast<std::int64_t>(1e9 / rate);
  std::int64_t next = now_ns();
  for (std::uint64_t index = from; index < to && !board.stop; ++index) {
    next += period;
    const timespec until{next / 1'000'000'000, next % 1'000'000'000};
    ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
    publish(index);
    if (index >= warm_up) board.returned_ns[index - warm_up] = now_ns();
  }
}

// The warm-up has its own schedule: the measured messages do not catch up on delays of its page faults, nor wait
// behind its last messages.
void send_all(Contender& contender, const Setup& setup, Board& board) {
  std::vector<Recorder> here;
  if (contender.in_one_process()) {
    for (std::size_t who = 0; who < setup.subscribers; ++who) here.emplace_back(board, who);
    contender.subscribe_here(setup, here);
  }
  const auto publish = contender.publish(setup);
  if (!publish || !wait_until(setup, [&] { return board.ready >= setup.subscribers; })) return;
  board.sends = true;
  sleep_ms(rest_ms);
  publish_at_rate(publish, setup.rate, 0, warm_up, board);
  wait_until_received(board, setup, warm_up);
  sleep_ms(rest_ms);
  Spending spending(board, setup);
  spending.begin();
  const std::int64_t start = now_ns();
  publish_at_rate(publish, setup.rate, warm_up, setup.count + warm_up, board);
  board.publishing_ns = now_ns() - start;
  board.published = true;
  wait_until_received(board, setup, warm_up + setup.count);
  spending.end();
}

void be_subscriber(Contender& contender, const Setup& setup, std::size_t who, Board& board) {
  enter(board.subscriber[who], setup);
  Recorder recorder(board, who);
  contender.subscribe(setup, who, recorder);
}

void be_publisher(Contender& contender, const Setup& setup, Board& board) {
  enter(board.publisher, setup);
  send_all(contender, setup, board);
}

/// The publisher is the last one.
std::vector<pid_t> start(Contender& contender, const Setup& setup, Board& board) {
  const std::size_t subscribers = contender.in_one_process() ? 0 : setup.subscribers;
  return in_children(subscribers + 1, [&](std::size_t who) {
    who < subscribers ? be_subscriber(contender, setup, who, board) : be_publisher(contender, setup, board);
  });
}

Outcome failed(const Contender& contender, const std::string& why) {
  std::fprintf(stderr, "%s: %s\n", contender.name(), why.c_str());
  return Outcome::failed;
}

constexpr char subscriber_ended[] = "a subscriber has ended early";

std::string why_not_connected(const Setup& setup, const Board& board) {
  return fmt::format("after {:g} s the publisher is not connected to all subscribers ({} of {} are ready)",
                     std::chrono::duration<double>(setup.patience).count(), board.ready.load(),
                     setup.subscribers);
}

/// Until the publisher ends, or it is clear that it will not come to an end.
Outcome watch(const Contender& contender, const Setup& setup, const Board& board,
              const std::vector<pid_t>& processes) {
  const std::vector<pid_t> publisher{processes.back()}, subscribers(processes.begin(), processes.end() - 1);
  const auto end_of_patience = std::chrono::steady_clock::now() + setup.patience;
  while (all_run(publisher)) {
    if (interrupted()) return Outcome::interrupted;
    if (!all_run(subscribers)) return failed(contender, subscriber_ended);
    if (!board.sends && std::chrono::steady_clock::now() > end_of_patience)
      return failed(contender, why_not_connected(setup, board));
    wait_for_news(board.sends ? undisturbed : between_looks);
  }
  if (!board.published) return failed(contender, "the publisher has ended early");
  return all_run(subscribers) ? Outcome::complete : failed(contender, subscriber_ended);
}

/// By themselves, where they would leave files behind.
void end_processes(const Contender& contender, Board& board, const std::vector<pid_t>& processes) {
  board.stop = true;
  if (contender.cleans_up_at_exit()) let_end(processes, time_to_leave);
  stop(processes);
}

Outcome run(Contender& contender, const Setup& setup, Board& board) {
  try {
    contender.prepare(setup);
    const std::vector<pid_t> processes = start(contender, setup, board);
    const Outcome outcome = watch(contender, setup, board, processes);
    end_processes(contender, board, processes);
    return outcome;
  } catch (const std::system_error& error) {
    return failed(contender, error.what());
  }
}

std::vector<std::uint64_t> publishing_times(const Setup& setup, const Board& board) {
  std::vector<std::uint64_t> times;
  for (std::size_t i = 0; i < setup.count; ++i) {
    const std::int64_t begin = board.published_ns[i], end = board.returned_ns[i];
    if (begin != 0 && end >= begin) times.push_back(static_cast<std::uint64_t>(end - begin));
  }
  return times;
}

Measurement collect(const Setup& setup, const Board& board, Outcome outcome) {
  Measurement result;
  result.outcome = outcome;
  result.seconds = static_cast<double>(board.publishing_ns) / 1e9;
  result.publisher = board.publisher.spent;
  if (setup.real_time) result.published_ns.assign(board.published_ns, board.published_ns + setup.count);
  result.publishing_ns = publishing_times(setup, board);
  for (std::size_t who = 0; who < setup.subscribers; ++who) {
    const std::uint64_t* first = board.latency_ns[who];
    result.latency_ns.emplace_back(first, first + setup.count);
    result.subscribers += board.subscriber[who].spent;
  }
  return result;
}

/// 0 of none.
double percentile_us(std::vector<std::uint64_t>& all_ns, std::size_t percent) {
  if (all_ns.empty()) return 0;
  const auto at = all_ns.begin() + static_cast<std::ptrdiff_t>(all_ns.size() * percent / 100);
  std::nth_element(all_ns.begin(), at, all_ns.end());
  return static_cast<double>(*at) / 1000.0;
}

}  // namespace

std::int64_t now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

std::string unique_name() {
  static std::size_t names = 0;
  return "tzcb" + std::to_string(::getpid()) + "-" + std::to_string(names++);
}

void Recorder::record(const Stamp& stamp) {
  const std::int64_t latency = now_ns() - stamp.nanoseconds;
  ++board_.received[who_];
  if (stamp.index < warm_up || stamp.index - warm_up >= most_messages) return;
  board_.published_ns[stamp.index - warm_up] = stamp.nanoseconds;  // each subscriber writes the same
  board_.latency_ns[who_][stamp.index - warm_up] =
      static_cast<std::uint64_t>(std::max<std::int64_t>(latency, 1));
}

bool wait_until(const Setup& setup, const std::function<bool()>& condition) {
  while (!condition()) {
    if (setup.over != nullptr && *setup.over) return false;
    sleep_ms(1);
  }
  return true;
}

Measurement measure(Contender& contender, const Setup& wanted) {
  Board* board = create_board();
  if (board == nullptr) return std::perror("memory for the processes' figures"), Measurement();
  Setup setup = wanted;
  setup.over = &board->stop;
  const Outcome outcome = run(contender, setup, *board);
  Measurement result = collect(setup, *board, outcome);
  ::munmap(board, sizeof(Board));
  return result;
}

void add(const Measurement& measurement, Samples& samples) {
  for (const std::vector<std::uint64_t>& received : measurement.latency_ns) {
    samples.sent += received.size();
    std::copy_if(received.begin(), received.end(), std::back_inserter(samples.latency_ns),
                 [](std::uint64_t ns) { return ns != 0; });
  }
  samples.publishing_ns.insert(samples.publishing_ns.end(), measurement.publishing_ns.begin(),
                               measurement.publishing_ns.end());
}

Row summarize(const Contender& contender, const Setup& setup, Samples samples) {
  Row row{contender.name(), setup.size_bytes, setup.subscribers, samples.sent, samples.latency_ns.size()};
  row.median_us = percentile_us(samples.latency_ns, 50);
  row.p99_us = percentile_us(samples.latency_ns, 99);
  row.publish_us = percentile_us(samples.publishing_ns, 50);
  return row;
}

}  // namespace bench
}  // namespace tzc
