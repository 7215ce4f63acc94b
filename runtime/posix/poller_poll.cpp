// SPDX-License-Identifier: BSD-3-Clause
// Portable: poll and a pipe.
#include <fcntl.h>
#include <poll.h>
#include <sys/select.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <mutex>

#include "posix/error.h"
#include "posix/file_descriptor.h"
#include "posix/poller.h"

namespace tzc {
namespace posix {
namespace {

struct Interest {
  std::uint64_t key;
  short events;
};

void add_to_sets(const pollfd& entry, fd_set& readable, fd_set& writable) {
  if ((entry.events & POLLIN) != 0) FD_SET(entry.fd, &readable);
  if ((entry.events & POLLOUT) != 0) FD_SET(entry.fd, &writable);
}

short look_up(const pollfd& entry, const fd_set& readable, const fd_set& writable) {
  const bool in = FD_ISSET(entry.fd, &readable) != 0, out = FD_ISSET(entry.fd, &writable) != 0;
  return static_cast<short>((in ? POLLIN : 0) | (out ? POLLOUT : 0));
}

// Sees descriptors below FD_SETSIZE, and a hang-up as something to read.
int wait_by_select(std::vector<pollfd>& list, int timeout_ms) {
  fd_set readable, writable;
  FD_ZERO(&readable);
  FD_ZERO(&writable);
  int above = 0;
  for (const pollfd& entry : list) {
    if (entry.fd >= FD_SETSIZE) continue;
    add_to_sets(entry, readable, writable);
    above = std::max(above, entry.fd + 1);
  }
  timeval timeout{timeout_ms / 1000, timeout_ms % 1000 * 1000};
  const int ready = ::select(above, &readable, &writable, nullptr, timeout_ms < 0 ? nullptr : &timeout);
  for (pollfd& entry : list)
    entry.revents = ready > 0 && entry.fd < FD_SETSIZE ? look_up(entry, readable, writable) : short{0};
  return ready;
}

// poll refuses a list that is longer than the limit on descriptors, which may have been lowered below
// what is open; select looks at no limit.
int wait_for_any(std::vector<pollfd>& list, int timeout_ms) {
  const int ready = ::poll(list.data(), static_cast<nfds_t>(list.size()), timeout_ms);
  return ready < 0 && errno == EINVAL ? wait_by_select(list, timeout_ms) : ready;
}

class PollPoller final : public Poller {
 public:
  Status open() {
    int ends[2];
    if (::pipe(ends) != 0) return system_error("create a pipe");
    wake_read_ = FileDescriptor(ends[0]);
    wake_write_ = FileDescriptor(ends[1]);
    for (const int end : ends) {
      ::fcntl(end, F_SETFD, FD_CLOEXEC);
      ::fcntl(end, F_SETFL, O_NONBLOCK);
    }
    return Success{};
  }

  Status watch(int fd, std::uint64_t key, bool readable, bool writable) override {
    change(fd, key, readable, writable);
    return Success{};
  }

  void change(int fd, std::uint64_t key, bool readable, bool writable) override {
    const short events = static_cast<short>((readable ? POLLIN : 0) | (writable ? POLLOUT : 0));
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      interests_[fd] = Interest{key, events};
    }
    wake();  // a running poll has the old list
  }

  void forget(int fd) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    interests_.erase(fd);
  }

  void wake() override { (void)!::write(wake_write_.get(), "", 1); }

  void wait(int timeout_ms, std::vector<Event>& events) override {
    events.clear();
    std::vector<pollfd> list = current_list();
    if (wait_for_any(list, timeout_ms) <= 0) return;
    if (list[0].revents != 0) drain_wakes();
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::size_t i = 1; i < list.size(); ++i) add(list[i], events);
  }

 private:
  std::vector<pollfd> current_list() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<pollfd> list{pollfd{wake_read_.get(), POLLIN, 0}};
    for (const auto& entry : interests_) list.push_back(pollfd{entry.first, entry.second.events, 0});
    return list;
  }

  void drain_wakes() {
    char bytes[64];
    while (::read(wake_read_.get(), bytes, sizeof bytes) > 0) {
    }
  }

  void add(const pollfd& raw, std::vector<Event>& events) {
    const auto found = interests_.find(raw.fd);
    if (raw.revents == 0 || found == interests_.end()) return;
    Event event;
    event.key = found->second.key;
    event.readable = (raw.revents & POLLIN) != 0;
    event.writable = (raw.revents & POLLOUT) != 0;
    event.hung_up = (raw.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
    events.push_back(event);
  }

  std::mutex mutex_;
  std::map<int, Interest> interests_;
  FileDescriptor wake_read_;
  FileDescriptor wake_write_;
};

}  // namespace

Expected<std::unique_ptr<Poller>> Poller::create() {
  auto poller = std::make_unique<PollPoller>();
  const Status opened = poller->open();
  if (!opened) return opened.error();
  return {std::unique_ptr<Poller>(std::move(poller))};
}

}  // namespace posix
}  // namespace tzc
