// SPDX-License-Identifier: BSD-3-Clause
// The same headers in a second source: constants with a definition must be one object.
#include <tzc/demo/Corners.h>

const std::string& quote_of_another_file() {
  return tzc::demo::Corners::QUOTE;
}
