// SPDX-License-Identifier: BSD-3-Clause
#include "weak/explorer.h"

namespace tzc {
namespace model {
namespace weak {
namespace {

bool comes_anyway(const Operation& operation) {
  return operation.kind == Operation::store || operation.kind == Operation::fence;
}

}  // namespace

bool Explorer::explore() {
  try {
    State state{Execution(threads.size(), initial, scope), std::vector<Thread>(threads.size())};
    for (std::size_t i = 0; i < threads.size(); ++i) run_to_next_operation(state.threads[i], i);
    visit(state);
    return true;
  } catch (const Violation& found) {
    violation_ = found.what;
    return false;
  }
}

void Explorer::visit(const State& state) {
  if (!visited_.insert(state.execution.key()).second) return;
  for (std::size_t i = 0; i < threads.size(); ++i) {
    const Thread& thread = state.threads[i];
    if (thread.finished || !comes_anyway(thread.next)) continue;
    step(state, i);
    return;
  }
  bool moved = false;
  for (std::size_t i = 0; i < threads.size(); ++i)
    moved = (!state.threads[i].finished && step(state, i)) || moved;
  if (!moved) end(state);
}

bool Explorer::step(const State& state, std::size_t index) {
  const auto next = state.execution.extended(index, state.threads[index].next);
  for (const auto& [execution, result] : next) {
    State after{execution, state.threads};
    after.threads[index].results.push_back(result);
    run_to_next_operation(after.threads[index], index);
    visit(after);
  }
  return !next.empty();
}

void Explorer::run_to_next_operation(Thread& thread, std::size_t index) const {
  const Context::Filter filter = [this, index](Operation& operation) {
    if (on_operation) on_operation(index, operation);
  };
  Context context(thread.results, filter);
  try {
    threads[index](context);
    thread.finished = true;
  } catch (const Pending& pending) {
    thread.next = pending.operation;
  }
  thread.notes = context.notes();
}

void Explorer::end(const State& state) {
  Outcome outcome;
  for (const Thread& thread : state.threads) {
    if (!thread.finished) throw Violation{"a thread waits for ever"};
    outcome.notes.push_back(thread.notes);
  }
  for (std::size_t i = 0; i < initial.size(); ++i) outcome.last.push_back(state.execution.last_value(i));
  ++executions_;
  if (on_end) on_end(outcome);
}

}  // namespace weak
}  // namespace model
}  // namespace tzc
