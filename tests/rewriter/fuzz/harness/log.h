// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace fuzz {

/// The folder that talker, listener and recorder share.
inline std::string folder() {
  const char* name = std::getenv("FUZZ_FOLDER");
  return name ? name : ".";
}

/// One line for each message, complete as soon as it is written: topic, length, checksum, first bytes, mark.
class Log {
 public:
  explicit Log(const std::string& name) : file_(std::fopen((folder() + "/" + name).c_str(), "w")) {
    if (!file_) throw std::runtime_error("cannot write " + folder() + "/" + name);
  }
  ~Log() { std::fclose(file_); }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  void write(const std::string& topic, const std::uint8_t* bytes, std::size_t count, const char* mark) {
    std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
    for (std::size_t i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * 1099511628211ULL;
    std::fprintf(file_, "%s %zu %016llx ", topic.c_str(), count, static_cast<unsigned long long>(hash));
    for (std::size_t i = 0; i < count && i < 24; ++i) std::fprintf(file_, "%02x", bytes[i]);
    std::fprintf(file_, "- %s\n", mark);
    std::fflush(file_);
  }

 private:
  std::FILE* file_;
};

}  // namespace fuzz
