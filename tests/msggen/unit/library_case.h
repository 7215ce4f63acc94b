// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A small language for tests: definitions in a string, read as files of the package `demo`.
#include <gtest/gtest.h>

#include <string>

#include "parse/library.h"

namespace tzc::msggen::test {

class LibraryCase {
 public:
  LibraryCase& file(const std::string& name, const std::string& text) {
    if (const auto source = decode(name, text, diagnostics)) library.add_source(*source, "demo");
    return *this;
  }

  /// The message, which must be good.
  const Message& good(const std::string& name) {
    const Message* message = library.find("demo/" + name);
    if (!message) throw std::runtime_error(name + " is not good:\n" + faults());
    return *message;
  }
  const Facts& facts(const std::string& name) { return library.analysis().facts(good(name)); }

  std::string faults() const {
    std::string text;
    for (const Diagnostic& d : diagnostics.sorted()) text += render(d);
    return text;
  }

  Diagnostics diagnostics;
  Library library{{{}, {}, false}, diagnostics};
};

/// The one constant of a message with this line.
inline Constant constant(const std::string& line) {
  LibraryCase c;
  c.file("A.msg", line);
  const auto& constants = c.good("A").constants;
  if (constants.size() != 1) throw std::runtime_error("not a constant: " + line);
  return constants[0];
}

}  // namespace tzc::msggen::test
