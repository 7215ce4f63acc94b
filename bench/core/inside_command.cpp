// SPDX-License-Identifier: BSD-3-Clause
// The publisher's own work, without what the kernel does for a socket write.
#include <benchmark/benchmark.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <thread>

#include "commands.h"
#include "inside_report.h"
#include "tzc/channel.h"

namespace tzc {
namespace bench {
namespace {

constexpr std::size_t mb = 1 << 20;
constexpr char control[64] = {};

std::shared_ptr<channel::Publisher> publisher(std::size_t memory_size) {
  MemoryOptions memory;
  memory.size = memory_size;
  channel::PublisherOptions options;
  options.queue_size = 4;
  options.memory = *SegmentMemory::create(memory);
  return *channel::Publisher::create(options);
}

void publish_one(channel::Publisher& out, std::size_t bytes) {
  out.publish(channel::make_record(0, control, sizeof control, {out.memory()->allocate(bytes)}));
}

// For the JSON file's rows.
void describe(benchmark::State& state, std::size_t size_bytes, std::size_t subscribers) {
  state.counters["size_bytes"] = static_cast<double>(size_bytes);
  state.counters["subscribers"] = static_cast<double>(subscribers);
}

void allocate(benchmark::State& state) {
  const auto out = publisher(64 * mb);
  for (auto _ : state)
    benchmark::DoNotOptimize(out->memory()->allocate(static_cast<std::size_t>(state.range(0))));
  describe(state, static_cast<std::size_t>(state.range(0)), 0);
}
BENCHMARK(allocate)->Arg(4096)->Arg(4 * mb);

// Every socket is full and every record replaces the oldest in the queue: the whole protocol, but each write
// fails at once. Subtract refused_write for each subscriber.
void allocate_publish_to_stopped(benchmark::State& state) {
  const auto out = publisher(64 * mb);
  std::vector<std::shared_ptr<channel::Subscriber>> stopped;
  for (int i = 0; i < state.range(0); ++i) {
    channel::SubscriberOptions options;
    options.address = out->address();
    options.own_thread = false;
    stopped.push_back(*channel::Subscriber::create(options));
  }
  for (int i = 0; i < 2000; ++i) publish_one(*out, 4 * mb);  // fills the sockets, warms the segment
  for (auto _ : state) publish_one(*out, 4 * mb);
  describe(state, 4 * mb, static_cast<std::size_t>(state.range(0)));
}
BENCHMARK(allocate_publish_to_stopped)->Arg(0)->Arg(1)->Arg(8);

// A subscriber that reads at once: includes one socket write and one wake-up; compare with bare_write.
void allocate_publish_to_reader(benchmark::State& state) {
  const auto out = publisher(64 * mb);
  std::atomic<std::uint64_t> received{0};
  channel::SubscriberOptions options;
  options.address = out->address();
  options.on_message = [&received](const channel::MessagePtr&) { ++received; };
  const auto in = *channel::Subscriber::create(options);
  std::uint64_t sent = 0;
  for (auto _ : state) {
    publish_one(*out, 4 * mb);
    ++sent;
    state.PauseTiming();
    while (received + in->stats().lost < sent) std::this_thread::yield();
    state.ResumeTiming();
  }
  describe(state, 4 * mb, 1);
}
BENCHMARK(allocate_publish_to_reader)->Iterations(20000);

void bare_write(benchmark::State& state) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends) != 0) return;
  std::atomic<std::uint64_t> received{0};
  char record[128] = {};
  std::thread reader([&] {
    char memory[128];
    while (::recv(ends[1], memory, sizeof memory, 0) > 0) ++received;
  });
  std::uint64_t sent = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(::send(ends[0], record, sizeof record, MSG_DONTWAIT | MSG_NOSIGNAL));
    ++sent;
    state.PauseTiming();
    while (received < sent) std::this_thread::yield();
    state.ResumeTiming();
  }
  ::close(ends[0]);
  reader.join();
  ::close(ends[1]);
}
BENCHMARK(bare_write)->Iterations(20000);

void refused_write(benchmark::State& state) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends) != 0) return;
  char record[128] = {};
  while (::send(ends[0], record, sizeof record, MSG_DONTWAIT) > 0) {
  }
  for (auto _ : state)
    benchmark::DoNotOptimize(::send(ends[0], record, sizeof record, MSG_DONTWAIT | MSG_NOSIGNAL));
  ::close(ends[0]);
  ::close(ends[1]);
}
BENCHMARK(refused_write);

void find_buffer_of_an_address(benchmark::State& state) {
  const auto out = publisher(64 * mb);
  std::vector<BufferPtr> live;
  for (int i = 0; i < state.range(0); ++i) live.push_back(out->memory()->allocate(4096));
  for (auto _ : state) benchmark::DoNotOptimize(find_buffer(live.back()->data() + 100, 100));
}
BENCHMARK(find_buffer_of_an_address)->Arg(1)->Arg(1000);

}  // namespace

int run_inside(int argc, char** argv) {
  return run_and_report(argc, argv);
}

}  // namespace bench
}  // namespace tzc
