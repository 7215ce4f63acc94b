// SPDX-License-Identifier: BSD-3-Clause
#include <tzc/detail/vector_words.h>
#include <tzc/detail/view.h>

#include <pthread.h>

#include <atomic>
#include <utility>

namespace tzc {
namespace message {
namespace detail {
namespace {

std::atomic<std::uint64_t> forks{0};

// Differs between a process and its forked children; cheaper than a system call for every view. libtzc_core.so does not
// export its own count (posix/fork_epoch.h).
std::uint64_t this_process() {
  static const int registered = pthread_atfork(nullptr, nullptr, [] { forks.fetch_add(1); });
  return registered == 0 ? forks.load(std::memory_order_relaxed) : 0;
}

}  // namespace

Loan::Loan(std::shared_ptr<const void> hold) : hold_(std::move(hold)), process_(this_process()) {}

// A forked child does not release the hold: it is the parent's, and releasing it would end it for both.
Loan::~Loan() {
  for (void* vector : borrowers_) tzc::detail::VectorWords::clear(vector);
  if (process_ == this_process()) hold_.~shared_ptr();
}

}  // namespace detail
}  // namespace message
}  // namespace tzc
