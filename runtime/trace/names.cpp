// SPDX-License-Identifier: BSD-3-Clause
#include "trace/names.h"

namespace tzc {
namespace trace {

std::string file_name(const std::string& pattern, std::uint32_t process) {
  const std::string number = std::to_string(process);
  if (pattern.find("%p") == std::string::npos) return pattern + "." + number;
  std::string name = pattern;
  for (std::size_t at = 0; (at = name.find("%p", at)) != std::string::npos; at += number.size())
    name.replace(at, 2, number);
  return name;
}

}  // namespace trace
}  // namespace tzc
