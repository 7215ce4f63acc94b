// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {
namespace detail {

/// Marks this thread as a reader that calls run_direct_callbacks() after each message, outside of roscpp's locks: the
/// callback may unsubscribe, which takes the very mutex that handleMessage holds.
class DirectReaderScope {
 public:
  DirectReaderScope();
  ~DirectReaderScope();
};

/// Runs what direct subscriptions have been given in this scope.
void run_direct_callbacks();

}  // namespace detail
}  // namespace tzc
