// SPDX-License-Identifier: BSD-3-Clause
// usage: crash_test [--kills N] [--seed S] [--pause-on-failure]
//
// One publisher and three subscribers exchange messages of several blocks; again and again one of them is
// killed, half of the time at a random moment, half of the time between two chosen steps of allocate,
// publish, take or release. The survivors must go on, every message must be intact, and what the dead held
// must be free again at once.
#include <dirent.h>
#include <sys/mman.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "board.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace crash {

Board* board = nullptr;
int own_role = -1;

namespace {

constexpr std::int64_t ms = 1'000'000;
#ifdef TZC_PORTABLE
constexpr int segment_descriptors = 2;
#else
constexpr int segment_descriptors = 1;
#endif

struct Tally {
  int kills = 0, aimed = 0;
  std::vector<std::int64_t> until_free;
};

template <std::size_t n>
const char* step_name(const char* const (&names)[n], int index) {
  return names[static_cast<std::size_t>(index) % n];
}

// Runs in the victim, between two steps.
void die_here(const char* step) {
  if (board->aimed_role != own_role) return;
  const int index = board->aimed_step;
  const char* wanted =
      own_role == publisher ? step_name(publisher_steps, index) : step_name(subscriber_steps, index);
  if (std::strcmp(step, wanted) != 0 || --board->steps_left > 0) return;
  board->died_at = now_ns();
  ::kill(::getpid(), SIGKILL);
}

bool wait_for(std::int64_t nanoseconds, const std::function<bool()>& condition) {
  const std::int64_t until = now_ns() + nanoseconds;
  while (!condition()) {
    if (now_ns() > until) return false;
    ::usleep(100);
  }
  return true;
}

int count_descriptors(pid_t pid) {
  DIR* folder = ::opendir(("/proc/" + std::to_string(pid) + "/fd").c_str());
  if (folder == nullptr) return -1;
  int count = -2;  // . and ..
  while (::readdir(folder) != nullptr) ++count;
  ::closedir(folder);
  return count;
}

// Files that the library itself would make: "tzc-NONCE" or "tzc-PID-NONCE". Tests that run meanwhile make others
// ("tzc-compare-..." has a hexadecimal digit there, too).
bool is_ours(const std::string& name) {
  return name.size() > 4 && name.compare(0, 4, "tzc-") == 0 &&
         name.find_first_not_of("0123456789abcdef-", 4) == std::string::npos;
}

std::set<std::string> files_in(const char* path) {
  std::set<std::string> names;
  if (DIR* folder = ::opendir(path)) {
    while (const dirent* entry = ::readdir(folder)) {
      if (is_ours(entry->d_name)) names.insert(entry->d_name);
    }
    ::closedir(folder);
  }
  return names;
}

class Supervisor {
 public:
  explicit Supervisor(unsigned seed) : random_(seed) {
    for (int role = 0; role < roles; ++role) start(role);
  }
  ~Supervisor() {
    for (const pid_t pid : pids_) ::kill(pid, SIGKILL);
    for (const pid_t pid : pids_) ::waitpid(pid, nullptr, 0);
  }

  /// False: the survivors did not go on.
  bool kill_one(Tally& tally) {
    if (!everyone_receives()) return fail("a subscriber receives nothing any more");
    const int victim = random_() % 2 ? publisher : static_cast<int>(random_() % subscribers);
    const bool hit = 2 * tally.aimed <= tally.kills && kill_at_a_step(victim);
    if (!hit) kill_now(victim);
    ++tally.kills;
    tally.aimed += hit ? 1 : 0;
    const bool survived = victim == publisher || check_that_all_is_free(tally);
    reap(victim);
    if (survived) start(victim);
    return survived;
  }

 private:
  void start(int role) {
    const unsigned seed = random_();
    const pid_t pid = ::fork();
    if (pid != 0) {
      pids_[role] = pid;
      return;
    }
    own_role = role;
    sync_point_hook = die_here;
    role == publisher ? run_publisher(seed) : run_subscriber(seed);
    ::_exit(0);
  }

  bool everyone_receives() {
    std::uint64_t before[subscribers];
    for (int i = 0; i < subscribers; ++i) before[i] = board->received[i];
    return wait_for(20'000 * ms, [&] {
      for (int i = 0; i < subscribers; ++i) {
        if (board->received[i] < before[i] + 3) return false;
      }
      return true;
    });
  }

  bool kill_at_a_step(int victim) {
    board->died_at = 0;
    board->steps_left = 1 + static_cast<int>(random_() % 5);
    board->aimed_step = static_cast<int>(random_() % 100);
    board->aimed_role = victim;
    const bool died = wait_for(50 * ms, [] { return board->died_at != 0; });
    board->aimed_role = -1;
    return died;
  }

