// SPDX-License-Identifier: BSD-3-Clause
// 1 publisher, 8 subscribers, 4 MB at 200 Hz for a minute: is anything lost, does memory stay flat?
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "commands.h"
#include "contenders.h"
#include "options.h"
#include "process_needs.h"
#include "processes.h"
#include "tzc/channel.h"

namespace tzc {
namespace bench {
namespace {

/// The ordinary tzc contender, watched: prints the publisher's memory early and late.
class Watched final : public Contender {
 public:
  const char* name() const override { return "tzc-sustained"; }
  void subscribe(const Setup& setup, std::size_t who, Recorder& recorder) override {
    inner_->subscribe(setup, who, recorder);
  }
  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    return [inner = inner_->publish(setup), setup](std::uint64_t index) {
      inner(index);
      if (index == setup.count / 10 || index + 1 == setup.count)
        std::printf("publisher after %llu messages: %zu KB private, %zu KB of segments\n",
                    static_cast<unsigned long long>(index), status_kb(::getpid(), "RssAnon"),
                    status_kb(::getpid(), "RssShmem"));
      std::fflush(stdout);
    };
  }

 private:
  const std::unique_ptr<Contender> inner_ = tzc_reader_contender();
};

}  // namespace

int run_sustained(int argc, char** argv) {
  Options options;
  options.sizes = {4 << 20};
  options.subscribers = {8};
  options.rate = 200;
  options.count = 200 * 60;
  const auto over =
      parse_one_case(argc, argv, "Sends for a minute: is anything lost, does memory stay flat?", options);
  if (over) return *over;
  hold_interrupts();
  Watched contender;
  const Setup setup{
      options.sizes.front(), options.subscribers.front(), options.rate, options.count, unique_name(), 40};
  const Measurement measurement = measure(contender, setup);
  if (measurement.outcome == Outcome::interrupted) return interrupted_status;
  if (measurement.outcome == Outcome::failed) return std::fprintf(stderr, "the measurement has failed\n"), 1;
  Samples samples;
  add(measurement, samples);
  const Row row = summarize(contender, setup, std::move(samples));
  print_table({row});
  const bool complete = row.delivered == row.sent;
  if (!complete) std::fprintf(stderr, "%zu messages were lost\n", row.sent - row.delivered);
  const bool written = options.json.empty() || write_json(options.json, {row});
  return complete && written ? 0 : 1;
}

}  // namespace bench
}  // namespace tzc
