// SPDX-License-Identifier: BSD-3-Clause
#include "loopback/reserved_port.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>

namespace tzc::loopback::test {
namespace {

using testing::AllOf;
using testing::Ge;
using testing::Lt;

/// A server of 127.0.0.1 that reuses the address, as a ROS master does, or does not.
class Server {
 public:
  Server(int port, bool reuses) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int reuse = reuses ? 1 : 0;
    ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &reuse, sizeof reuse);
    listens_ = ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
               ::listen(socket_, 1) == 0;
  }
  ~Server() { ::close(socket_); }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  bool listens() const { return listens_; }

 private:
  int socket_;
  bool listens_;
};

TEST(ReservedPort, is_below_those_of_outgoing_connections) {
  EXPECT_THAT(ReservedPort().number(), AllOf(Ge(15'000), Lt(32'000)));
}

TEST(ReservedPort, nobody_else_gets_it_while_nobody_listens) {
  const ReservedPort port;
  EXPECT_FALSE(Server(port.number(), false).listens());
  EXPECT_FALSE(is_listened_on(port.number()));
}

TEST(ReservedPort, a_server_that_reuses_the_address_can_listen_and_then_no_other) {
  const ReservedPort port;
  const Server master(port.number(), true);
  EXPECT_TRUE(master.listens());
  EXPECT_TRUE(is_listened_on(port.number()));
  EXPECT_FALSE(Server(port.number(), true).listens());
  EXPECT_FALSE(Server(port.number(), false).listens());
}

TEST(ReservedPort, is_free_again_afterwards) {
  int number = 0;
  {
    const ReservedPort port;
    number = port.number();
  }
  EXPECT_TRUE(Server(number, false).listens());
}

}  // namespace
}  // namespace tzc::loopback::test
