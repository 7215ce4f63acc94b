// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tzc {
namespace message {
namespace detail {

/// Keeps what a view borrows, and gives it back before the view's vectors would free it.
class Loan {
 public:
  explicit Loan(std::shared_ptr<const void> hold);
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;
  ~Loan();

  /// The vectors that borrow; add one before it gets its pointers.
  std::vector<void*>& borrowers() { return borrowers_; }
  /// Lets go at once when nobody has borrowed.
  void settle() {
    if (borrowers_.empty()) hold_.reset();
  }

 private:
  std::vector<void*> borrowers_;
  union {
    std::shared_ptr<const void> hold_;  // not destroyed in a forked child
  };
  std::uint64_t process_;
};

/// A message whose vectors borrow. The loan is declared last and so ends first.
template <class S>
struct View {
  explicit View(std::shared_ptr<const void> hold) : loan(std::move(hold)) {}

  S message;
  Loan loan;
};

}  // namespace detail
}  // namespace message
}  // namespace tzc
