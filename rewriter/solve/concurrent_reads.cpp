// SPDX-License-Identifier: BSD-3-Clause
#include "solve/concurrent_reads.h"

#include <algorithm>

namespace tzc::rewriter {
namespace {

bool have_common_lock(const RunningCode::Spot& one, const RunningCode::Spot& other) {
  return std::any_of(one.locks.begin(), one.locks.end(),
                     [&](const std::string& lock) { return other.locks.count(lock) != 0; });
}

bool begins_with(const std::string& text, const std::string& begin) {
  return text.compare(0, begin.size(), begin) == 0;
}

}  // namespace

ConcurrentReads::ConcurrentReads(const Facts& facts, const Components& components)
    : facts_(facts), components_(components), running_(facts) {}

bool ConcurrentReads::is_in(const EntityId& message, const Component& component) const {
  const Component* of = components_.of(message);
  return of && of->id == component.id;
}

/// Of other threads: a lasting message, or a lasting pointer to one, or what a closure uses of the function around it.
bool ConcurrentReads::is_within_reach(const Component& component) const {
  return is_captured(component) || std::any_of(component.entities.begin(), component.entities.end(),
                                               [](const Entity* entity) { return entity->lasts(); });
}

/// A closure that another thread may run uses a message of the function around it.
bool ConcurrentReads::is_captured(const Component& component) const {
  const auto is_here = [&](const EntityId& message) { return is_in(message, component); };
  for (const ElementUse& use : facts_.element_uses)
    if (use.captured && is_here(use.message)) return true;
  for (const auto& [usr, events] : facts_.effects)
    for (const PublishEvent& event : events)
      if (event.captured && std::any_of(event.messages.begin(), event.messages.end(), is_here)) return true;
  return false;
}

/// Whether the field is one of the class, its bases, or a class that is derived from it: of the same object then.
bool ConcurrentReads::is_part_of(const std::string& field, const std::string& record) const {
  const std::set<std::string> classes = facts_.with_bases(record);
  return std::any_of(classes.begin(), classes.end(),
                     [&](const std::string& one) { return begins_with(field, one + "@FI@"); });
}

/// Whether all who use a message have the same mutex under that name: it is part of the same object, or there is only one of both.
bool ConcurrentReads::guards(const std::string& lock, const Component& component) const {
  static const std::string own = "this/";
  const bool of_function = begins_with(lock, local_lock);
  const bool of_object = begins_with(lock, own);
  return std::all_of(component.entities.begin(), component.entities.end(), [&](const Entity* message) {
    if (!message->lasts()) return true;
    const bool is_member = message->storage == Storage::member;
    return !of_function &&
           (!of_object || (is_member && is_part_of(lock.substr(own.size()), message->member_of.record)));
  });
}

ConcurrentReads::Spot ConcurrentReads::spot(const std::string& code, const std::set<std::string>& locks,
                                            const Component& component) const {
  Spot spot = running_.spot(code, locks);
  for (auto lock = spot.locks.begin(); lock != spot.locks.end();)
    lock = guards(*lock, component) ? std::next(lock) : spot.locks.erase(lock);
  return spot;
}

ConcurrentReads::Accesses ConcurrentReads::accesses_of(const Component& component) const {
  Accesses found;
  for (const auto& [usr, events] : facts_.effects)
    for (const PublishEvent& event : events)
      if (event.kind == PublishEvent::Kind::publish &&
          std::any_of(event.messages.begin(), event.messages.end(),
                      [&](const EntityId& message) { return is_in(message, component); }))
        found.publishes.push_back(spot(code_of(usr, event), event.locks, component));
  for (const ElementUse& use : facts_.element_uses) {
    if (!is_in(use.message, component)) continue;
    const bool writes = use.kind == ElementUse::Kind::write || use.kind == ElementUse::Kind::rebuild;
    (writes ? found.writes : found.reads).push_back({&use, spot(use.code, use.locks, component)});
  }
  return found;
}

/// Where one's code writes, and never meets another thread on the way from there to here, the source must keep the other off as long as it
/// runs: it would write to what the other uses, otherwise. `whole`: the other uses each element.
bool ConcurrentReads::is_kept_from(const Accesses& all, const Spot& one, const Spot& other,
                                   bool whole) const {
  if (running_.synchronizes(one.code)) return false;
  return std::any_of(all.writes.begin(), all.writes.end(), [&](const Access& write) {
    return write.spot.code == one.code && !have_common_lock(write.spot, other) &&
           (whole || write.use->kind == ElementUse::Kind::rebuild);
  });
}

bool ConcurrentReads::meets_publish(const Accesses& all, const Spot& read) const {
  return std::any_of(all.publishes.begin(), all.publishes.end(), [&](const Spot& publish) {
    return !have_common_lock(read, publish) && running_.may_meet(read, publish) &&
           !is_kept_from(all, read, publish, true) && !is_kept_from(all, publish, read, false);
  });
}

bool ConcurrentReads::meets_read(const Accesses& all, const Spot& one, const Spot& other) const {
  return !have_common_lock(one, other) && running_.may_meet(one, other) &&
         !is_kept_from(all, one, other, false) && !is_kept_from(all, other, one, false);
}

/// Threads may share an array out between them: what one writes is not what the other reads.
bool ConcurrentReads::meets_write(const Spot& read, const Access& write) const {
  return write.use->kind == ElementUse::Kind::write && !have_common_lock(read, write.spot) &&
         running_.may_meet(read, write.spot) &&
         (running_.is_for_thread(read) || running_.is_for_thread(write.spot));
}

/// By another thread.
bool ConcurrentReads::is_moved(const Accesses& all, const Access& read) const {
  const bool by_reader = std::any_of(all.reads.begin(), all.reads.end(), [&](const Access& other) {
    return !other.use->read_only && meets_read(all, read.spot, other.spot);
  });
  return by_reader || std::any_of(all.writes.begin(), all.writes.end(),
                                  [&](const Access& write) { return meets_write(read.spot, write); });
}

bool ConcurrentReads::is_endangered(const Accesses& all, const Access& read) const {
  const bool walks = read.use->kind == ElementUse::Kind::walk;
  if (walks && read.use->read_only) return is_moved(all, read);
  // It moves the elements itself, or is done with the one that it reads before they move twice.
  return meets_publish(all, read.spot) && (walks || is_moved(all, read));
}

const ElementUse* ConcurrentReads::of(const Component& component) const {
  if (!is_within_reach(component)) return nullptr;
  const Accesses all = accesses_of(component);
  const auto found = std::find_if(all.reads.begin(), all.reads.end(),
                                  [&](const Access& read) { return is_endangered(all, read); });
  return found == all.reads.end() ? nullptr : found->use;
}

}  // namespace tzc::rewriter
