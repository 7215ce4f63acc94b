// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/arguments.h"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace tzc::command_line {

CLI::Validator number_between(double least, double most) {
  const CLI::Range range(least, most);
  const auto check = [range](std::string& text) {
    return std::isnan(std::strtod(text.c_str(), nullptr)) ? text + " is no number" : range(text);
  };
  return CLI::Validator(check, range.get_description());
}

CLI::Validator size_in_bytes() {
  const CLI::AsSizeValue size(false);
  const auto read = [size](std::string& text) -> std::string {
    if (text.find('-') != std::string::npos) return text + " is no number of bytes";
    try {
      const std::string given = text, fault = size(text);
      return !fault.empty() || std::strtoull(text.c_str(), nullptr, 10) >> 62 == 0 ? fault
                                                                                   : given + " is too large";
    } catch (const CLI::ValidationError& fault) {  // it throws for some, and returns the text for others
      return fault.what();
    }
  };
  return CLI::Validator(read, size.get_description());
}

CLI::Validator file_to_write() {
  const auto check = [](std::string& text) -> std::string {
    namespace fs = std::filesystem;
    if (text == "-") return "a file is expected, not standard output";
    std::error_code ignored;
    const fs::path file = fs::absolute(text, ignored);
    if (fs::is_directory(file, ignored)) return text + " is a folder";
    const fs::path looked_at = fs::exists(file, ignored) ? file : file.parent_path();
    return ::access(looked_at.c_str(), W_OK) == 0 ? "" : text + " cannot be written: " + std::strerror(errno);
  };
  return CLI::Validator(check, "FILE");
}

std::string why_incomplete(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--") break;
    if (argument.empty()) return "an argument is empty, behind '" + std::string(argv[i - 1]) + "'";
    if (argument.rfind("--", 0) == 0 && argument.find('=') == argument.size() - 1)
      return argument + ": a value is missing behind the '='";
  }
  return "";
}

std::optional<int> parse(CLI::App& app, int argc, const char* const* argv) {
  try {
    if (const std::string why = why_incomplete(argc, argv); !why.empty()) throw CLI::ValidationError(why);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& mistake) {
    return app.exit(mistake) == 0 ? 0 : 2;
  }
  return std::nullopt;
}

}  // namespace tzc::command_line
