// SPDX-License-Identifier: BSD-3-Clause
// usage: block_memory_model
// One block's life in every execution that the C++ memory model allows, on the very code of the library: a publisher's
// thread writes, marks and sends it (segment/ack_word.h) and drops its handle; the subscriber wins the record
// (channel/wire/delivery_cursors.h), takes, reads and releases the block; another thread finds it by its address
// (segment/handle_count.h); the allocator, which may revoke the record, reuses it when nobody holds it. The payload is
// no atomic: a write that does not happen after the last read is a race. Then weakens each memory order.
#include "channel/wire/delivery_cursors.h"
#include "segment/ack_word.h"
#include "segment/handle_count.h"
#include "weak/weakenings.h"

namespace tzc {
namespace model {
namespace {

using weak::Atomic;
using weak::Context;
using weak::Explorer;
using weak::Plain;
using weak::Word;

constexpr auto acquire = std::memory_order_acquire;
constexpr auto release = std::memory_order_release;
constexpr Word generation = 7, content = 41, other_content = 99;

enum Location : std::size_t {
  handles,
  note,
  ack,
  cursors,
  first_record,  // carried by the ring or the socket; what follows is no code under test
  second_record,
  address,  // of the block, as the program hands it to another of its threads
  live_lock,
  connection_lock,
  in_flight,  // the connection's own, under its lock
  payload,
  location_count
};
enum ThreadIndex : std::size_t { sender, allocator, subscriber, finder };

const weak::Names names{{"sender", "allocator", "subscriber", "finder"},
                        {"handles", "note", "ack", "cursors"}};

struct Actors {
  bool subscribes;
  bool finds;
  bool revokes;
  int times_sent = 1;
  bool reuses = false;  // the freed block is sent again, as the next generation
};

// As BufferPtr::drop.
void drop_handle(Context& context) {
  Atomic(context, handles).fetch_add(~Word{0}, std::memory_order_acq_rel);
}

void mark(Context& context, const Actors& actors, Word block) {
  Atomic own(context, note), word(context, ack);
  for (int i = 0; i < actors.times_sent; ++i)
    context.require(segment::note_and_mark(own, word, static_cast<std::uint32_t>(block)), "a mark failed");
}

void send(Context& context, const Actors& actors) {
  Plain(context, payload).write(content);
  if (actors.finds) Atomic(context, address).store(1, release);
  if (actors.subscribes) {
    Atomic lock(context, connection_lock);
    lock.lock();
    mark(context, actors, generation);
    Plain(context, in_flight).write(1);
    Atomic(context, first_record).store(1, release);
    lock.unlock();
  }
  drop_handle(context);
}

void send_again(Context& context, const Actors& actors) {
  Atomic lock(context, connection_lock);
  lock.lock();
  mark(context, actors, generation + 1);
  Atomic(context, second_record).store(1, release);
  lock.unlock();
}

void revoke(Context& context, const Actors& actors) {
  Atomic lock(context, connection_lock), word(context, ack), positions(context, cursors);
  lock.lock();
  std::uint32_t taken = 0;
  if (Plain(context, in_flight).read() != 0 && channel::try_revoke(positions, 1, taken)) {
    for (int i = 0; i < actors.times_sent; ++i)
      context.require(segment::revoke_in_flight(word, generation), "a mark was not in flight");
  }
  lock.unlock();
}

void allocate(Context& context, const Actors& actors) {
  if (actors.revokes) revoke(context, actors);
  Atomic lock(context, live_lock), count(context, handles), own(context, note), word(context, ack);
  lock.lock();
  const bool in_use = segment::is_in_use(
      count, [&] { return actors.subscribes && segment::may_hold(own, word, generation); });
  lock.unlock();
  if (in_use) return;
  Plain(context, payload).write(other_content);
  if (actors.reuses) send_again(context, actors);
}

void read(Context& context, Word expected) {
  context.require(Plain(context, payload).read() == expected, "a block changed while it was in use");
}

void receive(Context& context, const Actors& actors, Location record, std::uint32_t sequence) {
  if (Atomic(context, record).load(acquire) == 0) return;
  Atomic positions(context, cursors), word(context, ack);
  if (!channel::try_take(positions, sequence)) return;
  const auto block = static_cast<std::uint32_t>(generation + sequence - 1);
  for (int i = 0; i < actors.times_sent; ++i)
    context.require(segment::take(word, block), "a marked block could not be taken");
  for (int i = 0; i < actors.times_sent; ++i) {
    read(context, sequence == 1 ? content : other_content);
    context.require(segment::release(word, block), "a taken block could not be released");
  }
}

void subscribe(Context& context, const Actors& actors) {
  if (!actors.subscribes) return;
  receive(context, actors, first_record, 1);
  if (actors.reuses) receive(context, actors, second_record, 2);
}

void find(Context& context, const Actors& actors) {
  if (!actors.finds || Atomic(context, address).load(acquire) == 0) return;
  Atomic lock(context, live_lock), count(context, handles);
  lock.lock();
  const bool found = segment::add_handle_if_any(count);
  lock.unlock();
  if (!found) return;
  read(context, content);
  drop_handle(context);
}

weak::Scenario scenario(const char* name, const Actors& actors) {
  return {name, [actors] {
            Explorer explorer;
            explorer.initial.assign(location_count, 0);
            explorer.initial[handles] = 1;
            explorer.threads = {[actors](Context& context) { send(context, actors); },
                                [actors](Context& context) { allocate(context, actors); },
                                [actors](Context& context) { subscribe(context, actors); },
                                [actors](Context& context) { find(context, actors); }};
            return explorer;
          }};
}

// Orders that the code could do without.
std::vector<weak::Spare> spares() {
  const char* one_loop = "update_ack is one loop for four steps; to release is needed by release alone";
  const char* no_data = "nothing is read because of a lost race for the word: the next try compares it again";
  const char* decision =
      "the word alone decides; what the record carries is ordered by the record, its blocks by ack";
  const char* last_handle = "who frees the block reads the count again, and acquires it then";
  return {
      {"sender, ack, load, acquire to relaxed", one_loop},
      {"sender, ack, compare_exchange, acq_rel to acquire", one_loop},
      {"sender, ack, compare_exchange that fails, acquire to relaxed", no_data},
      {"allocator, ack, compare_exchange, acq_rel to release", one_loop},
      {"allocator, ack, compare_exchange that fails, acquire to relaxed", no_data},
      {"subscriber, ack, load, acquire to relaxed", one_loop},
      {"subscriber, ack, compare_exchange, acq_rel to release", one_loop},
      {"subscriber, ack, compare_exchange that fails, acquire to relaxed", no_data},
      {"subscriber, cursors, load, acquire to relaxed", decision},
      {"subscriber, cursors, compare_exchange, acq_rel to acquire", decision},
      {"subscriber, cursors, compare_exchange, acq_rel to release", decision},
      {"subscriber, cursors, compare_exchange that fails, acquire to relaxed", no_data},
      {"allocator, cursors, compare_exchange, acq_rel to acquire", decision},
      {"sender, handles, fetch_add, acq_rel to release", last_handle},
      {"finder, handles, fetch_add, acq_rel to release", last_handle},
      {"finder, handles, compare_exchange, acquire to relaxed",
       "find and the allocator exclude each other by a lock"},
  };
}

int run() {
  const std::vector<weak::Scenario> scenarios{
      scenario("sent and released", {true, false, false}),
      scenario("sent twice and released", {true, false, false, 2}),
      scenario("revoked meanwhile", {true, false, true}),
      scenario("sent twice, revoked", {true, false, true, 2}),
      scenario("found meanwhile", {false, true, false}),
      scenario("sent, found", {true, true, false}),
      scenario("reused", {true, false, false, 1, true}),
      scenario("revoked, reused", {true, false, true, 1, true}),
  };
  return weak::explore_with_weakenings(scenarios, names, spares());
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
