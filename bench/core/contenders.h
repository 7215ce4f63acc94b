// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "measure.h"

namespace tzc {
namespace bench {

/// Bytes of the application's control part in every contender that has one.
constexpr std::size_t control_bytes = 64;

/// Only a seqpacket socket that carries a record of the size of tzc's: the floor.
std::unique_ptr<Contender> seqpacket_contender();
/// Only a futex in shared memory: the floor of iceoryx.
std::unique_ptr<Contender> futex_contender();
/// Callback on tzc's reader thread.
std::unique_ptr<Contender> tzc_reader_contender();
/// poll() and read() in the application's own loop.
std::unique_ptr<Contender> tzc_own_loop_contender();
/// A ring in POSIX shared memory behind a mutex and a condition, as Ach's: bytes are copied in and out.
std::unique_ptr<Contender> ach_contender();
/// iceoryx's largest message, by the memory pools of RouDi below.
constexpr std::size_t most_bytes_of_iceoryx = 4 << 20;
std::unique_ptr<Contender> iceoryx_listener_contender();
std::unique_ptr<Contender> iceoryx_waitset_contender();
std::string iceoryx_version();
/// LCM: UDP multicast that does not leave the machine.
std::unique_ptr<Contender> lcm_contender();
std::string lcm_version();
/// Cyclone DDS on the loopback interface; with shm by iceoryx, the publisher's samples borrowed from it.
std::unique_ptr<Contender> cyclone_contender();
std::unique_ptr<Contender> cyclone_shm_contender();
std::string cyclone_version();
/// Fast DDS on the loopback interface, by its shared memory transport, and by loans of its data sharing.
std::unique_ptr<Contender> fastdds_contender();
std::unique_ptr<Contender> fastdds_shm_contender();
std::unique_ptr<Contender> fastdds_loan_contender();
std::string fastdds_version();

/// Runs iceoryx's daemon as long as it exists.
class RouDi {
 public:
  RouDi();
  ~RouDi();
  bool running() const { return pid_ > 0; }

 private:
  int pid_ = -1;
};

}  // namespace bench
}  // namespace tzc
