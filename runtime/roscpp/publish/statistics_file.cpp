// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/statistics_file.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace tzc {
namespace detail {

void append_statistics(const std::string& topic, const PublisherStatistics& statistics) {
  const char* const path = std::getenv("TZC_STATISTICS");
  if (!path || !*path) return;
  std::ostringstream line;  // one write: several processes may share the file
  line << "{\"topic\": \"" << topic << "\", \"messages\": " << statistics.messages
       << ", \"shared\": " << statistics.shared << ", \"serialized\": " << statistics.serialized
       << ", \"copied_bytes\": " << statistics.copied_bytes
       << ", \"control_bytes\": " << statistics.control_bytes << ", \"exhausted\": " << statistics.exhausted
       << ", \"dropped\": " << statistics.dropped << ", \"revoked\": " << statistics.revoked << "}\n";
  std::ofstream(path, std::ios::app) << line.str() << std::flush;
}

}  // namespace detail
}  // namespace tzc
