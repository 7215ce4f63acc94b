// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target: definition files of one package, each introduced by a line `%% NAME.EXT`, are processed
// from bytes to headers. Beyond not crashing: a fault points into its file, and what has no fault has all its
// facts.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "emit/header.h"
#include "parse/library.h"
#include "parse/text.h"

namespace {

using namespace tzc::msggen;

struct Input {
  std::string name, bytes;
};

std::vector<Input> split_inputs(std::string_view all) {
  std::vector<Input> inputs = {{"First.msg", ""}};
  while (!all.empty()) {
    const std::size_t end = all.find('\n');
    const std::string_view line = all.substr(0, end);
    if (line.substr(0, 3) == "%% ") {
      inputs.push_back({std::string(line.substr(3)), ""});
    } else {
      inputs.back().bytes.append(line).append("\n");
    }
    all.remove_prefix(end == std::string_view::npos ? all.size() : end + 1);
  }
  return inputs;
}

void require(bool condition) {
  if (!condition) std::abort();
}

void check_fault(const Diagnostic& d, const std::vector<Input>& inputs) {
  require(!d.message.empty());
  require(!render(d).empty());
  for (const Input& input : inputs) {
    if (input.name != d.file || d.source_line.empty()) continue;
    require(d.at.line >= 1 && d.at.column >= 1);
    require(d.at.column <= character_count(d.source_line) + 1);
  }
}

void check_message(const Message& message, Library& library) {
  const Facts& facts = library.analysis().facts(message);
  require(facts.md5.size() == 32);
  require(!facts.has_data_part() || facts.has_variable_array);
  require(!facts.fixed_length || !facts.has_variable_array);
  require(library.analysis().full_text(message).size() >= message.text.size());
  require(emit_message(message, library.analysis()).text.find("#endif") != std::string::npos);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto inputs = split_inputs({reinterpret_cast<const char*>(data), size});
  Diagnostics diagnostics;
  Library library({{{"p", {"/nonexistent"}}}, {}, false}, diagnostics);
  std::vector<std::string> names;
  for (const Input& input : inputs) {
    const auto source = decode(input.name, input.bytes, diagnostics);
    if (!source) continue;
    const auto found = library.add_source(*source, "p");
    names.insert(names.end(), found.begin(), found.end());
  }
  for (const std::string& name : names) {
    const Message* message = library.find(name);
    require(message || !diagnostics.empty());
    if (message) check_message(*message, library);
  }
  for (const auto& service : library.services()) {
    require(!emit_service(service.package, service.name).text.empty());
  }
  for (const Diagnostic& d : diagnostics.sorted()) check_fault(d, inputs);
  return 0;
}
