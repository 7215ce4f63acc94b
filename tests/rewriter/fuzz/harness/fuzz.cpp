// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz.h"

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/topic_manager.h>
#ifdef FUZZ_TZC
#include <tzc/memory.h>
#endif

#include <boost/make_shared.hpp>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <functional>
#include <map>
#include <memory>

#include "log.h"

namespace fuzz {
namespace {

struct Topic {
  unsigned subscribers = 2, relays = 0;
  unsigned sent = 0, handled = 0;
};

std::string own_role;
std::map<std::string, Topic> topics;
std::unique_ptr<Log> listened;

/// Lines of a log, counted by topic; reads what was added since the last time.
class Tail {
 public:
  explicit Tail(const std::string& name) : path_(folder() + "/" + name) {}
  unsigned count(const std::string& topic) {
    if (!file_.is_open()) file_.open(path_);
    for (std::string line; std::getline(file_, line);) {
      partial_ += line;
      if (file_.eof()) break;
      ++counts_[partial_.substr(0, partial_.find(' '))];
      partial_.clear();
    }
    file_.clear();
    return counts_[topic];
  }

 private:
  std::string path_;
  std::ifstream file_;
  std::string partial_;
  std::map<std::string, unsigned> counts_;
};

Tail& tail(const std::string& name) {
  static std::map<std::string, std::unique_ptr<Tail>> tails;
  std::unique_ptr<Tail>& one = tails[name];
  if (!one) one.reset(new Tail(name));
  return *one;
}

/// A message that the listener keeps.
struct Kept {
  std::string topic;
  std::vector<std::uint8_t> received;
  std::function<std::vector<std::uint8_t>()> bytes;
};
std::deque<Kept> kept;
constexpr std::size_t most_kept = 200;

/// What has changed goes into the log, where the original has no such line.
void look_again() {
  for (Kept& one : kept) {
    const std::vector<std::uint8_t> now = one.bytes();
    if (now != one.received) listened->write(one.topic + "/changed", now.data(), now.size(), "changed");
    one.received = now;
  }
}

class Later : public ros::CallbackInterface {
 public:
  explicit Later(std::function<void()> function) : function_(std::move(function)) {}
  CallResult call() override {
    function_();
    return Success;
  }

 private:
  std::function<void()> function_;
};

[[noreturn]] void give_up(const std::string& what) {
  std::fprintf(stderr, "fuzz: waited in vain: %s\n", what.c_str());
  std::exit(3);
}

/// roscpp's XMLRPC server has a backlog of 5 connections. Two processes with a hundred topics that connect at once
/// overflow it (TcpExtListenOverflows), and the kernel sends a dropped SYN again after 1, 3, 7 ... 63 seconds.
const ros::WallDuration patience(150);

template <class Condition>
void until(Condition condition, const std::string& what) {
  const ros::WallTime deadline = ros::WallTime::now() + patience;
  while (!condition()) {
    if (ros::WallTime::now() > deadline) give_up(what);
    ros::WallDuration(0.002).sleep();
  }
}

bool is_shared(const void* data) {
#ifdef FUZZ_TZC
  return data && tzc::in_segment(data);
#else
  (void)data;
  return false;
#endif
}

}  // namespace

std::uint32_t value(int index, int k) {
  std::uint32_t x =
      static_cast<std::uint32_t>(index) * 2654435761U + static_cast<std::uint32_t>(k) * 40503U + 17;
  x ^= x >> 15;
  x *= 2246822519U;
  return (x ^ (x >> 13)) & 0xffffff;
}

int size(int k, int seed) {
  const std::uint32_t x = value(seed, k + 1000);
  if (x % 7 == 0) return 0;
  if (x % 11 == 0) return 5000 + static_cast<int>(x % 300);
  return 1 + static_cast<int>(x % 200);
}

void running(const std::string& program) {
  std::ofstream(folder() + "/talker.running") << program << '\n';
}

void sent(const std::string& topic) {
  ++topics[topic].sent;
}
void handled(const std::string& topic) {
  ++topics[topic].handled;
}

void wait(const std::string& topic) {
  until([&] { return ros::TopicManager::instance()->getNumSubscribers(topic) >= topics[topic].subscribers; },
        "subscribers of " + topic);
}

void drain(const std::string& topic) {
  for (const char* name : {"listener.log", "recorder.log"})
    until([&] { return tail(name).count(topic) >= topics[topic].sent; },
          "all of " + topic + " in " + name + ": " + std::to_string(topics[topic].sent));
}

void expect(const std::string& topic, unsigned subscribers, unsigned relays) {
  topics[topic].subscribers = subscribers;
  topics[topic].relays = relays;
}

void wait_for_all() {
  for (const auto& item : topics)
    if (ros::TopicManager::instance()->lookupPublication(item.first)) wait(item.first);
}

void settle() {
  const auto settled = [] {
    ros::getGlobalCallbackQueue()->callAvailable();
    for (const auto& item : topics)
      if (item.second.handled < item.second.relays * item.second.sent) return false;
    return true;
  };
  until(settled, "relays");
}

/// After the first round every publisher has had something to send; what follows is to find the connections
/// switched to shared memory. Messages must be equal whether they are or not.
void round_done() {
  static bool first = true;
  for (const auto& item : topics) drain(item.first);
  if (first) ros::WallDuration(0.5).sleep();
  first = false;
}

/// TZC's page shows counters that are at most a second old.
void write_counters(const std::string& file) {
  const char* const monitor = std::getenv("FUZZ_MONITOR");
  if (!monitor) return;
  ros::WallDuration(1.5).sleep();
  const std::string command = std::string(monitor) + " --json --interval 0 >" + folder() + "/" + file;
  if (std::system(command.c_str()) != 0) give_up("the counters of " + command);
}

int finish() {
  round_done();
  write_counters("counters.json");
  ros::shutdown();
  std::_Exit(0);  // image_transport's publishers, in the programs' globals, do not survive their plugins
}

void note(const std::string& topic, const std::vector<std::uint8_t>& bytes, const void* data) {
  listened->write(topic, bytes.data(), bytes.size(), is_shared(data) ? "shared" : "copied");
}

std::string role(int argc, char** argv) {
  own_role = argc > 1 ? argv[1] : "talker";
  return own_role;
}

bool listens() {
  return own_role == "listener";
}

void keep(const std::string& topic, std::function<std::vector<std::uint8_t>()> bytes) {
  look_again();
  std::vector<std::uint8_t> now = bytes();
  kept.push_back({topic, std::move(now), std::move(bytes)});
  if (kept.size() > most_kept) kept.pop_front();
}

int listen() {
  listened.reset(new Log("listener.log"));
  ros::spin();
  look_again();
  return 0;
}

void call(const std::function<void()>& function) {
  function();
}

void pause() {
  ros::WallDuration(0.002).sleep();
}

void later(const std::function<void()>& function) {
  ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<Later>(function));
}

}  // namespace fuzz
