// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
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
};

void print_header();
void print_row(const Row& row);
/// {"machine": {...}, "rows": [...]}; false when the file can't be written.
bool write_json(const std::string& path, const std::vector<Row>& rows);

}  // namespace bench
}  // namespace tzc
