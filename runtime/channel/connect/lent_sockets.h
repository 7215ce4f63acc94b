// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

#include "posix/file_descriptor.h"

namespace tzc {
namespace channel {

/// The subscriber's end of a connection's socket, or, where it has a trunk, of those that the publisher lends it one after the
/// other. One thread reads; the others may lend and stop.
class LentSockets {
 public:
  explicit LentSockets(posix::FileDescriptor first) : current_(std::move(first)) {}

  /// From now on they are loans.
  void are_lent();
  bool lent() const;
  /// The one to read. -1: the next one is on its way.
  int current() const;
  /// False: it did not arrive, or two are there already. No honest publisher lends a third one.
  bool lend(posix::FileDescriptor socket);
  /// Whether one has not arrived.
  bool missed() const;
  /// Reader: all was read that came through the current one. True: it was a loan, and its end counts as a packet. False:
  /// nothing more comes.
  bool give_back();
  /// A reader that is blocked returns, and the publisher's writes fail. What was sent may still be read.
  void stop_receiving();

 private:
  mutable std::mutex mutex_;
  posix::FileDescriptor current_;
  posix::FileDescriptor next_;
  bool lent_ = false;
  bool stopped_ = false;
  bool missed_ = false;
};

}  // namespace channel
}  // namespace tzc
