// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <vector>

namespace tzc {
namespace bench {

/// A machine that is busy with other work, as long as it exists: for each processor one process of normal priority that
/// computes and moves memory without a pause. They die with this process.
class Load {
 public:
  Load();
  ~Load();
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  std::vector<pid_t> workers_;
};

}  // namespace bench
}  // namespace tzc
