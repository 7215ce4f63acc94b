// SPDX-License-Identifier: BSD-3-Clause
#include "channel/publish/publisher_impl.h"
#include "posix/fork_epoch.h"
#include "posix/hot.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {
namespace {

/// The user's handle. Its destructor ends the publisher.
class PublisherOwner final : public Publisher {
 public:
  explicit PublisherOwner(std::shared_ptr<PublisherImpl> publisher)
      : publisher_(std::move(publisher)), epoch_(posix::fork_epoch()) {}

  // A forked child leaves its copy alone: threads that it does not have may hold the locks in it.
  ~PublisherOwner() override {
    if (posix::forked_since(epoch_)) {
      new std::shared_ptr<PublisherImpl>(std::move(publisher_));
    } else {
      publisher_->shutdown();
    }
  }

  const std::string& address() const override { return publisher_->address(); }
  const std::shared_ptr<SegmentMemory>& memory() const override { return publisher_->memory(); }
  TZC_HOT std::size_t publish(const RecordPtr& record) override {
    return posix::forked_since(epoch_) ? 0 : publisher_->publish(record);
  }
  std::vector<ConnectionPtr> connections() const override {
    return posix::forked_since(epoch_) ? std::vector<ConnectionPtr>() : publisher_->connections();
  }
  PublisherStats stats() const override {
    return posix::forked_since(epoch_) ? PublisherStats() : publisher_->stats();
  }

 private:
  std::shared_ptr<PublisherImpl> publisher_;
  const std::uint32_t epoch_;
};

}  // namespace

Expected<std::shared_ptr<Publisher>> Publisher::create(PublisherOptions options) {
  auto publisher = PublisherImpl::create(std::move(options));
  if (!publisher) return publisher.error();
  return std::shared_ptr<Publisher>(std::make_shared<PublisherOwner>(std::move(*publisher)));
}

}  // namespace channel
}  // namespace tzc
