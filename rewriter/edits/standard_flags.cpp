// SPDX-License-Identifier: BSD-3-Clause
#include "edits/standard_flags.h"

#include <set>

namespace tzc::rewriter {

std::string raised_standard(const std::string& flag) {
  static const std::set<std::string> older = {"98", "03", "0x", "11"};
  const std::string name = "-std=";
  if (flag.rfind(name, 0) != 0 || flag.size() < name.size() + 3) return flag;
  if (!older.count(flag.substr(flag.size() - 2))) return flag;
  return flag.substr(0, flag.size() - 2) + "14";
}

}  // namespace tzc::rewriter
