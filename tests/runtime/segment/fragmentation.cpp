// SPDX-License-Identifier: BSD-3-Clause
// usage: fragmentation [ALLOCATIONS]
// What the allocator wastes under mixed sizes, measured against the best possible: the highest address that it ever
// used, over the most bytes that were in use at a time. Publishers of 1 KB to 30 MB with queues of 1 to 1000 share one
// address space; each keeps its newest messages, and a reader sometimes holds one for long. By default 200,000 allocations
// for each mix (the test run); 10,000,000 by hand. Fails when a mix needs more than its bound.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <random>
#include <vector>

#include "posix/mapping.h"
#include "segment/extents.h"
#include "segment/size_class.h"

namespace tzc {
namespace segment {
namespace {

constexpr std::uint64_t kb = 1 << 10, mb = 1 << 20;
constexpr double most_waste = 1.5;  // of practice; Robson's bound is for the worst case

struct Topic {
  std::uint64_t smallest, largest;  // bytes of a message, uniform in the logarithm
  std::size_t queue;
};

struct Mix {
  const char* name;
  std::vector<Topic> topics;
  unsigned held_one_in;  // so many messages one is held for long; 0: none
};

struct Block {
  std::uint64_t offset, bytes;
};

struct Result {
  std::uint64_t most_in_use = 0, highest = 0, looked_at = 0;
  double waste() const { return static_cast<double>(highest) / static_cast<double>(most_in_use); }
};

class Run {
 public:
  explicit Run(const Mix& mix) : mix_(mix), queues_(mix.topics.size()) {}

  Result allocate(std::uint64_t allocations) {
    for (std::uint64_t i = 0; i < allocations; ++i) publish(random_() % mix_.topics.size());
    result_.looked_at = extents_.looked_at();
    return result_;
  }

 private:
  void publish(std::size_t topic) {
    std::deque<Block>& queue = queues_[topic];
    if (queue.size() == mix_.topics[topic].queue) {
      end(queue.front());
      queue.pop_front();
    }
    queue.push_back(place(size_of(mix_.topics[topic])));
  }

  // A reader lets go of its oldest message when it takes another one.
  void end(const Block& block) {
    if (mix_.held_one_in == 0 || random_() % mix_.held_one_in != 0) return release(block);
    held_.push_back(block);
    if (held_.size() <= most_held) return;
    release(held_.front());
    held_.pop_front();
  }

  Block place(std::uint64_t bytes) {
    const std::uint64_t alignment = has_own_pages(bytes, page_) ? page_ : cache_line;
    const Block block{extents_.allocate(bytes, Extents::none, alignment), bytes};
    in_use_ += bytes;
    result_.most_in_use = std::max(result_.most_in_use, in_use_);
    result_.highest = std::max(result_.highest, block.offset + bytes);
    return block;
  }

  void release(const Block& block) {
    extents_.release(block.offset, block.bytes);
    in_use_ -= block.bytes;
  }

  std::uint64_t size_of(const Topic& topic) {
    std::uniform_real_distribution<double> logarithm(std::log(static_cast<double>(topic.smallest)),
                                                     std::log(static_cast<double>(topic.largest)));
    const auto bytes = static_cast<std::size_t>(std::exp(logarithm(random_)));
    return occupied_bytes(bytes, page_);
  }

  static constexpr std::size_t most_held = 16;

  const Mix& mix_;
  const std::size_t page_ = posix::page_size();
  std::mt19937_64 random_{1};
  Extents extents_{0, std::uint64_t{1} << 50};
  std::vector<std::deque<Block>> queues_;
  std::deque<Block> held_;
  std::uint64_t in_use_ = 0;
  Result result_;
};

const std::vector<Mix>& mixes() {
  static const std::vector<Mix> all{
      {"one size", {{4 * mb, 4 * mb, 10}}, 0},
      {"one size, held", {{4 * mb, 4 * mb, 10}}, 20},
      {"clouds that vary", {{mb, 4 * mb, 10}}, 0},
      {"clouds that vary, held", {{mb, 4 * mb, 10}}, 20},
      {"1 KB beside 30 MB", {{kb, kb, 1000}, {30 * mb, 30 * mb, 1}}, 20},
      {"1 KB to 30 MB, queue 1", {{kb, 30 * mb, 1}}, 20},
      {"1 KB to 30 MB, queue 10", {{kb, 30 * mb, 10}}, 20},
      {"1 KB to 30 MB, queue 1000", {{kb, 30 * mb, 1000}}, 20},
      {"a robot", {{kb, 16 * kb, 1000}, {100 * kb, mb, 100}, {mb, 8 * mb, 10}, {30 * mb, 30 * mb, 2}}, 50},
  };
  return all;
}

int run(std::uint64_t allocations) {
  int failures = 0;
  std::printf("%-28s %12s %12s %8s %10s\n", "mix", "most in use", "address", "waste", "looks/call");
  for (const Mix& mix : mixes()) {
    const Result result = Run(mix).allocate(allocations);
    const bool wasteful = result.waste() > most_waste;
    std::printf("%-28s %9llu MB %9llu MB %8.3f %10.2f%s\n", mix.name,
                static_cast<unsigned long long>(result.most_in_use / mb),
                static_cast<unsigned long long>(result.highest / mb), result.waste(),
                static_cast<double>(result.looked_at) / static_cast<double>(allocations),
                wasteful ? "  TOO MUCH" : "");
    std::fflush(stdout);
    failures += wasteful ? 1 : 0;
  }
  return failures;
}

}  // namespace
}  // namespace segment
}  // namespace tzc

int main(int argc, char** argv) {
  const long long allocations = argc > 1 ? std::atoll(argv[1]) : 200'000;
  if (argc > 2 || allocations <= 0) {
    std::fprintf(stderr, "usage: fragmentation [ALLOCATIONS]\n");
    return 2;
  }
  return tzc::segment::run(static_cast<std::uint64_t>(allocations)) == 0 ? 0 : 1;
}
