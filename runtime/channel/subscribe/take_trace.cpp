// SPDX-License-Identifier: BSD-3-Clause
#include "channel/subscribe/take_trace.h"

#include "channel/inspection.h"
#include "channel/wire/shared_page.h"
#include "trace/trace.h"

namespace tzc {
namespace channel {
namespace {

using trace::Arrow;
using trace::Step;

trace::ChannelName name_of(const SubscriberOptions& options) {
  return trace::active ? trace::name_of_channel(options.address) : trace::ChannelName();
}

}  // namespace

TakeTrace::TakeTrace(const SubscriberOptions& options, std::uint64_t connection)
    : TakeTrace(name_of(options), connection, options.own_thread) {}

TakeTrace::TakeTrace(const trace::ChannelName& name, std::uint64_t connection, bool calls_back)
    : topic_(trace::active ? trace::keep(name.topic) : ""),
      connection_(connection),
      calls_back_(calls_back),
      passes_on_(name.passes_on) {}

void TakeTrace::woken() {
  woken_ns_ = trace::now();
}

void TakeTrace::taking() {
  taking_ns_ = trace::now();
}

std::uint64_t TakeTrace::taken(std::uint32_t sequence, std::size_t bytes) const {
  const std::uint64_t message = trace_id(connection_, sequence);
  trace::record({woken_ns_, taking_ns_, message, 0, topic_, 0, Step::wake, Arrow::none});
  trace::record(Step::take, calls_back_ ? Arrow::passes : Arrow::ends, message, topic_, taking_ns_, bytes);
  return message;
}

void TakeTrace::call_back(const SubscriberOptions& options, const MessagePtr& message) const {
  const std::uint64_t begin = trace::now();
  options.on_message(message);
  if (!passes_on_) trace::record(Step::callback, Arrow::ends, trace_id(*message), topic_, begin);
}

}  // namespace channel
}  // namespace tzc
