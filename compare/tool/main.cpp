// SPDX-License-Identifier: BSD-3-Clause
/// tzc-compare: runs two workspaces and compares what they publish.
///
///   Options -> run_workspace (original, port, original again) -> bags -> Recording
///           -> compare_recordings -> judge -> Result -> text and JSON
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "report/reports.h"
#include "run/child.h"
#include "run/failure.h"
#include "run/load_bag.h"
#include "run/stop_request.h"
#include "run/workspace.h"
#include "tool/options.h"
#include "tool/progress.h"

namespace tzc::compare {
namespace {

namespace fs = std::filesystem;

constexpr int equal = 0, different = 1, error = 2, interrupted = 130;

/// The folder of recordings and logs; deleted at the end unless it is to be kept.
class RunFolder {
 public:
  explicit RunFolder(const Options& options) : is_kept_(!options.keep.empty()) {
    if (is_kept_) {
      path_ = fs::absolute(options.keep);
      fs::create_directories(path_);
      if (!fs::is_empty(path_)) throw Failure(path_.string() + " is not empty", "--keep names a new folder");
      return;
    }
    // mkdtemp(3) puts a unique name where the six Xs are.
    std::string pattern = (fs::absolute(options.scratch) / "tzc-compare-XXXXXX").string();
    if (!::mkdtemp(pattern.data()))
      throw Failure("no folder can be made in " + options.scratch, "see --scratch");
    path_ = pattern;
  }
  ~RunFolder() {
    std::error_code ignored;
    if (!is_kept_) fs::remove_all(path_, ignored);
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  std::string make(const std::string& name) const {
    fs::create_directories(path_ / name);
    return (path_ / name).string();
  }

 private:
  const bool is_kept_;
  fs::path path_;
};

struct RecordedRun {
  Run run;
  Recording recording;
};

class Tool {
 public:
  explicit Tool(const Options& options) : options_(options), folder_(options), progress_(options.is_quiet) {}

  Result run() {
    // The port runs between two runs of the original, so that a machine that becomes slower or faster favours
    // none of them.
    const RecordedRun original = record("original", options_.original, 1);
    check_that_something_came(original);
    const RecordedRun port = record("port", options_.port, 1);
    std::vector<RecordedRun> again;
    for (int i = 2; i <= options_.runs; ++i) again.push_back(record("original", options_.original, i));
    progress_.begin_part("comparing");
    Result result = judge_all(original, port, again);
    check_for_stop_request();  // streams without a pair were not read
    progress_.end();
    return result;
  }

 private:
  RecordedRun record(const std::string& what, const std::string& workspace, int number) {
    progress_.begin_part(fmt::format("[{}/{}] {}", ++part_, options_.runs + 1, what));
    RecordedRun recorded;
    recorded.run = run_workspace(workspace, folder_.make(fmt::format("{}-{}", what, number)), options_.input,
                                 options_.recorded, [&](const std::string& text) { progress_.show(text); });
    progress_.show("reading the recording");
    recorded.recording = load_recording(recorded.run.bag, recorded.run.summary);
    return recorded;
  }

  static void check_that_something_came(const RecordedRun& original) {
    for (const Stream& stream : original.recording)
      if (!stream.messages.empty()) return;
    std::string failures;
    for (const std::string& failure : original.run.failures) failures += "\n  " + failure;
    throw Failure("the original's nodes have published nothing that is compared" + failures,
                  "see --duration, --bag, --topic; --keep FOLDER keeps the logs");
  }

  static void add_late_topics(Rules& rules, const std::vector<const RecordedRun*>& runs) {
    for (const RecordedRun* recorded : runs)
      for (const std::string topic : recorded->run.summary["late"]) rules.late_topics.insert(topic);
  }

  Result judge_all(const RecordedRun& original, const RecordedRun& port,
                   const std::vector<RecordedRun>& again) {
    Rules rules = options_.rules;
    add_late_topics(rules, {&original, &port});
    rules.judge_before = !options_.input.bag.empty();
    rules.judge_after = original.run.ended_by_itself && port.run.ended_by_itself;
    std::vector<Comparison> own;
    for (const RecordedRun& other : again) {
      add_late_topics(rules, {&other});
      rules.judge_after = rules.judge_after && other.run.ended_by_itself;
      progress_.show("the original with itself");
      own.push_back(compare_recordings(original.recording, other.recording, options_.left_out));
    }
    progress_.show("the port with the original");
    Result result;
    result.verdicts =
        judge(own, compare_recordings(original.recording, port.recording, options_.left_out), rules);
    result.original = options_.original;
    result.port = options_.port;
    result.original_runs = options_.runs;
    result.original_resources = resources_of(original.run, original.recording);
    result.port_resources = resources_of(port.run, port.recording);
    result.omissions.topics = original.run.summary["left_out"].get<std::vector<std::string>>();
    result.omissions.unknown_fields = unknown_fields(original.recording, options_.left_out);
    result.own_failures = original.run.failures;
    for (const RecordedRun& other : again)
      result.own_failures.insert(other.run.failures.begin(), other.run.failures.end());
    for (const std::string& failure : port.run.failures)
      if (result.own_failures.count(failure) == 0) result.port_failures.insert(failure);
    result.omissions.late_topics = rules.late_topics;
    result.judges_before = rules.judge_before;
    result.judges_after = rules.judge_after;
    return result;
  }

  const Options& options_;
  const RunFolder folder_;
  ProgressLine progress_;
  int part_ = 0;
};

void write_json(const Result& result, const std::string& file) {
  const std::string text =
      json_report(result).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  if (file == "-") {
    std::fputs(text.c_str(), stdout);
    return;
  }
  std::ofstream out(file);
  out << text << std::flush;
  if (!out) throw Failure(file + " cannot be written");
}

int run(const Options& options) {
  for (const std::string& workspace : {options.original, options.port})
    (void)setup_file(workspace);  // or it throws
  adopt_orphans();
  watch_for_stop_requests();
  const Result result = Tool(options).run();
  if (options.json != "-") std::fputs(text_report(result).c_str(), stdout);
  if (!options.json.empty()) write_json(result, options.json);
  return result.is_different() ? different : equal;
}

int run(int argc, char** argv) {
  int status = equal;
  const auto options = parse_options(argc, argv, status);
  if (options) status = run(*options);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Failure("cannot write to standard output", std::strerror(errno));
  return status;
}

int run_and_explain(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const Stopped&) {
    std::fputs("tzc-compare: stopped\n", stderr);
    return interrupted;
  } catch (const Failure& failure) {
    std::fprintf(stderr, "tzc-compare: %s\n", failure.what());
    if (!failure.hint().empty()) std::fprintf(stderr, "  %s\n", failure.hint().c_str());
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "tzc-compare: %s\n", failure.what());
  }
  return error;
}

}  // namespace
}  // namespace tzc::compare

int main(int argc, char** argv) {
  return tzc::compare::run_and_explain(argc, argv);
}