  void kill_now(int victim) {
    ::usleep(random_() % 3000);
    board->died_at = now_ns();
    ::kill(pids_[victim], SIGKILL);
  }

  // Only after the measurement: reaping a process may take the kernel longer than everything that it left
  // behind.
  void reap(int victim) {
    int status = 0;
    ::waitpid(pids_[victim], &status, 0);
    if (!WIFSIGNALED(status) || WTERMSIG(status) != SIGKILL) report_error("a process died by itself");
  }

  bool check_that_all_is_free(Tally& tally) {
    board->all_free_since = 0;
    board->phase = Phase::quiesce;
    if (!wait_for(10'000 * ms, [] { return board->all_free_since != 0; }))
      return fail("memory of the dead stays in use");
    tally.until_free.push_back(board->all_free_since - board->died_at);
    const bool no_leak =
        wait_for(2'000 * ms, [&] { return count_descriptors(pids_[publisher]) <= most_descriptors(); });
    board->phase = Phase::run;
    return no_leak || fail("the publisher leaks descriptors");
  }

  // Standard streams, two of the service, the listener, one segment (two in the portable build), and a socket
  // for each live subscriber; the process was forked from the supervisor.
  static int most_descriptors() {
    return 3 + 2 + 1 + segment_descriptors + (subscribers - 1) + inherited_descriptors;
  }

  // With --pause-on-failure everything stays as it is, for a debugger.
  bool fail(const char* what) const {
    std::fprintf(stderr, "crash_test: %s; subscribers", what);
    for (const pid_t pid : pids_) std::fprintf(stderr, " %d", static_cast<int>(pid));
    std::fprintf(stderr, " is the publisher\n");
    if (pause_on_failure) ::pause();
    return false;
  }

  std::mt19937 random_;
  pid_t pids_[roles] = {};

 public:
  static int inherited_descriptors;
  static bool pause_on_failure;
};

int Supervisor::inherited_descriptors = 0;
bool Supervisor::pause_on_failure = false;

void open_board() {
  void* memory = ::mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  board = new (memory) Board();
  board->aimed_role = -1;
  std::snprintf(board->address, sizeof board->address, "@tzc-crash-%d", static_cast<int>(::getpid()));
}

/// In milliseconds. Of fewer values a p95 would be the worst of all, or the one before: one late wake-up of a busy machine.
bool is_quick(std::size_t count, double p95, double worst) {
  constexpr std::size_t least_for_p95 = 50;
  return worst <= 1000 && (count < least_for_p95 || p95 <= 100);
}

int report(Tally& tally, bool survived, bool left_files) {
  std::sort(tally.until_free.begin(), tally.until_free.end());
  const std::size_t count = tally.until_free.size();
  const double p95 = count ? static_cast<double>(tally.until_free[count * 95 / 100]) / 1e6 : 0;
  const double worst = count ? static_cast<double>(tally.until_free.back()) / 1e6 : 0;
  std::printf(
      "%d kills, %d of them between two chosen steps; %d errors; memory of the dead free after %.1f ms "
      "(p95), "
      "%.1f ms (worst)%s\n",
      tally.kills, tally.aimed, board->errors.load(), p95, worst, left_files ? "; FILES LEFT BEHIND" : "");
  return survived && board->errors == 0 && !left_files && is_quick(count, p95, worst) ? 0 : 1;
}

int run(int kills, unsigned seed) {
  open_board();
  Supervisor::inherited_descriptors = count_descriptors(::getpid()) - 1 - 3;  // -1: the folder being read
  const auto shm_before = files_in("/dev/shm"), tmp_before = files_in("/tmp");
  Tally tally;
  bool survived = true;
  {
    Supervisor supervisor(seed);
    while (survived && tally.kills < kills && board->errors == 0) survived = supervisor.kill_one(tally);
  }
  return report(tally, survived, files_in("/dev/shm") != shm_before || files_in("/tmp") != tmp_before);
}

}  // namespace
}  // namespace crash
}  // namespace tzc

int main(int argc, char** argv) {
  int kills = 200;
  unsigned seed = static_cast<unsigned>(::getpid());
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--pause-on-failure") == 0) tzc::crash::Supervisor::pause_on_failure = true;
    if (i + 1 == argc) break;
    if (std::strcmp(argv[i], "--kills") == 0) kills = std::atoi(argv[i + 1]);
    if (std::strcmp(argv[i], "--seed") == 0) seed = static_cast<unsigned>(std::atoi(argv[i + 1]));
  }
  return tzc::crash::run(kills, seed);
}
