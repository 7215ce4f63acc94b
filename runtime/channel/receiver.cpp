// SPDX-License-Identifier: BSD-3-Clause
#include "channel/receiver.h"

#include <algorithm>
#include <atomic>

#include "posix/fork_epoch.h"
#include "posix/futex.h"
#include "posix/thread.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::uint32_t nobody = ~std::uint32_t{0};
// A publisher that clears the bits of others, or does not ring, delays messages by this time.
constexpr std::chrono::seconds between_looks_at_all{1};
constexpr std::chrono::milliseconds between_questions{1};  // to an end that may not be read yet

std::atomic<Receiver*> current{nullptr};
std::mutex start_mutex;

}  // namespace

DoorbellNumber::DoorbellNumber(Receiver& receiver, std::uint32_t number)
    : receiver_(receiver), number_(number) {}

DoorbellNumber::~DoorbellNumber() {
  receiver_.give_back(number_);
}

const std::shared_ptr<Doorbell>& DoorbellNumber::doorbell() const {
  return receiver_.doorbell_;
}

void DoorbellNumber::begin(std::shared_ptr<ReceivingEnd> end) {
  receiver_.begin(number_, std::move(end));
}

void DoorbellNumber::end() {
  receiver_.end(number_);
}

// A forked child starts a receiver of its own and leaves the parent's object alone: its locks may be in any state.
Expected<Receiver*> Receiver::instance() {
  Receiver* receiver = current.load(std::memory_order_acquire);
  if (receiver != nullptr && !posix::forked_since(receiver->epoch_)) return receiver;
  const std::lock_guard<std::mutex> lock(start_mutex);
  receiver = current.load(std::memory_order_acquire);
  if (receiver != nullptr && !posix::forked_since(receiver->epoch_)) return receiver;
  return start();
}

Expected<Receiver*> Receiver::start() {
  if (!posix::has_shared_futex()) {
    Error error;
    error.what = "read for many subscribers on one thread: this system has no futex that processes share";
    return error;
  }
  auto doorbell = Doorbell::create();
  if (!doorbell) return doorbell.error();
  std::unique_ptr<Receiver> receiver(new Receiver(std::move(*doorbell)));
  auto thread = posix::start_thread("tzc-reader", [raw = receiver.get()] { raw->run(); });
  if (!thread) return thread.error();
  receiver->thread_ = std::move(*thread);
  current.store(receiver.get(), std::memory_order_release);
  return receiver.release();
}

Receiver::Receiver(std::shared_ptr<Doorbell> doorbell)
    : doorbell_(std::move(doorbell)), epoch_(posix::fork_epoch()) {}

std::shared_ptr<DoorbellNumber> Receiver::take_number() {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto place = std::find_if(places_.begin(), places_.end(), [](const Place& each) { return !each.taken; });
  if (place == places_.end()) {
    if (places_.size() == doorbell_numbers) return nullptr;
    place = places_.insert(places_.end(), Place());
  }
  place->taken = true;
  return std::make_shared<DoorbellNumber>(*this, static_cast<std::uint32_t>(place - places_.begin()));
}

// What came before nobody has looked at.
void Receiver::begin(std::uint32_t number, std::shared_ptr<ReceivingEnd> end) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    places_[number].end = std::move(end);
  }
  doorbell_->ring(number);
}

void Receiver::end(std::uint32_t number) {
  std::shared_ptr<ReceivingEnd> last;  // destroyed without the lock
  std::unique_lock<std::mutex> lock(mutex_);
  last = std::move(places_[number].end);
  if (caller_ == std::this_thread::get_id()) return;
  call_ended_.wait(lock, [this, number] { return called_ != number; });
}

void Receiver::give_back(std::uint32_t number) {
  if (posix::forked_since(epoch_)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  places_[number].taken = false;
}

void Receiver::run() {
  for (;;) {
    const std::uint32_t heard = doorbell_->page().bell.load(std::memory_order_acquire);
    collect();
    read_all();
    if (Clock::now() >= round_.next_look_at_all) collect_all();
    if (round_.ready.empty()) sleep(heard);
  }
}

void Receiver::collect() {
  DoorbellPage& page = doorbell_->page();
  round_.ready.insert(round_.ready.end(), round_.later.begin(), round_.later.end());
  round_.later.clear();
  // So many at most: publishers that set them again and again must not keep this thread here.
  for (std::uint32_t i = 0; i < doorbell_numbers; ++i) {
    const std::uint32_t number =
        round_.hints.next(page.groups, [&page](std::uint32_t leaf) -> auto& { return page.leaves[leaf]; });
    if (number == segment::no_slot) return;
    round_.ready.push_back(number);
  }
}

void Receiver::collect_all() {
  round_.next_look_at_all = Clock::now() + between_looks_at_all;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::uint32_t number = 0; number < places_.size(); ++number)
    if (places_[number].end) round_.ready.push_back(number);
}

void Receiver::read_all() {
  std::vector<std::uint32_t>& now = round_.now;
  now.swap(round_.ready);
  for (const std::uint32_t number : now) {
    const ReceivingEnd::Progress progress = read(number);
    if (progress == ReceivingEnd::Progress::more) round_.ready.push_back(number);
    if (progress == ReceivingEnd::Progress::later) round_.later.push_back(number);
  }
  now.clear();
}

ReceivingEnd::Progress Receiver::read(std::uint32_t number) {
  const std::shared_ptr<ReceivingEnd> end = begin_call(number);
  if (!end) return ReceivingEnd::Progress::done;
  const ReceivingEnd::Progress progress = end->read_some();
  end_call(progress);
  return progress;
}

// Marks the call before it releases the lock: a thread that ends the connection from now on waits for the call's end.
std::shared_ptr<ReceivingEnd> Receiver::begin_call(std::uint32_t number) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (number >= places_.size() || !places_[number].end) return nullptr;
  called_ = number;
  caller_ = std::this_thread::get_id();
  return places_[number].end;
}

void Receiver::end_call(ReceivingEnd::Progress progress) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (progress == ReceivingEnd::Progress::closed) places_[called_].end.reset();
  called_ = nobody;
  caller_ = std::thread::id();
  call_ended_.notify_all();
}

void Receiver::sleep(std::uint32_t heard) {
  DoorbellPage& page = doorbell_->page();
  const std::chrono::nanoseconds time =
      round_.later.empty() ? std::chrono::nanoseconds(between_looks_at_all) : between_questions;
  wait_for_bell(page, heard, [&](std::uint32_t value) { posix::sleep_while(page.bell, value, time); });
}

}  // namespace channel
}  // namespace tzc
