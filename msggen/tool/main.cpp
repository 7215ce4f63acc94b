// SPDX-License-Identifier: BSD-3-Clause
#include <cerrno>
#include <cstring>
#include <exception>
#include <iostream>

#include "command_line/arguments.h"
#include "tool/commands.h"

namespace {

using namespace tzc::msggen;

const char* include_help =
    "Where a package's .msg files are; may be given for each package and more than once";

CLI::App* add_generate(CLI::App& app, GenerateOptions& options) {
  CLI::App* command = app.add_subcommand("generate", "Generate C++ headers: OUT/tzc/PACKAGE/TYPE.h");
  command->add_option("-p,--package", options.package, "The package that the files belong to");
  command->add_option("-I", options.includes, include_help)->type_name("PKG:DIR")->allow_extra_args(false);
  command->add_option("-o,--output", options.output, "The folder that gets the headers")
      ->type_name("OUT")
      ->required();
  command->add_flag("--installed", options.installed,
                    "All message packages of this machine's ROS, instead of files");
  command->add_flag(
      "--keep-going", options.keep_going,
      "Warn of definitions with faults, and generate the others; a header that is included for one "
      "of them stops the compiler with the reason. --installed does so");
  command->add_flag("--if-changed", options.if_changed, "Leave files alone that would not change");
  command->add_option("files", options.files, "Definition files: .msg, .srv, .action")->type_name("FILE");
  return command;
}

const char* const footer =
    "\nExamples:\n"
    "  tzc-msggen explain sensor_msgs/PointCloud2   which fields are data, which control\n"
    "  tzc-msggen generate -p my_msgs -I std_msgs:/opt/ros/noetic/share/std_msgs/msg -o include "
    "msg/Scan.msg\n"
    "  tzc-msggen classify --json src               a census of all types below src\n"
    "\ntzc-msggen COMMAND --help lists the options of a command.\n"
    "\nExit status: 0 done, 1 a definition is wrong or a header cannot be written, 2 error in the command "
    "line,\n"
    "or standard output cannot be written.\n";

CLI::App* add_classify(CLI::App& app, ClassifyOptions& options) {
  CLI::App* command = app.add_subcommand("classify", "A census: which types have a data part");
  command->add_option("-p,--package", options.package,
                      "The package of files that lie in no package's folder");
  command->add_option("-I", options.includes, include_help)->type_name("PKG:DIR")->allow_extra_args(false);
  command->add_flag("--json", options.json, "As JSON");
  command->add_option("inputs", options.inputs, "Folders of packages, or definition files")
      ->type_name("DIR|FILE")
      ->required();
  return command;
}

CLI::App* add_explain(CLI::App& app, ExplainOptions& options) {
  CLI::App* command = app.add_subcommand("explain", "A type's tree: control and data, sizes, md5sum");
  command->add_option("-I", options.includes, include_help)->type_name("PKG:DIR")->allow_extra_args(false);
  command->add_option("type", options.type, "The type, or a service")->type_name("PKG/TYPE")->required();
  return command;
}

int run(int argc, char** argv) {
  CLI::App app("The message generator of TZC: which part of a ROS message is control and which is data.",
               "tzc-msggen");
  app.set_version_flag("--version", "tzc-msggen " TZC_VERSION);
  app.require_subcommand(1);
  app.footer(footer);
  GenerateOptions generate_options;
  ClassifyOptions classify_options;
  ExplainOptions explain_options;
  const CLI::App* generating = add_generate(app, generate_options);
  const CLI::App* classifying = add_classify(app, classify_options);
  add_explain(app, explain_options);
  if (const auto over = tzc::command_line::parse(app, argc, argv)) return *over;
  const Console console{std::cout, std::cerr};
  if (generating->parsed()) return generate(generate_options, console);
  if (classifying->parsed()) return classify(classify_options, console);
  return explain(explain_options, console);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int status = run(argc, argv);
    if (std::cout.flush()) return status;
    std::cerr << "tzc-msggen: cannot write to standard output: " << std::strerror(errno) << '\n';
    return exit_usage;
  } catch (const std::exception& error) {
    std::cerr << "tzc-msggen: " << error.what() << '\n';
    return exit_usage;
  }
}
