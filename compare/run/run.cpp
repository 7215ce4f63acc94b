// SPDX-License-Identifier: BSD-3-Clause
#include "run/run.h"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <optional>
#include <set>

#include "loopback/reserved_port.h"
#include "run/failure.h"
#include "run/failures.h"
#include "run/process_tree.h"
#include "run/recorder_process.h"
#include "run/roscore.h"
#include "run/stop_request.h"
#include "run/workspace.h"

namespace tzc::compare {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr const char* player_name = "tzc_compare_player";
constexpr const char* player_delay_s = "2";  // between advertising and the first message: subscribers connect
constexpr double longest_drain_s = 30;
constexpr int status_ms = 100;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Of what tzc-compare runs itself, between the nodes: under names that the user's namespace does not change, and with
/// roscore's files out of the user's folder.
Environment own_environment(Environment environment, const std::string& folder) {
  environment.erase("ROS_NAMESPACE");
  environment["ROS_HOME"] = folder;
  return environment;
}

class WorkspaceRun {
 public:
  WorkspaceRun(const std::string& workspace, std::string folder, const Input& input, const Recorded& recorded,
               const Progress& progress)
      : folder_(std::move(folder)),
        input_(input),
        progress_(progress),
        environment_(session_environment(workspace, master_port_.number())),
        own_environment_(own_environment(environment_, folder_)),
        core_(own_environment_, folder_),
        recorder_(recorder_arguments(recorded), own_environment_, folder_ + "/recorder.log") {
    if (input_.simulates_time) core_.set_simulated_time();
  }

  Run run() {
    const Clock::time_point begin = Clock::now();
    start_nodes();
    wait_until_settled();
    Run result;
    result.ended_by_itself = input_.bag.empty() ? wait_for_nodes() : play();
    result.summary = recorder_.summary();
    cpu_.sample(pids());
    result.cpu_seconds = cpu_.seconds();
    result.seconds = seconds_since(begin);
    note_failures(false, result.failures);
    progress_("stopping");
    for (const auto& node : nodes_) node->stop();
    note_failures(true, result.failures);
    recorder_.finish();
    result.bag = folder_ + "/recording.bag";
    result.statistics = read_statistics();
    return result;
  }

 private:
  Environment session_environment(const std::string& workspace, int master_port) const {
    Environment environment = workspace_environment(workspace);
    environment["ROS_IP"] = "127.0.0.1";
    environment["ROS_LOG_DIR"] = folder_ + "/log";
    environment["TZC_STATISTICS"] = folder_ + "/statistics.json";
    environment["PYTHONUNBUFFERED"] = "1";
    environment["ROS_MASTER_URI"] = "http://127.0.0.1:" + std::to_string(master_port);
    return environment;
  }

  std::vector<std::string> recorder_arguments(const Recorded& recorded) const {
    std::vector<std::string> all{"--bag", folder_ + "/recording.bag", "--player",
                                 std::string("/") + player_name};
    for (const std::string& topic : recorded.topics) all.insert(all.end(), {"--topic", topic});
    for (const std::string& topic : recorded.excluded) all.insert(all.end(), {"--exclude", topic});
    if (recorded.over_tcpros) all.emplace_back("--tcpros");
    return all;
  }

  void start_nodes() {
    while (recorder_.status(status_ms).is_null()) progress_("starting the recorder");
    for (const std::string& launch : input_.launches) start_node("exec roslaunch " + launch);
    for (const std::string& command : input_.commands) start_node(command);
  }

  void start_node(const std::string& command) {
    const std::string log = log_of(nodes_.size());
    nodes_.push_back(
        std::make_unique<Child>(std::vector<std::string>{"bash", "-c", command}, environment_, log));
  }

  std::string log_of(std::size_t index) const { return fmt::format("{}/nodes-{}.log", folder_, index + 1); }

