// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <sys/utsname.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "environment.h"

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

nlohmann::json to_json(const Row& row) {
  return {{"contender", row.contender}, {"size_bytes", row.size_bytes}, {"subscribers", row.subscribers},
          {"sent", row.sent},           {"delivered", row.delivered},   {"median_us", row.median_us},
          {"p99_us", row.p99_us},       {"publish_us", row.publish_us}};
}

/// What another contender did with the same messages.
const Row* find_beside(const std::vector<Row>& rows, const Row& row, const char* contender) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& other) {
    return other.contender == contender && other.size_bytes == row.size_bytes &&
           other.subscribers == row.subscribers;
  });
  return found == rows.end() ? nullptr : &*found;
}

std::string ratio(double a, double b) {
  return b > 0 ? fmt::format("{:.2f}", a / b) : std::string();
}

}  // namespace

nlohmann::json machine() {
  utsname system{};
  ::uname(&system);
  nlohmann::json document{{"cpu", cpu_model()},
                          {"cpus", std::thread::hardware_concurrency()},
                          {"kernel", system.release},
                          {"architecture", system.machine}};
  const std::string settings = settings_of_environment();
  if (!settings.empty()) document["environment"] = settings;
  return document;
}

void print_table(const std::vector<Row>& rows) {
  std::printf("%-20s %12s %12s %8s %10s %10s %10s %10s %9s %9s\n", "contender", "size_bytes", "subscribers",
              "sent", "delivered", "median_us", "p99_us", "publish_us", "x_socket", "tcpros_x");
  for (const Row& row : rows) {
    const Row* socket = find_beside(rows, row, "seqpacket");
    const Row* tcpros = find_beside(rows, row, "tcpros");
    std::printf("%-20s %12zu %12zu %8zu %10zu %10.1f %10.1f %10.1f %9s %9s\n", row.contender.c_str(),
                row.size_bytes, row.subscribers, row.sent, row.delivered, row.median_us, row.p99_us,
                row.publish_us, socket != nullptr ? ratio(row.median_us, socket->median_us).c_str() : "",
                tcpros != nullptr ? ratio(tcpros->median_us, row.median_us).c_str() : "");
  }
  std::fflush(stdout);
}

bool write_json(const std::string& path, const std::vector<Row>& rows) {
  auto as_json = nlohmann::json::array();
  for (const Row& row : rows) as_json.push_back(to_json(row));
  return write_rows(path, std::move(as_json));
}

bool write_rows(const std::string& path, nlohmann::json rows) {
  const nlohmann::json document{{"machine", machine()}, {"rows", std::move(rows)}};
  std::ofstream file(path);
  file << document.dump(2) << "\n";
  file.close();
  if (file) return true;
  std::fprintf(stderr, "cannot write %s\n", path.c_str());
  return false;
}

}  // namespace bench
}  // namespace tzc
