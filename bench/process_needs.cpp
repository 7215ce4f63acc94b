// SPDX-License-Identifier: BSD-3-Clause
#include "process_needs.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace tzc {
namespace bench {
namespace {

std::string folder_of(pid_t process) {
  return "/proc/" + std::to_string(process);
}

std::size_t entries_of(const std::string& folder) {
  std::error_code failure;
  const std::filesystem::directory_iterator entries(folder, failure);
  return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

}  // namespace

std::size_t status_kb(pid_t process, const std::string& field) {
  std::ifstream status(folder_of(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.compare(0, field.size(), field) == 0)
      return std::strtoul(line.c_str() + field.size() + 1, nullptr, 10);
  }
  return 0;
}

Needs needs_of(pid_t process) {
  return {entries_of(folder_of(process) + "/task"), entries_of(folder_of(process) + "/fd"),
          status_kb(process, "RssAnon"), status_kb(process, "RssShmem")};
}

Needs most(const Needs& a, const Needs& b) {
  return {std::max(a.threads, b.threads), std::max(a.descriptors, b.descriptors),
          std::max(a.private_kb, b.private_kb), std::max(a.shared_kb, b.shared_kb)};
}

}  // namespace bench
}  // namespace tzc
