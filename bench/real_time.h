// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc {
namespace bench {

/// Why this machine does not let this user run threads in real time, and what to do about it; empty: it does.
std::string real_time_obstacle();

/// From now on this process is scheduled by SCHED_FIFO, threads that it starts later included, and its memory, later
/// mappings included, is in place and locked. A thread that computes for half a second without sleeping is killed (SIGXCPU),
/// so that a defect cannot take the machine. False: not permitted, and nothing is changed.
bool become_real_time();

}  // namespace bench
}  // namespace tzc
