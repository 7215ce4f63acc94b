// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tzc {
namespace message {
namespace detail {

/// Keeps what a view borrows. Its destructor empties the borrowing vectors, so that they do not free borrowed
/// memory.
class Loan {
 public:
  explicit Loan(std::shared_ptr<const void> hold);
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;
  ~Loan();

  /// The vectors that borrow. Add a vector before its pointers are set.
  std::vector<void*>& borrowers() { return borrowers_; }
  /// Releases the hold at once when no vector borrows.
  void release_unused() {
    if (borrowers_.empty()) hold_.reset();
  }

 private:
  std::vector<void*> borrowers_;
  union {
    std::shared_ptr<const void> hold_;  // not destroyed in a forked child
  };
  std::uint64_t process_;
};

/// A message whose vectors borrow. `loan` is declared last, so it is destroyed first.
template <class S>
struct View {
  explicit View(std::shared_ptr<const void> hold) : loan(std::move(hold)) {}

  S message;
  Loan loan;
};

}  // namespace detail
}  // namespace message
}  // namespace tzc
