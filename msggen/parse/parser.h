// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/definition.h"
#include "parse/source.h"

namespace tzc::msggen {

/// Parses the lines of one message and reports every fault; the message then holds what could be parsed.
/// Names nested types without looking them up.
Message parse_message(const Section& section, const std::string& file, const std::string& package,
                      const std::string& name, Diagnostics& diagnostics);

/// The content of a definition file, by its extension.
struct ParsedFile {
  enum class Kind { message, service, action };
  Kind kind = Kind::message;
  std::string name;               ///< the file's name without extension
  std::vector<Message> messages;  ///< one; of a service request and response; of an action its seven
};

/// Parses a .msg, .srv or .action file of the package.
ParsedFile parse_file(const Source& source, const std::string& package, Diagnostics& diagnostics);

}  // namespace tzc::msggen
