// SPDX-License-Identifier: BSD-3-Clause
#include "posix/step.h"

namespace tzc {
namespace posix {

std::atomic<StepHook> step_hook{nullptr};

}  // namespace posix
}  // namespace tzc
