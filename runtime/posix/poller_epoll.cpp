// SPDX-License-Identifier: BSD-3-Clause
// Linux: epoll and eventfd.
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "posix/error.h"
#include "posix/file_descriptor.h"
#include "posix/poller.h"

namespace tzc {
namespace posix {
namespace {

constexpr std::uint64_t wake_key = ~std::uint64_t{0};
constexpr int batch = 64;

epoll_event interest(std::uint64_t key, bool readable, bool writable) {
  epoll_event event{};
  event.events = (readable ? unsigned{EPOLLIN} : 0u) | (writable ? unsigned{EPOLLOUT} : 0u);
  event.data.u64 = key;
  return event;
}

class EpollPoller final : public Poller {
 public:
  Status open() {
    epoll_ = FileDescriptor(::epoll_create1(EPOLL_CLOEXEC));
    if (!epoll_) return system_error("create an epoll instance");
    wake_ = FileDescriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
    if (!wake_) return system_error("create an eventfd");
    return watch(wake_.get(), wake_key, true, false);
  }

  Status watch(int fd, std::uint64_t key, bool readable, bool writable) override {
    epoll_event event = interest(key, readable, writable);
    if (::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event) != 0) return system_error("watch a descriptor");
    return Success{};
  }

  void change(int fd, std::uint64_t key, bool readable, bool writable) override {
    epoll_event event = interest(key, readable, writable);
    ::epoll_ctl(epoll_.get(), EPOLL_CTL_MOD, fd, &event);
  }

  void forget(int fd) override { ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, fd, nullptr); }

  void wake() override {
    const std::uint64_t one = 1;
    (void)!::write(wake_.get(), &one, sizeof one);  // a full counter is already a wake-up
  }

  void wait(int timeout_ms, std::vector<Event>& events) override {
    events.clear();
    epoll_event raw[batch];
    const int count = ::epoll_wait(epoll_.get(), raw, batch, timeout_ms);
    for (int i = 0; i < count; ++i) add(raw[i], events);
  }

 private:
  void add(const epoll_event& raw, std::vector<Event>& events) {
    if (raw.data.u64 == wake_key) {
      std::uint64_t count = 0;
      (void)!::read(wake_.get(), &count, sizeof count);
      return;
    }
    Event event;
    event.key = raw.data.u64;
    event.readable = (raw.events & EPOLLIN) != 0;
    event.writable = (raw.events & EPOLLOUT) != 0;
    event.hung_up = (raw.events & (EPOLLHUP | EPOLLERR)) != 0;
    events.push_back(event);
  }

  FileDescriptor epoll_;
  FileDescriptor wake_;
};

}  // namespace

Expected<std::unique_ptr<Poller>> Poller::create() {
  auto poller = std::make_unique<EpollPoller>();
  const Status opened = poller->open();
  if (!opened) return opened.error();
  return {std::unique_ptr<Poller>(std::move(poller))};
}

}  // namespace posix
}  // namespace tzc
