// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "report/model.h"

namespace tzc::rewriter {

/// Whether a stream's descriptor is a terminal that wants colours (NO_COLOR and TERM=dumb are respected).
bool wants_colour(int descriptor);

/// One line on standard error that is overwritten as the work goes on; nothing where that is no terminal.
class TerminalProgress : public Progress {
 public:
  explicit TerminalProgress(bool enabled);
  ~TerminalProgress() override;
  void step(const std::string& stage, unsigned done, unsigned total, const std::string& what) override;
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
};

}  // namespace tzc::rewriter
