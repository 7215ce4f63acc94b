// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "model/expected.h"
#include "report/output.h"

namespace tzc::rewriter {

/// A JSON report of an earlier run: the sites that are accepted as they were then.
class Baseline {
 public:
  static Expected<Baseline> read(const std::string& file);

  /// A site is accepted when the same one was there with the same code.
  bool accepts(const Report& report, const Site& site) const;

 private:
  std::map<std::string, std::string> codes_;  ///< "package id" -> code
};

}  // namespace tzc::rewriter
