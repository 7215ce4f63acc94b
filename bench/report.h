// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tzc {
namespace bench {

/// One measured combination. Latencies are one-way, in microseconds, over all subscribers.
struct Row {
  std::string contender;
  std::size_t size_bytes = 0;
  std::size_t subscribers = 0;
  std::size_t sent = 0;
  std::size_t delivered = 0;
  double median_us = 0;
  double p99_us = 0;
  /// The median of the publisher's own time: from where the latency begins until it goes on with something else. 0: not measured.
  double publish_us = 0;
};

/// What the figures depend on: processor, number of them, kernel, architecture; TZC's settings in the environment, where there
/// are some.
nlohmann::json machine();

/// A table of all rows. x_socket: a row's median divided by a bare socket's; tcpros_x: TCPROS' median divided
/// by the row's; both at the same size and number of subscribers, where those were measured.
void print_table(const std::vector<Row>& rows);
/// {"machine": {...}, "rows": [...]}; false when the file cannot be written.
bool write_rows(const std::string& path, nlohmann::json rows);
bool write_json(const std::string& path, const std::vector<Row>& rows);

}  // namespace bench
}  // namespace tzc
