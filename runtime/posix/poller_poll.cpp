// SPDX-License-Identifier: BSD-3-Clause
// Portable: poll and a pipe.
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

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
    if (::poll(list.data(), static_cast<nfds_t>(list.size()), timeout_ms) <= 0) return;
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
