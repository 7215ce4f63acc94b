// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tzc {
namespace bench {

/// What every latency command understands:
///   --sizes 4k,4m,64m  --subscribers 1,8  --rate HZ  --count MESSAGES  --only CONTENDER  --json FILE
struct Options {
  std::vector<std::size_t> sizes{4096, 1 << 20, 4 << 20, 64 << 20};
  std::vector<std::size_t> subscribers{1, 8};
  double rate = 100;
  std::size_t count = 300;
  std::string only;
  std::string json;
};

/// False after telling the user what is wrong.
bool parse_options(int argc, char** argv, Options& options);

}  // namespace bench
}  // namespace tzc
