// SPDX-License-Identifier: BSD-3-Clause
#include "edits/standard_flags.h"

#include <set>

namespace tzc::rewriter {

bool is_standard_flag(const std::string& word) {
  return word.rfind("-std=", 0) == 0 || word.rfind("--std=", 0) == 0;
}

std::string raised_standard(const std::string& flag) {
  static const std::set<std::string> older = {"98", "03", "0x", "11"};
  const std::size_t value = flag.find('=') + 1;
  if (!is_standard_flag(flag) || flag.size() < value + 3) return flag;
  if (!older.count(flag.substr(flag.size() - 2))) return flag;
  return flag.substr(0, flag.size() - 2) + "14";
}

bool is_before_cxx11(const std::string& flag) {
  return is_old_standard(flag) && flag.substr(flag.size() - 2) != "11";
}

}  // namespace tzc::rewriter
