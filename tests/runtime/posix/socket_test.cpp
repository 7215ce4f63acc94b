// SPDX-License-Identifier: BSD-3-Clause
#include "posix/socket.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <set>
#include <string>

#include "posix/address.h"
#include "posix/nonce.h"

namespace {
bool is_entropy_forbidden = false;
}

/// In place of the C library's, which some sandboxes let fail.
extern "C" int getentropy(void* to, std::size_t bytes) {
  if (is_entropy_forbidden) return errno = ENOSYS, -1;
  return ::syscall(SYS_getrandom, to, bytes, 0) == static_cast<long>(bytes) ? 0 : -1;
}

namespace tzc {
namespace posix {
namespace {

using std::chrono::milliseconds;

std::string temporary_path() {
  return "/tmp/tzc-test-" + nonce();
}

TEST(Address, refuses_what_the_system_cannot_take) {
  EXPECT_FALSE(parse_address(""));
  EXPECT_FALSE(parse_address("@"));
  EXPECT_FALSE(parse_address(std::string(108, 'x')));
  EXPECT_TRUE(parse_address(std::string(107, 'x')));
}

// A process that has no descriptor left may still have to name an address.
TEST(Nonce, needs_no_descriptor) {
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_NOFILE, &none);
    const std::string one = nonce(), other = nonce();
    ::_exit(one.size() == 32 && other.size() == 32 && one != other ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0) << "status " << status;
}

TEST(Nonce, needs_no_call_that_a_sandbox_may_forbid) {
  is_entropy_forbidden = true;
  std::set<std::string> names;
  std::set<std::uint64_t> numbers;
  for (int i = 0; i < 1000; ++i) names.insert(nonce()), numbers.insert(random_number());
  is_entropy_forbidden = false;
  EXPECT_EQ(names.size(), 1000u);
  EXPECT_EQ(numbers.size(), 1000u);
}

TEST(Address, generated_ones_differ) {
  EXPECT_NE(generate_address(), generate_address());
}

TEST(Socket, connects_and_knows_the_peer) {
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

TEST(Socket, an_address_is_taken_once) {
  auto listener = Listener::listen(generate_address());
  const auto second = Listener::listen(listener->address());
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().text().find("another process"), std::string::npos) << second.error().text();
}

TEST(Socket, no_listener_is_an_error_with_a_hint) {
  const auto client = connect_to(generate_address(), milliseconds(100));
  ASSERT_FALSE(client);
  EXPECT_NE(client.error().text().find("no process listens"), std::string::npos) << client.error().text();
}

TEST(Socket, a_socket_file_goes_with_its_listener) {
  const std::string path = temporary_path();
  {
    ASSERT_TRUE(Listener::listen(path));
  }
  EXPECT_NE(::access(path.c_str(), F_OK), 0);
}

TEST(Socket, a_killed_processs_socket_file_is_replaced) {
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
TEST(Socket, leftovers_of_the_killed_are_swept) {
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

TEST(Socket, connecting_to_a_full_backlog_ends_in_time) {
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
