// SPDX-License-Identifier: BSD-3-Clause
#include "posix/memory_budget.h"

#include <algorithm>
#include <cstdint>

namespace tzc {
namespace posix {
namespace {

std::atomic<std::size_t> ceiling{SIZE_MAX};
std::atomic<std::size_t> total{0};

/// A share small enough that other processes find the rest, until this one reads again.
constexpr std::size_t share = 16;

}  // namespace

constexpr std::size_t HeadroomAllowance::most_bytes;
constexpr std::chrono::milliseconds HeadroomAllowance::lifetime;

void set_memory_ceiling(std::size_t bytes) noexcept {
  ceiling.store(bytes, std::memory_order_relaxed);
}

std::size_t memory_ceiling() noexcept {
  return ceiling.load(std::memory_order_relaxed);
}

std::size_t reserved_memory() noexcept {
  return total.load(std::memory_order_relaxed);
}

ReservedBytes::ReservedBytes(ReservedBytes&& other) noexcept : bytes_(other.bytes_.exchange(0)) {}

ReservedBytes& ReservedBytes::operator=(ReservedBytes&& other) noexcept {
  if (this == &other) return *this;
  remove(bytes_.load());
  bytes_.store(other.bytes_.exchange(0));
  return *this;
}

ReservedBytes::~ReservedBytes() {
  remove(bytes_.load());
}

bool ReservedBytes::add(std::size_t bytes) noexcept {
  std::size_t before = total.load(std::memory_order_relaxed);
  do {
    const std::size_t most = memory_ceiling();
    if (before > most || bytes > most - before) return false;
  } while (!total.compare_exchange_weak(before, before + bytes, std::memory_order_relaxed));
  bytes_.fetch_add(bytes, std::memory_order_relaxed);
  return true;
}

void ReservedBytes::remove(std::size_t bytes) noexcept {
  bytes_.fetch_sub(bytes, std::memory_order_relaxed);
  total.fetch_sub(bytes, std::memory_order_relaxed);
}

bool HeadroomAllowance::take(std::size_t bytes, Clock::time_point now) noexcept {
  if (now.time_since_epoch().count() >= until_.load(std::memory_order_relaxed)) return false;
  std::size_t left = left_.load(std::memory_order_relaxed);
  while (left >= bytes) {
    if (left_.compare_exchange_weak(left, left - bytes, std::memory_order_relaxed)) return true;
  }
  return false;
}

void HeadroomAllowance::refill(std::size_t headroom, std::size_t bytes, Clock::time_point now) noexcept {
  left_.store(headroom > bytes ? std::min((headroom - bytes) / share, most_bytes) : 0,
              std::memory_order_relaxed);
  until_.store((now + lifetime).time_since_epoch().count(), std::memory_order_relaxed);
}

}  // namespace posix
}  // namespace tzc
