// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model.h"

namespace tzc::monitor {

/// What an operator looks for first, in this order.
enum class ProblemKind {
  stopped,  ///< a process is stopped
  silent,   ///< a process runs and does nothing
  memory,   ///< messages find no shared memory
  lost,     ///< messages were sent and not taken in time
  tcpros,   ///< a connection that is not on shared memory
};

struct Problem {
  ProblemKind kind;
  std::string node;  ///< whose problem it is
  std::string text;  ///< who, what, why, what to do
};

const char* name(ProblemKind kind);

/// What is wrong with these nodes now; the worst first. A process is named once, however many see it.
std::vector<Problem> problems(const std::vector<Node>& nodes);

}  // namespace tzc::monitor
