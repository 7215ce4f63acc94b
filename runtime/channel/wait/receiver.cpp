// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wait/receiver.h"

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
constexpr std::chrono::milliseconds longest_round{2};      // of a guest that is wanted elsewhere

std::atomic<Receiver*> running_receiver{nullptr};
std::mutex receiver_start_mutex;

thread_local bool reads_now = false;

/// Of a thread that has got the turn, which it gives at the end.
class ReadingScope {
 public:
  explicit ReadingScope(Turn& turn) : turn_(turn) { reads_now = true; }
  ~ReadingScope() {
    reads_now = false;
    turn_.give();
  }
  ReadingScope(const ReadingScope&) = delete;
  ReadingScope& operator=(const ReadingScope&) = delete;

 private:
  Turn& turn_;
};

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

Receiver* Receiver::running() {
  Receiver* receiver = running_receiver.load(std::memory_order_acquire);
  return receiver != nullptr && !posix::forked_since(receiver->epoch_) ? receiver : nullptr;
}

// A forked child starts a receiver of its own and leaves the parent's object alone: its locks may be in any state.
Expected<Receiver*> Receiver::instance() {
  if (Receiver* receiver = running()) return receiver;
  const std::lock_guard<std::mutex> lock(receiver_start_mutex);
  if (Receiver* receiver = running()) return receiver;
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
  running_receiver.store(receiver.get(), std::memory_order_release);
  return receiver.release();
}

Receiver::Receiver(std::shared_ptr<Doorbell> doorbell)
    : doorbell_(std::move(doorbell)), sleepers_(*doorbell_), epoch_(posix::fork_epoch()) {}

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
  const Ask is_enough = [this] { return turn_.is_wanted(); };
  for (;;) {
    std::uint32_t heard = 0;
    turn_.take_as_reader();
    const std::chrono::nanoseconds time = read_round(heard, is_enough);
    if (time.count() > 0) sleepers_.sleep(reader_sleeps, heard, time, nullptr);
  }
}

// Gives the turn. How long the reader may sleep then: 0 when there is more to read. An exception of a callback ends the process, on a
// guest's thread as on the library's.
std::chrono::nanoseconds Receiver::read_round(std::uint32_t& heard, const Ask& is_enough) noexcept {
  const ReadingScope reading(turn_);
  heard = doorbell_->page().bell.load(std::memory_order_acquire);
  collect();
  read_all(is_enough);
  if (Clock::now() >= round_.next_look_at_all) collect_all();
  if (!round_.ready.empty()) return std::chrono::nanoseconds(0);
  return round_.later.empty() ? std::chrono::nanoseconds(between_looks_at_all) : between_questions;
}

bool Receiver::host(std::chrono::nanoseconds most, const std::function<bool()>& wanted) {
  if (reads_now) return false;  // and has both locks
  const std::unique_lock<std::mutex> guest(guest_, std::try_to_lock);
  if (!guest.owns_lock()) return false;
  const Clock::time_point end = Clock::now() + most;
  Clock::time_point begun;
  const Ask is_enough = [&] { return Clock::now() - begun > longest_round && wanted(); };
  for (;;) {
    std::uint32_t heard = 0;
    turn_.take_as_guest();
    begun = Clock::now();
    const std::chrono::nanoseconds time = read_round(heard, is_enough);
    const std::chrono::nanoseconds left = end - Clock::now();
    if (left.count() <= 0 || wanted()) break;
    if (time.count() > 0) sleepers_.sleep(guest_sleeps, heard, std::min(time, left), wanted);
  }
  hand_over();
  return true;
}

// What the guest leaves unread is the reader's.
void Receiver::hand_over() {
  turn_.take_as_guest();
  const bool is_all_read = round_.ready.empty() && round_.later.empty();
  turn_.give();
  if (is_all_read) return;
  doorbell_->page().bell.fetch_add(1, std::memory_order_seq_cst);  // it may be about to fall asleep
  sleepers_.wake(reader_sleeps);
}

void Receiver::call_guest() {
  sleepers_.wake(guest_sleeps);
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
    round_.list(number, round_.ready);
  }
}

void Receiver::collect_all() {
  round_.next_look_at_all = Clock::now() + between_looks_at_all;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::uint32_t number = 0; number < places_.size(); ++number)
    if (places_[number].end) round_.list(number, round_.ready);
}

void Receiver::read_all(const Ask& is_enough) {
  std::vector<std::uint32_t>& now = round_.now;
  now.swap(round_.ready);
  auto next = now.begin();
  while (next != now.end()) {
    const std::uint32_t number = *next++;
    round_.listed[number] = false;  // what comes from now on may come after this look
    const ReceivingEnd::Progress progress = read(number);
    if (progress == ReceivingEnd::Progress::more) round_.list(number, round_.ready);
    if (progress == ReceivingEnd::Progress::later) round_.list(number, round_.later);
    if (is_enough()) break;
  }
  round_.ready.insert(round_.ready.begin(), next, now.end());  // those that were left come first
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

}  // namespace channel
}  // namespace tzc
