// SPDX-License-Identifier: BSD-3-Clause
#include "channel/hub.h"
#include "posix/fork_epoch.h"
#include "posix/hot.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {
namespace {

/// The user's handle: its end is the end of the publisher.
class PublisherHandle final : public Publisher {
 public:
  explicit PublisherHandle(std::shared_ptr<Hub> hub) : hub_(std::move(hub)), epoch_(posix::fork_epoch()) {}

  // A forked child can't use its copy, and the locks in it may be held by threads that it does not have: let
  // it be.
  ~PublisherHandle() override {
    if (posix::forked_since(epoch_)) {
      new std::shared_ptr<Hub>(std::move(hub_));
    } else {
      hub_->shutdown();
    }
  }

  const std::string& address() const override { return hub_->address(); }
  const std::shared_ptr<SegmentMemory>& memory() const override { return hub_->memory(); }
  TZC_HOT std::size_t publish(const RecordPtr& record) override {
    return posix::forked_since(epoch_) ? 0 : hub_->publish(record);
  }
  std::vector<ConnectionPtr> connections() const override { return hub_->connections(); }
  PublisherStats stats() const override { return hub_->stats(); }

 private:
  std::shared_ptr<Hub> hub_;
  const std::uint32_t epoch_;
};

}  // namespace

Expected<std::shared_ptr<Publisher>> Publisher::create(PublisherOptions options) {
  auto hub = Hub::create(std::move(options));
  if (!hub) return hub.error();
  return std::shared_ptr<Publisher>(std::make_shared<PublisherHandle>(std::move(*hub)));
}

}  // namespace channel
}  // namespace tzc
