// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace tzc {
namespace bench {
namespace {

std::size_t parse_size(const std::string& text) {
  char* unit = nullptr;
  const double value = std::strtod(text.c_str(), &unit);
  const double factor = *unit == 'k' ? 1 << 10 : *unit == 'm' ? 1 << 20 : *unit == 'g' ? 1 << 30 : 1;
  return static_cast<std::size_t>(value * factor);
}

std::vector<std::size_t> parse_list(const std::string& text) {
  std::vector<std::size_t> values;
  std::istringstream stream(text);
  for (std::string item; std::getline(stream, item, ',');) values.push_back(parse_size(item));
  return values;
}

bool set_option(const std::string& name, const std::string& value, Options& options) {
  if (name == "--sizes") {
    options.sizes = parse_list(value);
  } else if (name == "--subscribers") {
    options.subscribers = parse_list(value);
  } else if (name == "--rate") {
    options.rate = std::strtod(value.c_str(), nullptr);
  } else if (name == "--count") {
    options.count = parse_size(value);
  } else if (name == "--only") {
    options.only = value;
  } else if (name == "--json") {
    options.json = value;
  } else {
    return false;
  }
  return true;
}

}  // namespace

bool parse_options(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; i += 2) {
    if (i + 1 < argc && set_option(argv[i], argv[i + 1], options)) continue;
    std::fprintf(stderr,
                 "%s: bad option %s\nusage: [--sizes 4k,4m] [--subscribers 1,8] [--rate HZ] [--count N] "
                 "[--only CONTENDER] [--json FILE]\n",
                 argv[0], argv[i]);
    return false;
  }
  return true;
}

}  // namespace bench
}  // namespace tzc
