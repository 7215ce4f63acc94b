// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/host_identity.h"

#include <sys/stat.h>

#include <fstream>
#include <mutex>

namespace tzc {
namespace detail {
namespace {

std::string read_identity() {
  std::string boot;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
  struct stat network;
  if (boot.empty() || stat("/proc/self/ns/net", &network) != 0) return std::string();
  return boot + "/" + std::to_string(network.st_dev) + ":" + std::to_string(network.st_ino);
}

}  // namespace

std::string host_identity() {
  static auto* const mutex = new std::mutex;  // outlives every thread
  static auto* const known = new std::string;
  const std::lock_guard<std::mutex> lock(*mutex);
  if (known->empty()) *known = read_identity();
  return *known;
}

}  // namespace detail
}  // namespace tzc
