// SPDX-License-Identifier: BSD-3-Clause
// What a message costs a real-time thread after start-up: no memory of malloc, no page fault, and no system call but the
// futex of a wake-up, on which the publisher never waits. A program of its own, because it defines malloc.
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/futex.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "posix/futex.h"
#include "segment/extents.h"
#include "tzc/channel.h"

namespace {

thread_local bool counting = false;
thread_local std::uint64_t allocations = 0;

}  // namespace

// glibc's own names of what the functions below replace.
extern "C" {
void* __libc_malloc(std::size_t);                 // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t, std::size_t);    // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void*, std::size_t);         // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t, std::size_t);  // NOLINT(bugprone-reserved-identifier)

void* malloc(std::size_t bytes) {
  allocations += counting ? 1 : 0;
  return __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
  allocations += counting ? 1 : 0;
  return __libc_calloc(count, bytes);
}
void* realloc(void* memory, std::size_t bytes) {
  allocations += counting ? 1 : 0;
  return __libc_realloc(memory, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  allocations += counting ? 1 : 0;
  return __libc_memalign(alignment, bytes);
}
}

namespace tzc {
namespace channel {
namespace {

constexpr std::size_t block_bytes = 256 << 10;
constexpr std::size_t readers = 3;
constexpr std::uint64_t warm_up = 200, measured = 600;
constexpr std::uint64_t burst = 8;               // messages that the publisher sends while a reader is late
constexpr std::uint32_t rehearsal = 0xffffffff;  // the tag of a message that is sent before all others

/// What one thread spent on the measured messages.
struct Spent {
  static constexpr int none = -1;
  std::atomic<std::uint64_t> allocations{0}, page_faults{0};
  std::optional<std::uint64_t> page_faults_before;  // of the thread; nothing: they are not counted
  std::atomic<int> forbidden_call{none};
  std::atomic<bool> complete{false};
};

enum class Role { publisher, reader };
/// Runs in each measured thread after its warm-up.
using Guard = std::function<void(Role)>;

/// Memory that the measuring child and the test share.
struct Report {
  Spent publisher, reader[readers];
  std::atomic<std::uint64_t> received[readers];
};

thread_local Spent* spent_here = nullptr;

std::uint64_t page_faults_here() {
  rusage usage{};
  ::getrusage(RUSAGE_THREAD, &usage);
  return static_cast<std::uint64_t>(usage.ru_minflt + usage.ru_majflt);
}

void begin(Spent& spent, Role role, const Guard& guard) {
  spent_here = &spent;
  guard(role);
  allocations = 0;
  counting = true;
}

void end(Spent& spent) {
  counting = false;
  spent.allocations = allocations;
  if (spent.page_faults_before) spent.page_faults = page_faults_here() - *spent.page_faults_before;
  spent.complete = true;
}

void sleep_us(long microseconds) {
  const timespec pause{0, microseconds * 1000};
  ::clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, nullptr);
}

/// A publisher with readers in threads of their own. on_message gets the reader's number and the message's.
struct Channel {
  explicit Channel(const std::function<void(std::size_t, std::uint64_t)>& on_message) {
    MemoryOptions memory;
    memory.size = (burst + readers + 2) * block_bytes;
    memory.prefault = Prefault::all;
    PublisherOptions options;
    options.memory = *SegmentMemory::create(memory);
    publisher = *Publisher::create(options);
    for (std::size_t who = 0; who < readers; ++who) subscribe(who, on_message);
  }

  // Keeps the latest message, as a control loop does that needs it until the next one comes. Is late for some.
  void subscribe(std::size_t who, const std::function<void(std::size_t, std::uint64_t)>& on_message) {
    SubscriberOptions options;
    options.address = publisher->address();
    options.private_writes = false;
    options.on_message = [this, who, on_message](const MessagePtr& message) {
      kept[who] = message;
      const ConstBlock& block = message->blocks().front();
      for (std::size_t at = 0; at < block.size; at += 4096) sum[who] += block.data[at];
      if (message->tag() == rehearsal) return sleep_us(2000);
      if (message->tag() >= warm_up && message->tag() % (4 * burst) == 0) sleep_us(2000);
      on_message(who, message->tag());
    };
    subscriber[who] = *Subscriber::create(options);
  }

  RecordPtr make(std::uint32_t tag) const {
    const char control[64] = {};
    BufferPtr block = publisher->memory()->allocate(block_bytes);
    block->data()[0] = static_cast<std::uint8_t>(tag);
    return make_record(tag, control, sizeof control, {std::move(block)});
  }

  void publish(std::uint32_t index) const { publisher->publish(make(index)); }

  // What docs/core.md asks of start-up: as many messages at once as may be in flight when a reader is late.
  void rehearse() const {
    std::vector<RecordPtr> records;
    for (std::uint64_t i = 0; i < burst; ++i) records.push_back(make(rehearsal));
    for (const RecordPtr& record : records) publisher->publish(record);
  }

  std::shared_ptr<Publisher> publisher;
  std::shared_ptr<Subscriber> subscriber[readers];
  MessagePtr kept[readers];
  std::uint64_t sum[readers] = {};
};

bool all_received(const Report& report, std::uint64_t count) {
  for (const auto& received : report.received)
    if (received < count) return false;
  return true;
}

bool all_complete(const Report& report) {
  bool complete = report.publisher.complete;
  for (const Spent& reader : report.reader) complete &= reader.complete;
  return complete;
}

/// Waits for every reader: a message that the queue drops would go another way than the one that is measured.
void measure(Report& report, const Guard& guard) {
  Channel channel([&](std::size_t who, std::uint64_t index) {
    if (index == warm_up) begin(report.reader[who], Role::reader, guard);
    ++report.received[who];
    if (index == warm_up + measured - 1) end(report.reader[who]);
  });
  (void)::mlockall(MCL_CURRENT);  // not permitted to everyone, and nothing is swapped out in a second anyway
  std::thread publisher([&] {
    channel.rehearse();
    for (std::uint32_t index = 0; index < warm_up + measured; ++index) {
      if (index == warm_up) begin(report.publisher, Role::publisher, guard);
      channel.publish(index);
      if ((index + 1) % burst != 0) continue;
      while (!all_received(report, index + 1)) sleep_us(50);
    }
    end(report.publisher);
    for (;;) sleep_us(900'000);  // a guarded thread cannot end: the process does
  });
  while (!all_complete(report)) ::usleep(1000);
  ::_exit(0);
}

/// What a child of its own has measured; it has ended well when *succeeded.
Report* measured_in_child(const Guard& guard, bool* succeeded) {
  void* shared = ::mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto* report = new (shared) Report();
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(30);
    measure(*report, guard);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  *succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return report;
}

void for_each_thread(Report& report, const std::function<void(const char*, Spent&)>& look) {
  look("publisher", report.publisher);
  for (Spent& reader : report.reader) look("reader", reader);
}

void count_page_faults(Role) {
  spent_here->page_faults_before = page_faults_here();
}

/// How many pages the kernel has moved or taken back since the system started. A page that it moves is faulted in again by
/// whoever uses it next, locked or not (memory compaction, which other programs' need of huge pages sets off).
std::uint64_t pages_that_the_kernel_moved() {
  const std::set<std::string> moving{"pgmigrate_success", "pgmigrate_fail", "pgsteal_kswapd",
                                     "pgsteal_direct",    "thp_split_pmd",  "thp_collapse_alloc",
                                     "numa_pte_updates"};
  std::ifstream statistics("/proc/vmstat");
  std::string name;
  std::uint64_t count = 0, sum = 0;
  while (statistics >> name >> count) sum += moving.count(name) == 0 ? 0 : count;
  return sum;
}

bool faulted(Report& report) {
  bool any = false;
  for_each_thread(report, [&](const char*, Spent& spent) { any |= spent.page_faults != 0; });
  return any;
}

/// Measures again where a page was faulted in while the kernel moved pages: whose fault it was cannot be told.
Report* measured_while_no_page_moved(bool* succeeded) {
  constexpr int attempts = 50;
  for (int attempt = 1;; ++attempt) {
    const std::uint64_t before = pages_that_the_kernel_moved();
    Report* report = measured_in_child(count_page_faults, succeeded);
    const bool certain = !*succeeded || !faulted(*report) || pages_that_the_kernel_moved() == before;
    if (certain || attempt == attempts) return report;
  }
}

TEST(RealTime, a_message_allocates_nothing_and_faults_no_page_in) {
  bool succeeded = false;
  Report* report = measured_while_no_page_moved(&succeeded);
  ASSERT_TRUE(succeeded);
  for_each_thread(*report, [](const char* who, Spent& spent) {
    EXPECT_TRUE(spent.complete) << who;
    EXPECT_EQ(spent.allocations, 0U) << who;
    EXPECT_EQ(spent.page_faults, 0U) << who;
  });
}

// Which ranges are free, and how many, depends on the order in which readers let go.
TEST(RealTime, after_the_most_ranges_at_once_their_order_allocates_nothing) {
  constexpr std::size_t most = 40, bytes = 64;
  segment::Extents extents(0, most * bytes);
  std::vector<std::uint64_t> in_use(most);
  for (std::uint64_t& offset : in_use) offset = extents.allocate(bytes);
  std::mt19937 random(7);
  allocations = 0;
  counting = true;
  for (int i = 0; i < 20'000; ++i) {
    std::uint64_t& offset = in_use[random() % most];
    if (offset == segment::Extents::none)
      offset = extents.allocate(bytes);
    else
      extents.release(std::exchange(offset, segment::Extents::none), bytes);
  }
  counting = false;
  EXPECT_EQ(allocations, 0U);
}

// A call that the filter below does not let through ends the child: the first one is enough to know.
void on_forbidden_call(int, siginfo_t* info, void*) {
  spent_here->forbidden_call = info->si_syscall;
  ::_exit(1);
}

/// From now on this thread may sleep, and do this one operation on a futex. A mutex that nobody holds needs no call; one
/// that somebody holds, and any lock that processes share, needs a wait.
void allow_sleep_and_futex(std::uint32_t operation) {
  constexpr auto number = static_cast<std::uint32_t>(offsetof(seccomp_data, nr));
  constexpr auto second = static_cast<std::uint32_t>(offsetof(seccomp_data, args) + sizeof(std::uint64_t));
  sock_filter filter[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, number),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clock_nanosleep, 5, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 4, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_futex, 0, 2),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, second),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, operation, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{static_cast<unsigned short>(sizeof filter / sizeof filter[0]), filter};
  const bool limited = ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                       ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
  if (!limited) ::_exit(1);
}

bool has_filters() {
  return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr) == -1 && errno == EFAULT;
}

void count_calls(Role role) {
  struct sigaction forbidden{};
  forbidden.sa_sigaction = on_forbidden_call;
  forbidden.sa_flags = SA_SIGINFO;
  ::sigaction(SIGSYS, &forbidden, nullptr);
  allow_sleep_and_futex(role == Role::publisher ? FUTEX_WAKE : FUTEX_WAIT);
}

TEST(RealTime, a_publisher_only_wakes_and_a_reader_only_waits) {
  if (!posix::has_shared_futex()) GTEST_SKIP() << "this build wakes readers through sockets";
  if (!has_filters()) GTEST_SKIP() << "this system has no seccomp filters, by which calls are noticed";
  bool succeeded = false;
  Report* report = measured_in_child(count_calls, &succeeded);
  for_each_thread(*report, [](const char* who, Spent& spent) {
    EXPECT_EQ(spent.forbidden_call, Spent::none) << who << " made the system call of this number";
  });
  EXPECT_TRUE(succeeded);
}

}  // namespace
}  // namespace channel
}  // namespace tzc
