// SPDX-License-Identifier: BSD-3-Clause
#include "posix/thread.h"

#include <dlfcn.h>
#include <pthread.h>

#include <algorithm>
#include <memory>
#include <system_error>
#include <utility>

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

Error no_thread(const char* name, int code) {
  Error error;
  error.what = "start a thread";
  error.where = name;
  error.code = code;
  return error;
}

struct Beginning {
  const char* name;
  std::function<void()> body;
};

void* begin(void* given) {
  const std::unique_ptr<Beginning> beginning(static_cast<Beginning*>(given));
  ::pthread_setname_np(::pthread_self(), beginning->name);
  beginning->body();
  return nullptr;
}

/// What small threads are made with.
class SmallDetached {
 public:
  SmallDetached() {
    ::pthread_attr_init(&attributes_);
    ::pthread_attr_setdetachstate(&attributes_, PTHREAD_CREATE_DETACHED);
    std::size_t usual = 0;
    ::pthread_attr_getstacksize(&attributes_, &usual);
    ::pthread_attr_setstacksize(&attributes_, std::min(usual, small_stack + thread_locals(attributes_)));
  }
  ~SmallDetached() { ::pthread_attr_destroy(&attributes_); }
  SmallDetached(const SmallDetached&) = delete;
  SmallDetached& operator=(const SmallDetached&) = delete;

  const pthread_attr_t* get() const { return &attributes_; }

 private:
  static constexpr std::size_t small_stack = std::size_t{1} << 20;

  // glibc takes the thread-local variables of all libraries from the stack, and tells their size to those who ask by this name, as
  // runtimes of other languages do. The name is looked up when this library is loaded: later, the linker's lock may be taken.
  static std::size_t thread_locals(const pthread_attr_t& attributes) {
    return min_stack != nullptr ? min_stack(&attributes) : 0;
  }
  using MinStack = std::size_t (*)(const pthread_attr_t*);
  static const MinStack min_stack;

  pthread_attr_t attributes_;
};

const SmallDetached::MinStack SmallDetached::min_stack =
    reinterpret_cast<SmallDetached::MinStack>(::dlsym(RTLD_DEFAULT, "__pthread_get_minstack"));

}  // namespace

Status start_small_thread(const char* name, std::function<void()> body) {
  const SignalsBlocked blocked;
  auto beginning = std::make_unique<Beginning>(Beginning{name, std::move(body)});
  const SmallDetached kind;
  pthread_t thread;
  const int failure = ::pthread_create(&thread, kind.get(), begin, beginning.get());
  if (failure != 0) return no_thread(name, failure);
  (void)beginning.release();  // the thread's by now
  return Success{};
}

Expected<std::thread> start_thread(const char* name, std::function<void()> body) {
  const SignalsBlocked blocked;
  try {
    std::thread thread(std::move(body));
    ::pthread_setname_np(thread.native_handle(), name);
    return {std::move(thread)};
  } catch (const std::system_error& failure) {
    return no_thread(name, failure.code().value());
  }
}

}  // namespace posix
}  // namespace tzc
