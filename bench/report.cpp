// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <sys/utsname.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

namespace tzc {
namespace bench {
namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, 10, "model name") == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

nlohmann::json machine() {
  utsname system{};
  ::uname(&system);
  return {{"cpu", cpu_model()},
          {"cpus", std::thread::hardware_concurrency()},
          {"kernel", system.release},
          {"architecture", system.machine}};
}

nlohmann::json to_json(const Row& row) {
  return {{"contender", row.contender}, {"size_bytes", row.size_bytes}, {"subscribers", row.subscribers},
          {"sent", row.sent},           {"delivered", row.delivered},   {"median_us", row.median_us},
          {"p99_us", row.p99_us}};
}

}  // namespace

void print_header() {
  std::printf("%-20s %12s %12s %8s %10s %10s %10s\n", "contender", "size_bytes", "subscribers", "sent",
              "delivered", "median_us", "p99_us");
  std::fflush(stdout);  // or every forked process prints it again
}

void print_row(const Row& row) {
  std::printf("%-20s %12zu %12zu %8zu %10zu %10.1f %10.1f\n", row.contender.c_str(), row.size_bytes,
              row.subscribers, row.sent, row.delivered, row.median_us, row.p99_us);
  std::fflush(stdout);
}

bool write_json(const std::string& path, const std::vector<Row>& rows) {
  nlohmann::json document{{"machine", machine()}, {"rows", nlohmann::json::array()}};
  for (const Row& row : rows) document["rows"].push_back(to_json(row));
  std::ofstream file(path);
  file << document.dump(2) << "\n";
  if (file) return true;
  std::fprintf(stderr, "can't write %s\n", path.c_str());
  return false;
}

}  // namespace bench
}  // namespace tzc