  /// Nodes that have died so far; commands that have ended badly, or have crashed when they were stopped.
  void note_failures(bool were_stopped, std::set<std::string>& failures) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      failures.merge(died_nodes(log_of(i)));
      const bool is_command = i >= input_.launches.size();
      const std::optional<int> status = nodes_[i]->status();
      if (!is_command || !status) continue;
      const std::string end = bad_end(input_.commands[i - input_.launches.size()], *status, were_stopped);
      if (!end.empty()) failures.insert(end);
    }
  }

  std::vector<pid_t> pids() const {
    std::vector<pid_t> all;
    for (const auto& node : nodes_) all.push_back(node->pid());
    return all;
  }

  bool any_node_runs() const {
    for (const auto& node : nodes_)
      if (node->is_running()) return true;
    return false;
  }

  /// The recorder's status, and a line of progress.
  const json& look(const std::string& what) {
    const json& status = recorder_.status(status_ms);
    cpu_.sample(pids());
    progress_(fmt::format("{}: {} nodes, {} topics, {} messages", what, status["nodes"].size(),
                          status["topics"].get<int>(), status["messages"].get<std::size_t>()));
    return status;
  }

  void wait_until_settled() {
    const Clock::time_point begin = Clock::now();
    Clock::time_point changed = begin;
    std::string graph;
    while (any_node_runs()) {
      const json& status = look("starting");
      if (status["graph"] != graph || !status["ready"].get<bool>() || status["nodes"].empty()) {
        graph = status["graph"];
        changed = Clock::now();
      }
      if (seconds_since(changed) >= input_.settle_s) return;
      if (seconds_since(begin) > input_.start_timeout_s) fail_to_start(status);
    }
    if (look("started")["messages"] == 0) fail_to_start(recorder_.status(0));
  }

  [[noreturn]] void fail_to_start(const json& status) const {
    std::string logs;
    for (const auto& node : nodes_) logs += node->log_tail();
    if (!status["nodes"].empty())
      throw Failure(fmt::format("after {} s the nodes still come and go, or do not let the recorder in:{}",
                                input_.start_timeout_s, logs),
                    "--start-timeout waits longer");
    throw Failure("no node has started:" + logs, "the logs' end is above; --keep FOLDER keeps them");
  }

  /// True when they end by themselves.
  bool wait_for_nodes() {
    const Clock::time_point begin = Clock::now();
    while (seconds_since(begin) < input_.duration_s) {
      if (!any_node_runs()) return true;
      look(fmt::format("running, {:.0f} of {:.0f} s", seconds_since(begin), input_.duration_s));
    }
    return false;
  }

  /// True when nothing is published any more after the bag.
  bool play() {
    std::vector<std::string> command{"rosbag", "play", "--quiet", "-d", player_delay_s};
    if (input_.simulates_time) command.emplace_back("--clock");
    command.insert(command.end(), input_.play_arguments.begin(), input_.play_arguments.end());
    command.insert(command.end(), {input_.bag, std::string("__name:=") + player_name});
    Child player(command, own_environment_, folder_ + "/player.log");
    while (player.is_running()) look("playing the bag");
    if (player.status() != 0) throw Failure("rosbag play has failed:" + player.log_tail());
    return wait_until_quiet();
  }

  bool wait_until_quiet() {
    const Clock::time_point begin = Clock::now();
    Clock::time_point changed = begin;
    std::size_t messages = 0;
    while (seconds_since(begin) < longest_drain_s) {
      const std::size_t now = look("waiting for the last messages")["messages"];
      if (now != messages) changed = Clock::now();
      messages = now;
      if (seconds_since(changed) >= input_.quiet_s) return true;
    }
    return false;
  }

  std::vector<json> read_statistics() const {
    std::ifstream file(folder_ + "/statistics.json");
    std::vector<json> all;
    for (std::string line; std::getline(file, line);) {
      const json entry = json::parse(line, nullptr, false);
      if (entry.is_object() && entry.contains("topic")) all.push_back(entry);
    }
    return all;
  }

  const std::string folder_;
  const Input& input_;
  const Progress& progress_;
  const loopback::ReservedPort master_port_;
  const Environment environment_;  // of the nodes
  const Environment own_environment_;
  RosCore core_;
  RecorderProcess recorder_;
  std::vector<std::unique_ptr<Child>> nodes_;
  CpuMeter cpu_;
};

/// Also when something goes wrong.
struct OrphanGuard {
  ~OrphanGuard() { kill_orphans(); }
};

}  // namespace

Run run_workspace(const std::string& workspace, const std::string& folder, const Input& input,
                  const Recorded& recorded, const Progress& progress) {
  const OrphanGuard guard;
  progress("starting roscore");
  return WorkspaceRun(workspace, folder, input, recorded, progress).run();
}

}  // namespace tzc::compare
