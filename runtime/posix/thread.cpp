// SPDX-License-Identifier: BSD-3-Clause
#include "posix/thread.h"

#include <pthread.h>

#include <system_error>

#include "posix/error.h"
#include "posix/fault_signals.h"

namespace tzc {
namespace posix {
namespace {

// A new thread inherits the mask of its creator, so the signals are blocked around the creation.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    const sigset_t others = all_but_faults();
    ::pthread_sigmask(SIG_SETMASK, &others, &before_);
  }
  ~SignalsBlocked() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

}  // namespace

Expected<std::thread> start_thread(const char* name, std::function<void()> body) {
  const SignalsBlocked blocked;
  try {
    std::thread thread(std::move(body));
    ::pthread_setname_np(thread.native_handle(), name);
    return {std::move(thread)};
  } catch (const std::system_error& failure) {
    Error error;
    error.what = "start a thread";
    error.where = name;
    error.code = failure.code().value();
    return error;
  }
}

}  // namespace posix
}  // namespace tzc
