// SPDX-License-Identifier: BSD-3-Clause
/// Records what the nodes of a graph publish, for tzc-compare, which starts it with its own ROS_MASTER_URI.
///
/// Standard output: a line of JSON ten times a second (Recorder::status). Standard input: "summary" is
/// answered with {"summary": ...}; at its end the recorder stops.
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "recorder/recorder.h"

namespace {

using tzc::compare::Recorder;
using tzc::compare::RecorderOptions;

constexpr int period_ms = 100;

void say(const nlohmann::json& line) {
  std::cout << line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) << std::endl;
}

/// False at the end of standard input.
bool answer(Recorder& recorder) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, period_ms) <= 0) return true;
  char text[64];
  const ssize_t size = ::read(STDIN_FILENO, text, sizeof text);
  if (size <= 0) return false;
  say({{"summary", recorder.summary()}});
  return true;
}

int record(const RecorderOptions& options) {
  Recorder recorder(options);
  ros::AsyncSpinner spinner(2);
  spinner.start();
  while (answer(recorder) && ros::ok()) {
    recorder.update();
    say(recorder.status());
  }
  ros::WallDuration(0.3).sleep();  // what is queued still comes
  spinner.stop();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Records what ROS nodes publish, for tzc-compare.", "tzc-compare-recorder");
  RecorderOptions options;
  bool tcpros = false;
  app.add_option("--bag", options.bag, "where the messages go")->required();
  app.add_option("--player", options.player, "the node whose messages are the input");
  app.add_option("--topic", options.topics, "topics to record, as regular expressions");
  app.add_option("--exclude", options.excluded, "topics to leave out, as regular expressions");
  app.add_flag("--tcpros", tcpros, "subscribe as an unported node does");
  CLI11_PARSE(app, argc, argv);
  options.uses_shared_memory = !tcpros;
  ros::M_string remappings;
  ros::init(remappings, "tzc_compare_recorder", ros::init_options::NoRosout);
  try {
    return record(options);
  } catch (
      const std::exception& failure) {  // a bag that cannot be written, a regular expression that is none
    std::fprintf(stderr, "tzc-compare-recorder: %s\n", failure.what());
    return 2;
  }
}
