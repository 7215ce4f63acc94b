// SPDX-License-Identifier: BSD-3-Clause
#include "parse/crash_net.h"

#include <llvm/Support/CrashRecoveryContext.h>

#include <csignal>
#include <exception>
#include <mutex>
#include <vector>

namespace tzc::rewriter {
namespace {

/// Long sums and long chains of << are deep trees, and some walks over them are recursive.
constexpr unsigned stack_size = 64U << 20;

/// LLVM's handlers run on the stack of the thread, where nothing is left after it was exhausted.
void run_on_alternate_stack(int signal) {
  struct sigaction action{};
  ::sigaction(signal, nullptr, &action);
  action.sa_flags |= SA_ONSTACK;
  ::sigaction(signal, &action, nullptr);
}

void install_handlers() {
  static std::once_flag once;
  std::call_once(once, [] {
    llvm::CrashRecoveryContext::Enable();
    run_on_alternate_stack(SIGSEGV);
    run_on_alternate_stack(SIGBUS);
  });
}

void handle_signals_on(std::vector<char>& memory) {
  stack_t stack{};
  stack.ss_sp = memory.data();
  stack.ss_size = memory.size();
  ::sigaltstack(&stack, nullptr);
}

}  // namespace

int signal_that_ends(const std::function<void()>& work) {
  install_handlers();
  std::vector<char> signal_stack(64U << 10);  // outlives the thread, which a signal ends without destructors
  std::exception_ptr thrown;
  llvm::CrashRecoveryContext context;
  const bool ended = context.RunSafelyOnThread(
      [&] {
        handle_signals_on(signal_stack);
        try {
          work();
        } catch (...) {  // LLVM is built without exceptions: none may pass through it
          thrown = std::current_exception();
        }
      },
      stack_size);
  if (thrown) std::rethrow_exception(thrown);
  return ended ? 0 : context.RetCode - 128;
}

}  // namespace tzc::rewriter
