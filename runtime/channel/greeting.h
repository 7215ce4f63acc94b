// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "channel/connection.h"
#include "channel/service.h"
#include "posix/file_descriptor.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

class Hub;

/// A peer that connected and did not introduce itself yet. It has a few seconds.
class Greeting final : public Watcher, public std::enable_shared_from_this<Greeting> {
 public:
  static bool start(Service& service, posix::FileDescriptor socket, const Credentials& credentials,
                    std::weak_ptr<Hub> hub);
  Greeting(Service& service, posix::FileDescriptor socket, const Credentials& credentials,
           std::weak_ptr<Hub> hub);
  ~Greeting() override;

  void on_event(const posix::Poller::Event& event) override;
  void on_deadline() override;

 private:
  void end();

  Service& service_;
  posix::FileDescriptor socket_;
  const Credentials credentials_;
  const std::weak_ptr<Hub> hub_;
  std::uint64_t key_ = 0;
};

/// Parses a Hello packet; false with the reason when it is not one of this version.
bool parse_hello(const std::uint8_t* data, std::size_t size, ConnectionImpl::Peer& peer, std::string& reason);

}  // namespace channel
}  // namespace tzc
