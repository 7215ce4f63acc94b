// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <lcm/lcm.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "contenders.h"
#include "processes.h"
#include "span.h"

namespace tzc {
namespace bench {
namespace {

// A time to live of 0: no datagram leaves the machine. The receive buffer is as large as the kernel allows, up to what
// some large messages need.
std::string provider() {
  std::size_t allowed = 0;
  std::ifstream("/proc/sys/net/core/rmem_max") >> allowed;
  constexpr std::size_t enough = 64 << 20;
  return "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=" + std::to_string(std::min(allowed, enough));
}

struct Destroy {
  void operator()(lcm_t* lcm) const { ::lcm_destroy(lcm); }
};
using Lcm = std::unique_ptr<lcm_t, Destroy>;

void be_silent() {
  const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int fd : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, fd);
}

void on_message(const lcm_recv_buf_t* message, const char*, void* recorder) {
  Stamp stamp{};
  if (message->data_size < sizeof stamp) return;
  std::memcpy(&stamp, message->data, sizeof stamp);
  static_cast<Recorder*>(recorder)->record(stamp);
}

class LcmContender final : public Contender {
 public:
  const char* name() const override { return "lcm"; }

  // A child tries: LCM starts threads, which a process that forks should not have.
  std::string obstacle() const override {
    const pid_t child = in_child([] {
      be_silent();
      if (!Lcm(::lcm_create(provider().c_str()))) ::_exit(1);
    });
    if (wait_for(child) == Ending::exited) return "";
    return "UDP multicast does not work on this machine: give it a route, as "
           "`ip link set lo multicast on; ip route add 224.0.0.0/4 dev lo` does";
  }

  void subscribe(const Setup& setup, std::size_t, Recorder& recorder) override {
    const Lcm lcm(::lcm_create(provider().c_str()));
    if (!lcm) return;
    ::lcm_subscribe(lcm.get(), setup.name.c_str(), on_message, &recorder);
    recorder.ready();
    while (!recorder.stop() && ::lcm_handle(lcm.get()) == 0) {
    }
  }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    const std::shared_ptr<lcm_t> lcm(::lcm_create(provider().c_str()), Destroy());
    const auto frame = std::make_shared<std::vector<char>>(std::max(setup.size_bytes, sizeof(Stamp)));
    return [lcm, frame, setup](std::uint64_t index) {
      const Span span(setup, index);
      span.fill(frame->data(), frame->size());
      const Stamp stamp = span.stamp();
      std::memcpy(frame->data(), &stamp, sizeof stamp);
      ::lcm_publish(lcm.get(), setup.name.c_str(), frame->data(), static_cast<unsigned>(frame->size()));
    };
  }
};

}  // namespace

std::unique_ptr<Contender> lcm_contender() {
  return std::make_unique<LcmContender>();
}

std::string lcm_version() {
  return TZC_BENCH_LCM_VERSION;
}

}  // namespace bench
}  // namespace tzc
