// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "contenders.h"
#include "span.h"

namespace tzc {
namespace bench {
namespace {

struct RingHeader {
  pthread_mutex_t mutex;
  pthread_cond_t written_more;
  std::uint64_t written;  // frames, ever; the newest ones are in the ring
};

constexpr std::size_t header_bytes = 4096;
static_assert(sizeof(RingHeader) <= header_bytes, "frames begin on a page");

/// Shared memory without a name: the name is gone before another process could learn it.
void* map_shared(std::size_t bytes) {
  const std::string name = "/tzc-bench-ach-" + std::to_string(::getpid());
  const int fd = ::shm_open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (fd < 0) return nullptr;
  ::shm_unlink(name.c_str());
  const bool large_enough = ::posix_fallocate(fd, 0, static_cast<off_t>(bytes)) == 0;
  void* memory =
      large_enough ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0) : MAP_FAILED;
  ::close(fd);
  return memory == MAP_FAILED ? nullptr : memory;
}

/// Frames of one size; the oldest one is overwritten. Whoever copies holds the mutex.
class Ring {
 public:
  /// inherits: whoever holds the mutex has the priority of those who wait for it.
  Ring(std::size_t frame_bytes, std::size_t frames, bool inherits)
      : frame_bytes_(frame_bytes), frames_(frames), bytes_(header_bytes + frame_bytes * frames) {
    header_ = static_cast<RingHeader*>(map_shared(bytes_));
    if (header_ != nullptr) start(inherits);
  }
  ~Ring() {
    if (header_ != nullptr) ::munmap(header_, bytes_);
  }
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  bool usable() const { return header_ != nullptr; }

  void put(const char* frame) {
    ::pthread_mutex_lock(&header_->mutex);
    std::memcpy(place_of(header_->written), frame, frame_bytes_);
    ++header_->written;
    ::pthread_cond_broadcast(&header_->written_more);
    ::pthread_mutex_unlock(&header_->mutex);
  }

  /// Waits for frame `next`, or takes the oldest one when that is gone; returns the number of the one after.
  std::uint64_t get(std::uint64_t next, char* frame) {
    ::pthread_mutex_lock(&header_->mutex);
    while (header_->written <= next) ::pthread_cond_wait(&header_->written_more, &header_->mutex);
    next = std::max(next, header_->written - std::min<std::uint64_t>(header_->written, frames_));
    std::memcpy(frame, place_of(next), frame_bytes_);
    ::pthread_mutex_unlock(&header_->mutex);
    return next + 1;
  }

 private:
  void start(bool inherits) {
    pthread_mutexattr_t mutex;
    ::pthread_mutexattr_init(&mutex);
    ::pthread_mutexattr_setpshared(&mutex, PTHREAD_PROCESS_SHARED);
    if (inherits) ::pthread_mutexattr_setprotocol(&mutex, PTHREAD_PRIO_INHERIT);
    ::pthread_mutex_init(&header_->mutex, &mutex);
    pthread_condattr_t condition;
    ::pthread_condattr_init(&condition);
    ::pthread_condattr_setpshared(&condition, PTHREAD_PROCESS_SHARED);
    ::pthread_cond_init(&header_->written_more, &condition);
  }

  char* place_of(std::uint64_t number) const {
    return reinterpret_cast<char*>(header_) + header_bytes + number % frames_ * frame_bytes_;
  }

  const std::size_t frame_bytes_, frames_, bytes_;
  RingHeader* header_ = nullptr;
};

class AchContender final : public Contender {
 public:
  const char* name() const override { return "ach"; }
  std::size_t memory_bytes(const Setup& setup) const override { return shared_memory_bytes(setup, true); }

  void prepare(const Setup& setup) override {
    ring_.reset();
    ring_ = std::make_unique<Ring>(frame_bytes(setup), setup.queue_size, setup.real_time);
    if (!ring_->usable()) std::fprintf(stderr, "ach: no shared memory for %zu messages\n", setup.queue_size);
  }

  void subscribe(const Setup& setup, std::size_t, Recorder& recorder) override {
    if (!ring_->usable()) return;
    std::vector<char> frame(frame_bytes(setup));
    recorder.ready();
    for (std::uint64_t next = 0; !recorder.stop();) {
      next = ring_->get(next, frame.data());
      Stamp stamp{};
      std::memcpy(&stamp, frame.data(), sizeof stamp);
      recorder.record(stamp);
    }
  }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    const auto frame = std::make_shared<std::vector<char>>(frame_bytes(setup));
    return [this, frame, setup](std::uint64_t index) {
      const Span span(setup, index);
      span.fill(frame->data(), frame->size());
      const Stamp stamp = span.stamp();
      std::memcpy(frame->data(), &stamp, sizeof stamp);
      ring_->put(frame->data());
    };
  }

 private:
  static std::size_t frame_bytes(const Setup& setup) { return std::max(setup.size_bytes, sizeof(Stamp)); }

  std::unique_ptr<Ring> ring_;
};

}  // namespace

std::unique_ptr<Contender> ach_contender() {
  return std::make_unique<AchContender>();
}

}  // namespace bench
}  // namespace tzc
