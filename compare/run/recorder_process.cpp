// SPDX-License-Identifier: BSD-3-Clause
#include "run/recorder_process.h"

#include <chrono>
#include <filesystem>

#include "run/failure.h"
#include "run/stop_request.h"

namespace tzc::compare {
namespace {

using nlohmann::json;

constexpr int summary_step_ms = 100;
constexpr std::chrono::seconds summary_patience(15);  // without a byte; a long input's times take many reads
constexpr int flush_ms = 120'000;                     // what is queued for a slow disk

/// It is installed and built beside this program.
std::vector<std::string> command(const std::vector<std::string>& arguments) {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  std::vector<std::string> all{(folder / "tzc-compare-recorder").string()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

}  // namespace

RecorderProcess::RecorderProcess(const std::vector<std::string>& arguments, const Environment& environment,
                                 const std::string& log_file)
    : child_(command(arguments), environment, log_file, Child::Input::pipe) {}

void RecorderProcess::fail() {
  throw Failure("the recorder has ended:" + child_.log_tail());
}

void RecorderProcess::read(int wait_ms) {
  const std::string more = child_.read_output(wait_ms);
  if (!more.empty()) heard_ = Clock::now();
  std::size_t end = more.find('\n');
  if (end != std::string::npos) end += text_.size();
  text_ += more;
  for (; end != std::string::npos; end = text_.find('\n')) {
    const json line = json::parse(text_.substr(0, end), nullptr, false);
    text_.erase(0, end + 1);
    if (line.contains("summary")) summary_ = line["summary"];
    if (line.contains("graph")) status_ = line;
  }
}

const json& RecorderProcess::status(int wait_ms) {
  read(wait_ms);
  sleep_ms(1);  // a stop request counts
  if (!child_.is_running()) fail();
  const std::string error = status_.is_null() ? "" : status_.value("error", "");
  if (!error.empty())
    throw Failure("the recording cannot be written: " + error, "--scratch names another folder");
  return status_;
}

json RecorderProcess::summary() {
  summary_ = nullptr;
  child_.write("summary\n");
  heard_ = Clock::now();
  while (summary_.is_null() && Clock::now() - heard_ < summary_patience) status(summary_step_ms);
  if (summary_.is_null()) throw Failure("the recorder does not answer:" + child_.log_tail());
  return summary_;
}

void RecorderProcess::finish() {
  child_.close_input();
  for (int left = flush_ms; child_.is_running() && left > 0; left -= summary_step_ms) {
    read(summary_step_ms);
    sleep_ms(1);
  }
  if (child_.status() != 0) fail();
}

}  // namespace tzc::compare
