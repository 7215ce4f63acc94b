// SPDX-License-Identifier: BSD-3-Clause
// Prints as JSON all that the generator knows of definition files, for comparison with genmsg
// (oracle_test.py).
//   tzc-msggen-dump                     every installed message package
//   tzc-msggen-dump PACKAGE FILE...     these files; each with `accepted`, types looked up among the
//   installed ones
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "parse/library.h"
#include "tool/inputs.h"

namespace {

using namespace tzc::msggen;
using nlohmann::json;

json describe(const Message& message, Analysis& analysis) {
  json fields = json::array(), constants = json::array();
  for (const Field& f : message.fields) fields.push_back({f.type, f.name});
  for (const Constant& c : message.constants) constants.push_back({c.type, c.name, c.text, c.value});
  const Facts& facts = analysis.facts(message);
  return {{"md5", facts.md5},
          {"full_text", analysis.full_text(message)},
          {"fields", fields},
          {"constants", constants},
          {"fixed_length", facts.fixed_length},
          {"supported", facts.has_data_part()}};
}

json dump_installed() {
  Diagnostics diagnostics;
  Library library({{}, installed_packages, true}, diagnostics);
  json files = json::array(), messages = json::object(), services = json::object();
  const PackageIndex index = installed_packages();
  for (const auto& [name, package] : index.all()) {
    for (const std::string& file : package.definition_files()) {
      files.push_back(file);
      for (const std::string& type : library.add_file(file, name)) {
        if (const Message* message = library.find(type))
          messages[type] = describe(*message, library.analysis());
      }
    }
  }
  for (const auto& service : library.services()) {
    const Message* request = library.find(service.full_name() + "Request");
    const Message* response = library.find(service.full_name() + "Response");
    if (!request || !response) continue;
    services[service.full_name()] = service_md5(library.analysis(), *request, *response);
  }
  for (const Diagnostic& d : diagnostics.sorted()) std::cerr << render(d);
  return {{"files", files}, {"messages", messages}, {"services", services}};
}

// Each file by itself: what is wrong with one says nothing about the next.
json dump_files(const std::string& package, const std::vector<std::string>& files) {
  const PackageIndex installed = installed_packages();
  json result = json::object();
  for (const std::string& file : files) {
    Diagnostics diagnostics;
    Library library({{}, [&] { return installed; }, true}, diagnostics);
    json messages = json::object();
    for (const std::string& type : library.add_file(file, package)) {
      if (const Message* message = library.find(type))
        messages[type] = describe(*message, library.analysis());
    }
    std::string faults;
    for (const Diagnostic& d : diagnostics.sorted()) faults += render(d);
    result[file] = {{"accepted", diagnostics.empty()}, {"messages", messages}, {"faults", faults}};
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const json result = arguments.empty() ? dump_installed()
                                        : dump_files(arguments[0], {arguments.begin() + 1, arguments.end()});
  std::cout << result.dump(1, ' ', false, json::error_handler_t::replace) << '\n';
}
