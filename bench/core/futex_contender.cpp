// SPDX-License-Identifier: BSD-3-Clause
#include <linux/futex.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <climits>

#include "contenders.h"

namespace tzc {
namespace bench {
namespace {

struct Mailbox {
  std::atomic<std::uint32_t> count;
  Stamp stamp;
};

void futex(std::atomic<std::uint32_t>& word, int operation, std::uint32_t value) {
  ::syscall(SYS_futex, &word, operation, value, nullptr, nullptr, 0);
}

class FutexContender final : public Contender {
 public:
  const char* name() const override { return "futex"; }
  std::size_t memory_bytes(const Setup&) const override { return 0; }

  void prepare(const Setup&) override {
    if (boxes_ != nullptr) ::munmap(boxes_, sizeof(Mailbox) * most_subscribers);
    void* memory = ::mmap(nullptr, sizeof(Mailbox) * most_subscribers, PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    boxes_ = memory == MAP_FAILED ? nullptr : static_cast<Mailbox*>(memory);
  }

  void subscribe(const Setup&, std::size_t who, Recorder& recorder) override {
    Mailbox& box = boxes_[who];
    recorder.ready();
    for (std::uint32_t seen = 0; !recorder.stop();) {
      futex(box.count, FUTEX_WAIT, seen);
      if (box.count.load(std::memory_order_acquire) == seen) continue;
      seen = box.count;
      recorder.record(box.stamp);
    }
  }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    return [this, setup](std::uint64_t index) {
      const Stamp stamp{now_ns(), index};
      for (std::size_t who = 0; who < setup.subscribers; ++who) {
        boxes_[who].stamp = stamp;
        boxes_[who].count.fetch_add(1, std::memory_order_release);
        futex(boxes_[who].count, FUTEX_WAKE, INT_MAX);
      }
    };
  }

 private:
  Mailbox* boxes_ = nullptr;
};

}  // namespace

std::unique_ptr<Contender> futex_contender() {
  return std::make_unique<FutexContender>();
}

}  // namespace bench
}  // namespace tzc
