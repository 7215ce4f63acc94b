// SPDX-License-Identifier: BSD-3-Clause
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

#include "channel/wire/wire.h"
#include "contenders.h"

namespace tzc {
namespace bench {
namespace {

constexpr std::size_t record_bytes =
    sizeof(channel::RecordPrefix) + sizeof(channel::BodyHeader) + sizeof(segment::BlockRef) + control_bytes;

class SeqpacketContender final : public Contender {
 public:
  const char* name() const override { return "seqpacket"; }

  void prepare(const Setup& setup) override {
    for (const auto& pair : pairs_) ::close(pair.writer), ::close(pair.reader);
    pairs_.clear();
    while (pairs_.size() < setup.subscribers) {
      int ends[2];
      if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        throw std::system_error(errno, std::generic_category(), "cannot make a pair of sockets");
      pairs_.push_back({ends[0], ends[1]});
    }
  }

  void subscribe(const Setup&, std::size_t who, Recorder& recorder) override {
    char record[record_bytes];
    recorder.ready();
    while (::recv(pairs_[who].reader, record, sizeof record, 0) == sizeof record) {
      Stamp stamp{};
      std::memcpy(&stamp, record, sizeof stamp);
      recorder.record(stamp);
    }
  }

  std::function<void(std::uint64_t)> publish(const Setup&) override {
    return [this](std::uint64_t index) {
      char record[record_bytes] = {};
      const Stamp stamp{now_ns(), index};
      std::memcpy(record, &stamp, sizeof stamp);
      for (const Pair& pair : pairs_)
        (void)!::send(pair.writer, record, sizeof record, MSG_DONTWAIT | MSG_NOSIGNAL);
    };
  }

 private:
  struct Pair {
    int writer, reader;
  };
  std::vector<Pair> pairs_;
};

}  // namespace

std::unique_ptr<Contender> seqpacket_contender() {
  return std::make_unique<SeqpacketContender>();
}

}  // namespace bench
}  // namespace tzc
