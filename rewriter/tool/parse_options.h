// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "port/port_options.h"
#include "tool/answer.h"

namespace tzc::rewriter {

/// The command line, checked.
struct Options : PortOptions {
  std::string command;               ///< as typed, for reports
  std::vector<std::string> reports;  ///< files; the extension is known to be .json, .sarif or .html
  std::string baseline;
  std::vector<std::string> bags;
  bool quiet = false;
};

std::variant<Options, Answer> parse_options(int argc, const char* const* argv);

/// "4096", "64K", "64MB", "1GiB"; K, M and G are powers of 1024.
std::optional<std::uint64_t> parse_size(const std::string& text);

}  // namespace tzc::rewriter
