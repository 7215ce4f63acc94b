// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "paper/cell.h"

namespace tzc {
namespace bench {

using Fields = std::vector<std::string>;

/// A table with a heading, as the CSV files and the page show it. Every row has as many cells as `columns`.
struct Table {
  Fields columns;
  std::vector<Fields> rows;
};

/// One row a cell.
Table latency_table(const std::vector<Summary>& summaries);
/// One row a cell and subscriber.
Table reliability_table(const std::vector<Summary>& summaries);
/// One row a cell; every figure is of one message.
Table copies_table(const std::vector<Summary>& summaries);

/// RFC 4180, with line ends of one byte.
std::string to_csv(const Table& table);

/// A cell with its quartiles and every sample.
nlohmann::json to_json(const CellResult& result, const Summary& summary);

}  // namespace bench
}  // namespace tzc
