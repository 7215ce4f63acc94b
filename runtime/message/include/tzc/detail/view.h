// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/vector_words.h>

#include <cstddef>
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

/// Makes a vector that is empty point at elements that it does not own. For vectors with VectorWords.
template <class T>
void borrow(std::vector<T>& vector, const T* first, std::size_t count, std::vector<void*>& borrowers) {
  borrowers.push_back(&vector);
  T* const begin = const_cast<T*>(first);
  tzc::detail::VectorWords{begin, begin + count, begin + count}.write_to(&vector);
}
template <class Vector, class T>
void borrow(Vector&, const T*, std::size_t, std::vector<void*>&) {}  // other allocators: never called

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
