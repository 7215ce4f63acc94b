// SPDX-License-Identifier: BSD-3-Clause
// usage: ring_memory_model
// The ring, the bell and the sleep (channel/wire/ring.h) of one publisher and one subscriber, in every execution that the
// C++ memory model allows: the records come in order and whole, none is missed and nobody sleeps forever. Then weakens
// each memory order of that code and demands that it is found.
#include "channel/wire/ring.h"
#include "weak/weakenings.h"

namespace tzc {
namespace model {
namespace {

using weak::Atomic;
using weak::Context;
using weak::Explorer;
using weak::Plain;
using weak::Word;

constexpr auto relaxed = std::memory_order_relaxed;
constexpr auto sc = std::memory_order_seq_cst;
constexpr std::size_t most_slots = 2, most_packets = 3;

enum Location : std::size_t {
  bell,
  written,
  packets,
  sleeping,
  read_count,
  packets_read,
  asleep,  // the kernel's, as is the socket
  socket,
  sizes = socket + most_packets,
  bytes = sizes + most_slots,
  location_count = bytes + most_slots
};

const weak::Names names{{"publisher", "subscriber"},
                        {"bell", "written", "packets", "sleeping", "read", "packets_read"}};

struct Traffic {
  std::uint32_t slots;
  std::vector<bool> through_socket;  // each message
};

channel::RingWords<Atomic> words_of(Context& context) {
  const auto word = [&](std::size_t location) { return Atomic(context, location); };
  return {word(bell), word(written), word(packets), word(sleeping), word(read_count), word(packets_read)};
}

// A futex as futex(2) and the kernel's own comment in kernel/futex describe it: both sides pass a full barrier.
void sleep_while(Context& context, Word expected) {
  Atomic word(context, asleep);
  word.exchange(1, std::memory_order_acq_rel);
  weak::fence(context, sc);
  if (Atomic(context, bell).load(std::memory_order_acquire) == expected)
    word.await(0, std::memory_order_acquire);
  else
    word.exchange(0, std::memory_order_acq_rel);
}

void wake_sleeper(Context& context) {
  weak::fence(context, sc);
  Atomic word(context, asleep);
  if (word.load(std::memory_order_acquire) != 0) word.exchange(0, std::memory_order_acq_rel);
}

void ring(Context& context) {
  auto words = words_of(context);
  channel::ring_bell(words, [&context](auto) { wake_sleeper(context); });
}

struct Publisher {
  Context& context;
  const Traffic& traffic;
  std::uint32_t in_ring = 0, in_socket = 0;

  void publish(Word message, bool through_socket) {
    auto words = words_of(context);
    if (!through_socket && channel::ring_takes(words, traffic.slots, in_ring, in_socket)) {
      const std::size_t slot = in_ring % traffic.slots;
      Plain(context, bytes + slot).write(message);
      Atomic(context, sizes + slot).store(message, relaxed);
      channel::announce_record(words, ++in_ring);
    } else {
      Atomic(context, socket + in_socket).store(message, std::memory_order_release);  // the kernel's lock
      channel::announce_packets(words, ++in_socket);
    }
    ring(context);
  }
};

struct Subscriber {
  Context& context;
  const Traffic& traffic;
  std::uint32_t out_of_ring = 0, out_of_socket = 0;

  Word receive() {
    for (;;) {
      auto words = words_of(context);
      const std::uint32_t heard = channel::listen(words);
      std::uint32_t far = 0;
      switch (channel::next_source(words, out_of_ring, out_of_socket, false, far)) {
        case channel::Source::ring:
          context.require(far - out_of_ring <= traffic.slots, "the ring claims more than it holds");
          return read_slot(words);
        case channel::Source::socket:
          return read_packet(words);
        case channel::Source::nothing:
          channel::wait_for_bell(words, heard, [this](Word value) { sleep_while(context, value); });
      }
    }
  }

  Word read_slot(channel::RingWords<Atomic>& words) {
    const std::size_t slot = out_of_ring % traffic.slots;
    const Word size = Atomic(context, sizes + slot).load(relaxed);
    const Word message = Plain(context, bytes + slot).read();
    context.require(size == message, "a size that is another record's");
    channel::give_back_slot(words, ++out_of_ring);
    return message;
  }

  Word read_packet(channel::RingWords<Atomic>& words) {
    const Word message = Atomic(context, socket + out_of_socket).load(std::memory_order_acquire);
    context.require(message != 0, "a packet that is not there");
    channel::acknowledge_packet(words, ++out_of_socket);
    return message;
  }
};

weak::Scenario scenario(const char* name, const Traffic& traffic) {
  return {name, [traffic] {
            Explorer explorer;
            explorer.initial.assign(location_count, 0);
            explorer.threads = {[traffic](Context& context) {
                                  Publisher publisher{context, traffic};
                                  for (std::size_t i = 0; i < traffic.through_socket.size(); ++i)
                                    publisher.publish(i + 1, traffic.through_socket[i]);
                                },
                                [traffic](Context& context) {
                                  Subscriber subscriber{context, traffic};
                                  for (Word next = 1; next <= traffic.through_socket.size(); ++next)
                                    context.require(subscriber.receive() == next, "a message out of order");
                                }};
            return explorer;
          }};
}

int run() {
  const std::vector<weak::Scenario> scenarios{
      scenario("one record", {1, {false}}),
      scenario("one packet", {1, {true}}),
      scenario("two records, one slot", {1, {false, false}}),
      scenario("a record, then a packet", {2, {false, true}}),
      scenario("a packet, then a record", {2, {true, false}}),
  };
  return weak::explore_with_weakenings(scenarios, names,
                                       {{"subscriber, sleeping, store, seq_cst to release",
                                         "futex(2) passes a full barrier before it compares; the code does "
                                         "not rely on what the kernel does inside"}});
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
