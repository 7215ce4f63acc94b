// SPDX-License-Identifier: BSD-3-Clause
#include "posix/socket.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "posix/address.h"
#include "posix/nonce.h"

namespace tzc {
namespace posix {
namespace {

using std::chrono::milliseconds;

std::string temporary_path() {
  return "/tmp/tzc-test-" + nonce();
}

TEST(Address, RefusesWhatTheSystemCanNotTake) {
  EXPECT_FALSE(parse_address(""));
  EXPECT_FALSE(parse_address("@"));
  EXPECT_FALSE(parse_address(std::string(108, 'x')));
  EXPECT_TRUE(parse_address(std::string(107, 'x')));
}

TEST(Address, GeneratedOnesDiffer) {
  EXPECT_NE(generate_address(), generate_address());
}

TEST(Socket, ConnectsAndKnowsThePeer) {
  auto listener = Listener::listen(generate_address());
  ASSERT_TRUE(listener) << listener.error().text();
  auto client = connect_to(listener->address(), milliseconds(100));
  ASSERT_TRUE(client);
  FileDescriptor server;
  ASSERT_EQ(accept_connection(listener->fd(), server), AcceptResult::accepted);
  EXPECT_EQ(peer_credentials(server.get())->pid, ::getpid());
  EXPECT_EQ(peer_credentials(client->get())->uid, ::getuid());
  EXPECT_EQ(accept_connection(listener->fd(), server), AcceptResult::nothing);
}

TEST(Socket, AnAddressIsTakenOnce) {
  auto listener = Listener::listen(generate_address());
  const auto second = Listener::listen(listener->address());
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().text().find("another process"), std::string::npos) << second.error().text();
}

TEST(Socket, NobodyListensIsAnErrorWithAHint) {
  const auto client = connect_to(generate_address(), milliseconds(100));
  ASSERT_FALSE(client);
  EXPECT_NE(client.error().text().find("nobody listens"), std::string::npos) << client.error().text();
}

TEST(Socket, ASocketFileGoesWithItsListener) {
  const std::string path = temporary_path();
  {
    ASSERT_TRUE(Listener::listen(path));
  }
  EXPECT_NE(::access(path.c_str(), F_OK), 0);
}

TEST(Socket, AKilledProcesssSocketFileIsReplaced) {
  const std::string path = temporary_path();
  const pid_t child = ::fork();
  if (child == 0) {
    auto listener = Listener::listen(path);
    ::_exit(listener ? 0 : 1);  // no destructor: as if killed
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  ASSERT_EQ(::access(path.c_str(), F_OK), 0);
  EXPECT_TRUE(Listener::listen(path));
}

#ifdef TZC_PORTABLE
TEST(Socket, LeftoversOfTheKilledAreSwept) {
  const std::string path = generate_address();
  const pid_t child = ::fork();
  if (child == 0) {
    auto listener = Listener::listen(path);
    ::_exit(listener ? 0 : 1);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  ASSERT_EQ(::access(path.c_str(), F_OK), 0);
  remove_dead_sockets();
  EXPECT_NE(::access(path.c_str(), F_OK), 0);
}
#endif

TEST(Socket, ConnectingToAFullBacklogEndsInTime) {
  auto listener = Listener::listen(generate_address());
  std::vector<FileDescriptor> waiting;
  for (int i = 0; i < 200; ++i) {
    auto client = connect_to(listener->address(), milliseconds(0));
    if (!client) break;
    waiting.push_back(std::move(*client));
  }
  EXPECT_LT(waiting.size(), 200u);
  EXPECT_FALSE(connect_to(listener->address(), milliseconds(20)));
}

}  // namespace
}  // namespace posix
}  // namespace tzc
