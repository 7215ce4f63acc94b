// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "paper/cell.h"
#include "sweep.h"

namespace tzc {
namespace bench {

/// The processes that the cells' contenders need beside their own, as long as it exists.
class Daemons {
 public:
  /// Starts them, and takes the cells away whose contender this machine cannot run; `said` has a line for each reason.
  Daemons(const Contenders& contenders, std::vector<Cell>& cells, std::vector<std::string>& said);

 private:
  std::string start(Daemon daemon);

  std::vector<std::shared_ptr<void>> running_;
};

}  // namespace bench
}  // namespace tzc
