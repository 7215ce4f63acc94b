// SPDX-License-Identifier: BSD-3-Clause
// Portable: socket files outlive a killed process; the next start sweeps them away.
#include <dirent.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "posix/address.h"
#include "posix/socket.h"

namespace tzc {
namespace posix {
namespace {

bool refuses(const std::string& path) {
  const Expected<FileDescriptor> probe = connect_to(path, std::chrono::milliseconds(0));
  return !probe && probe.error().code == ECONNREFUSED;
}

bool is_generated_name(const char* name) {
  return std::strncmp(name, "tzc-", 4) == 0 && std::strlen(name) == 36;
}

}  // namespace

void remove_dead_sockets() {
  const std::string example = generate_address();
  const std::string folder = example.substr(0, example.rfind('/'));
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(folder.c_str()), ::closedir);
  if (!entries) return;
  while (const dirent* entry = ::readdir(entries.get())) {
    const std::string path = folder + "/" + entry->d_name;
    if (is_generated_name(entry->d_name) && refuses(path)) ::unlink(path.c_str());
  }
}

}  // namespace posix
}  // namespace tzc
