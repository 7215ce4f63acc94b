// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {
namespace segment {

/// Views of memory that another process, or the parent, may use again: what a forked child must go on to see as it was when
/// fork() was called.
class ForkCopied {
 public:
  /// Before the fork. From now on no block that has a view is used again, should its view end. False: there is none.
  /// No memory is allocated here, or in the others.
  virtual bool hold_for_child() noexcept = 0;
  /// In the child: it has copies of all views from now on. False: the system refuses some.
  virtual bool copy_in_child() noexcept = 0;
  /// In the parent, which does not hold them for the child any more.
  virtual void release_for_child() noexcept = 0;

 protected:
  ~ForkCopied() = default;
};

// The child copies, because it alone knows that no other thread writes to a view, or ends one, meanwhile. fork() returns in the
// parent when the child has done so, is gone, or never was: only so is it known when the blocks may go, whatever becomes of the
// child. What a thread can name when it calls fork() was taken before, so it is held. A process that has no view pays for a look
// at its acknowledgements; one that calls vfork or posix_spawn for nothing. The parent releases in any case: a child that gets no memory
// for its copies, or is stopped for long, may see later messages, but no child can keep memory of a publisher. The parent says so on stderr,
// once for each cause: what a child knows is not what its next brother will know, and a node may fork often.

/// Thread-safe; throws std::bad_alloc.
void copy_at_forks(ForkCopied& copied);
/// Waits while another thread is in a fork.
void forget_at_forks(ForkCopied& copied) noexcept;

}  // namespace segment
}  // namespace tzc
