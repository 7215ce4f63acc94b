// SPDX-License-Identifier: BSD-3-Clause
#include "weak/execution.h"

#include <algorithm>
#include <string>

namespace tzc {
namespace model {
namespace weak {
namespace {

constexpr std::size_t no_thread = SIZE_MAX;  // of the initial writes

Word written_by(const Operation& operation, Word read) {
  switch (operation.kind) {
    case Operation::fetch_add:
      return read + operation.operand;
    case Operation::fetch_or:
      return read | operation.operand;
    case Operation::lock:
      return 1;
    default:
      return operation.operand;
  }
}

bool waits_for_another(const Operation& operation, Word read) {
  if (operation.kind == Operation::lock) return read != 0;
  return operation.kind == Operation::await && read != operation.operand;
}

bool is_update(const Operation& operation, Word read) {
  if (operation.kind == Operation::compare_exchange) return read == operation.expected;
  return operation.kind == Operation::fetch_add || operation.kind == Operation::fetch_or ||
         operation.kind == Operation::exchange || operation.kind == Operation::lock;
}

void mix(std::pair<std::uint64_t, std::uint64_t>& key, std::uint64_t value) {
  key.first = (key.first ^ value) * 0x9e3779b97f4a7c15;
  key.first ^= key.first >> 32;
  key.second = (key.second + value) * 0xd6e8feb86659fd93;
  key.second ^= key.second >> 29;
}

}  // namespace

Execution::Execution(std::size_t threads, const std::vector<Word>& initial, Scope scope)
    : scope_(scope), threads_(threads) {
  for (std::size_t location = 0; location < initial.size(); ++location) {
    Event event;
    event.thread = no_thread;
    event.location = location;
    event.value_written = initial[location];
    events_.push_back(event);
    writes_.push_back({location});
  }
  for (Thread& thread : threads_) thread.release_writes.assign(initial.size(), 0);
}

std::vector<std::pair<Execution, Word>> Execution::extended(std::size_t thread,
                                                            const Operation& operation) const {
  std::vector<std::pair<Execution, Word>> all;
  const Event event = next_event(thread, operation);
  if (operation.kind == Operation::fence)
    extend_fence(event, all);
  else if (operation.kind == Operation::store)
    extend_writing(event, all);
  else
    extend_reading(event, operation, all);
  return all;
}

Event Execution::next_event(std::size_t thread, const Operation& operation) const {
  if (events_.size() == most_events) throw Violation{"more events than the explorer can hold"};
  Event event;
  event.kind = operation.kind == Operation::fence ? Event::fence : Event::write;
  event.thread = thread;
  event.index = threads_[thread].events.size();
  event.location = operation.location;
  event.order = operation.order;
  event.atomic = operation.atomic;
  event.value_written = operation.operand;
  for (std::size_t i = 0; i < writes_.size(); ++i) event.before.set(i);
  if (event.index == 0) return event;
  const std::size_t previous = threads_[thread].events.back();
  event.before |= events_[previous].before;
  event.before.set(previous);
  return event;
}

void Execution::extend_reading(const Event& event, const Operation& operation,
                               std::vector<std::pair<Execution, Word>>& all) const {
  const auto& writes = writes_[event.location];
  for (std::size_t i = 0; i < writes.size(); ++i) {
    Event read = event;
    read.source = writes[i];
    read.value_read = events_[writes[i]].value_written;
    if (waits_for_another(operation, read.value_read)) continue;
    const bool update = is_update(operation, read.value_read);
    read.kind = update ? Event::update : Event::read;
    read.value_written = update ? written_by(operation, read.value_read) : 0;
    if (operation.kind == Operation::compare_exchange && !update) read.order = operation.failure_order;
    if (update && !may_insert(event.location, i + 1)) continue;
    Execution next = *this;
    if (next.add(read, i + 1)) all.emplace_back(std::move(next), read.value_read);
  }
}

void Execution::extend_writing(const Event& event, std::vector<std::pair<Execution, Word>>& all) const {
  for (std::size_t position = 1; position <= writes_[event.location].size(); ++position) {
    if (!may_insert(event.location, position)) continue;
    Execution next = *this;
    if (next.add(event, position)) all.emplace_back(std::move(next), 0);
  }
}

void Execution::extend_fence(const Event& event, std::vector<std::pair<Execution, Word>>& all) const {
  Execution next = *this;
  if (next.add(event, 0)) all.emplace_back(std::move(next), 0);
}

// Atomicity: not between an update and what it reads from.
bool Execution::may_insert(std::size_t location, std::size_t position) const {
  const auto& writes = writes_[location];
  return position == writes.size() || events_[writes[position]].kind != Event::update;
}

bool Execution::add(Event event, std::size_t position) {
  synchronize(event);
  if (event.kind != Event::fence) {
    check_race(event);
    if (!is_coherent(event, position)) return false;
  }
  check_load_buffering(event);
  const std::size_t id = events_.size();
  if (event.writes()) {
    auto& writes = writes_[event.location];
    writes.insert(writes.begin() + static_cast<std::ptrdiff_t>(position), id);
    if (is_release(event.order) && event.atomic) event.releases.set(id);
  }
  Thread& thread = threads_[event.thread];
  if (event.kind == Event::fence && is_release(event.order)) thread.release_fences.set(id);
  thread.events.push_back(id);
  events_.push_back(event);
  return has_sequential_order(events_, writes_);
}

// Which releases the event synchronizes with, and which ones those that read it will.
void Execution::synchronize(Event& event) {
  Thread& thread = threads_[event.thread];
  if (event.kind == Event::fence) {
    if (is_acquire(event.order)) order_after(event, thread.before_fence);
    return;
  }
  if (!event.atomic) return;
  if (event.reads()) {
    const EventSet& released = events_[event.source].releases;
    thread.before_fence |= released;
    if (is_acquire(event.order)) order_after(event, released);
    if (event.kind == Event::update) event.releases |= released;
  }
  if (event.writes()) event.releases |= thread.release_fences;
}

void Execution::order_after(Event& event, const EventSet& released) const {
  for (std::size_t i = 0; i < events_.size(); ++i) {
    if (!released[i]) continue;
    event.before |= events_[i].before;
    event.before.set(i);
  }
}

void Execution::check_race(const Event& event) const {
  for (std::size_t i = writes_.size(); i < events_.size(); ++i) {
    const Event& other = events_[i];
    if (other.kind == Event::fence || other.location != event.location || event.before[i]) continue;
    if (!other.writes() && !event.writes()) continue;
    if (other.atomic && event.atomic) continue;
    throw Violation{"threads " + std::to_string(other.thread) + " and " + std::to_string(event.thread) +
                    " race for location " + std::to_string(event.location)};
  }
}

// ARM and C++ let a relaxed read see what depends on a later relaxed write of its thread (load buffering); RC11 does
// not. A program in which no thread writes so after such a read behaves alike in both, others are refused. Of memory
// that is no atomic each read happens after what it reads, or the program has a race.
void Execution::check_load_buffering(const Event& event) {
  Thread& thread = threads_[event.thread];
  auto& reads = thread.relaxed_reads;
  if (event.kind == Event::fence)
    reads.clear();  // of either kind: it orders the reads before it and the writes after
  if (event.kind == Event::fence || !event.atomic) return;
  const auto same = [this, &event](std::size_t read) { return events_[read].location == event.location; };
  if (event.reads() && is_acquire(event.order))  // which comes after the earlier reads of its location
    reads.erase(std::remove_if(reads.begin(), reads.end(), same), reads.end());
  if (scope_ == Scope::without_load_buffering && event.writes() && may_precede_a_read(event))
    throw Violation{"out of scope: a relaxed write after a relaxed read (load buffering)"};
  if (event.reads() && !is_acquire(event.order)) reads.push_back(events_.size());
  if (event.writes() && is_release(event.order)) thread.release_writes[event.location] = events_.size();
}

// A release write comes after all reads before it, and before the later writes to its location.
bool Execution::may_precede_a_read(const Event& write) const {
  if (is_release(write.order)) return false;
  const Thread& thread = threads_[write.thread];
  const std::size_t ordered = thread.release_writes[write.location];
  return std::any_of(thread.relaxed_reads.begin(), thread.relaxed_reads.end(), [&](std::size_t read) {
    return events_[read].location != write.location && read > ordered;
  });
}

std::size_t Execution::position_of(std::size_t write) const {
  const auto& writes = writes_[events_[write].location];
  return static_cast<std::size_t>(std::find(writes.begin(), writes.end(), write) - writes.begin());
}

// What happens before the event must not come after it in the location's order: neither a write nor what was read.
bool Execution::is_coherent(const Event& event, std::size_t position) const {
  for (std::size_t i = 0; i < events_.size(); ++i) {
    const Event& other = events_[i];
    if (!event.before[i] || other.kind == Event::fence || other.location != event.location) continue;
    const std::size_t seen = position_of(other.writes() ? i : other.source);
    if (seen >= position) return false;
  }
  return true;
}

std::pair<std::uint64_t, std::uint64_t> Execution::key() const {
  std::pair<std::uint64_t, std::uint64_t> key{1, 2};
  const auto name = [this](std::size_t id) {
    return events_[id].thread == no_thread ? id : (events_[id].thread + 1) << 16 | events_[id].index;
  };
  for (const Thread& thread : threads_) {
    for (const std::size_t id : thread.events) mix(key, events_[id].reads() ? name(events_[id].source) : 1);
    mix(key, thread.events.size() << 8 | 3);
  }
  for (const auto& writes : writes_) {
    for (const std::size_t id : writes) mix(key, name(id));
  }
  return key;
}

}  // namespace weak
}  // namespace model
}  // namespace tzc
