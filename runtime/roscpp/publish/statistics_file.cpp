// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/statistics_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "roscpp/throttled_warning.h"

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
  std::ofstream file(path, std::ios::app);
  file << line.str() << std::flush;
  if (!file)
    TZC_WARN_THROTTLED(60, "TZC: the statistics of " << topic << " cannot be appended to TZC_STATISTICS="
                                                     << path << ": " << std::strerror(errno));
}

}  // namespace detail
}  // namespace tzc
