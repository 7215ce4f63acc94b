// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <unistd.h>

#include <cstring>
#include <string>

#include <iceoryx_hoofs/log/logmanager.hpp>
#include <iceoryx_posh/popo/listener.hpp>
#include <iceoryx_posh/popo/untyped_publisher.hpp>
#include <iceoryx_posh/popo/untyped_subscriber.hpp>
#include <iceoryx_posh/popo/wait_set.hpp>
#include <iceoryx_posh/runtime/posh_runtime.hpp>
#include <iceoryx_versions.hpp>

#include "contenders.h"
#include "span.h"

namespace tzc {
namespace bench {
namespace {

using iox::popo::UntypedSubscriber;

// Its log would run through the table.
void start_runtime(const std::string& name) {
  iox::log::LogManager::GetLogManager().SetDefaultLogLevel(iox::log::LogLevel::kOff,
                                                           iox::log::LogLevelOutput::kHideLogLevel);
  iox::runtime::PoshRuntime::initRuntime(iox::RuntimeName_t(iox::cxx::TruncateToCapacity, name.c_str()));
}

iox::capro::ServiceDescription service(const Setup& setup) {
  return {"tzc-bench", {iox::cxx::TruncateToCapacity, setup.name.c_str()}, "image"};
}

void take_all(UntypedSubscriber& subscriber, Recorder& recorder) {
  bool more = true;
  while (more) {
    more = false;
    subscriber.take().and_then([&](const void* payload) {
      Stamp stamp{};
      std::memcpy(&stamp, payload, sizeof stamp);
      recorder.record(stamp);
      subscriber.release(payload);
      more = true;
    });
  }
}

void on_data(UntypedSubscriber* subscriber, Recorder* recorder) {
  take_all(*subscriber, *recorder);
}

class IceoryxContender final : public Contender {
 public:
  explicit IceoryxContender(bool listener) : listener_(listener) {}

  const char* name() const override { return listener_ ? "iceoryx-listener" : "iceoryx-waitset"; }
  bool cleans_up_at_exit() const override { return true; }
  Daemon needs() const override { return Daemon::roudi; }
  std::size_t memory_bytes(const Setup& setup) const override { return shared_memory_bytes(setup, false); }
  bool supports(const Setup& setup) const override { return setup.size_bytes <= most_bytes_of_iceoryx; }

  void subscribe(const Setup& setup, std::size_t who, Recorder& recorder) override {
    start_runtime(setup.name + "-s" + std::to_string(who));
    iox::popo::SubscriberOptions options;
    options.queueCapacity = 10;
    UntypedSubscriber subscriber(service(setup), options);
    while (subscriber.getSubscriptionState() != iox::SubscribeState::SUBSCRIBED) {
      if (recorder.stop()) return;
      ::usleep(1000);
    }
    listener_ ? listen(subscriber, recorder) : wait(subscriber, recorder);
  }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    start_runtime(setup.name + "-p");
    iox::popo::PublisherOptions options;
    options.historyCapacity = 0;
    const auto publisher = std::make_shared<iox::popo::UntypedPublisher>(service(setup), options);
    return [publisher, setup](std::uint64_t index) {
      const Span span(setup, index);
      publisher->loan(static_cast<std::uint32_t>(setup.size_bytes)).and_then([&](auto& payload) {
        span.fill(payload, setup.size_bytes);
        const Stamp stamp = span.stamp();
        std::memcpy(payload, &stamp, sizeof stamp);
        publisher->publish(payload);
      });
    };
  }

 private:
  static void listen(UntypedSubscriber& subscriber, Recorder& recorder) {
    iox::popo::Listener listener;
    listener
        .attachEvent(subscriber, iox::popo::SubscriberEvent::DATA_RECEIVED,
                     iox::popo::createNotificationCallback(on_data, recorder))
        .or_else([](auto) { ::_exit(1); });
    recorder.ready();
    while (!recorder.stop()) ::usleep(250'000);
  }

  static void wait(UntypedSubscriber& subscriber, Recorder& recorder) {
    iox::popo::WaitSet<> wait_set;
    wait_set.attachState(subscriber, iox::popo::SubscriberState::HAS_DATA).or_else([](auto) { ::_exit(1); });
    recorder.ready();
    while (!recorder.stop()) {
      wait_set.timedWait(iox::units::Duration::fromMilliseconds(100));
      take_all(subscriber, recorder);
    }
  }

  const bool listener_;
};

}  // namespace

std::unique_ptr<Contender> iceoryx_listener_contender() {
  return std::make_unique<IceoryxContender>(true);
}
std::unique_ptr<Contender> iceoryx_waitset_contender() {
  return std::make_unique<IceoryxContender>(false);
}

std::string iceoryx_version() {
  return ICEORYX_LATEST_RELEASE_VERSION;
}

}  // namespace bench
}  // namespace tzc
