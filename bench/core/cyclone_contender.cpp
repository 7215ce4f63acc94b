// SPDX-License-Identifier: BSD-3-Clause
#include <dds/dds.h>
#include <dds/ddsc/dds_loan_api.h>
#include <dds/version.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contenders.h"
#include "span.h"

namespace tzc {
namespace bench {
namespace {

// The loopback interface alone, found without multicast, in datagrams as large as they can be.
constexpr char configuration[] =
    "<Domain id='any'><General><Interfaces><NetworkInterface address='127.0.0.1'/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast><MaxMessageSize>65500B</MaxMessageSize>"
    "<FragmentSize>65000B</FragmentSize></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>60</"
    "MaxAutoParticipantIndex>"
    "<Peers><Peer address='127.0.0.1'/></Peers></Discovery>";

/// A struct of a stamp and an array of bytes, as idlc would describe it; the array's length is known only now.
class MessageType {
 public:
  explicit MessageType(std::size_t size_bytes)
      : size_((std::max(size_bytes, sizeof(Stamp) + 8) + 7) / 8 * 8),
        operations_{DDS_OP_ADR | DDS_OP_TYPE_8BY,
                    offsetof(Stamp, nanoseconds),
                    DDS_OP_ADR | DDS_OP_TYPE_8BY,
                    offsetof(Stamp, index),
                    DDS_OP_ADR | DDS_OP_TYPE_ARR | DDS_OP_SUBTYPE_1BY,
                    sizeof(Stamp),
                    size_ - static_cast<std::uint32_t>(sizeof(Stamp)),
                    DDS_OP_RTS} {}

  std::uint32_t size() const { return size_; }
  dds_entity_t create_topic(dds_entity_t participant, std::string name) const {
    std::replace(name.begin(), name.end(), '-', '_');  // not allowed in a topic's name
    const dds_topic_descriptor_t descriptor{
        size_, 8, DDS_TOPIC_FIXED_SIZE, 0, "tzc_bench::Message", nullptr, 4, operations_, "", {}, {}, 0};
    return ::dds_create_topic(participant, &descriptor, name.c_str(), nullptr, nullptr);
  }

 private:
  const std::uint32_t size_;
  const std::uint32_t operations_[8];
};

/// A participant of the measurement, with its topic. Leaves the domain when it ends.
class Node {
 public:
  Node(const Setup& setup, bool shared_memory) : type_(setup.size_bytes) {
    // A domain of its own, as far as there are some: participants of other measurements are not discovered.
    const auto id = static_cast<dds_domainid_t>(1 + std::hash<std::string>()(setup.name) % 200);
    const std::string enabled = shared_memory ? "true" : "false";
    const std::string memory = "<SharedMemory><Enable>" + enabled + "</Enable></SharedMemory></Domain>";
    domain_ = ::dds_create_domain(id, (configuration + memory).c_str());
    participant_ = ::dds_create_participant(id, nullptr, nullptr);
    topic_ = type_.create_topic(participant_, setup.name);
    qos_ = ::dds_create_qos();
    ::dds_qset_history(qos_, DDS_HISTORY_KEEP_LAST, static_cast<std::int32_t>(setup.queue_size));
    ::dds_qset_reliability(qos_, DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
  }
  ~Node() {
    ::dds_delete_qos(qos_);
    ::dds_delete(domain_);
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  std::uint32_t message_bytes() const { return type_.size(); }
  dds_entity_t create_writer() const { return ::dds_create_writer(participant_, topic_, qos_, nullptr); }
  dds_entity_t create_reader(const dds_listener_t* listener) const {
    return ::dds_create_reader(participant_, topic_, qos_, listener);
  }

 private:
  const MessageType type_;
  dds_entity_t domain_, participant_, topic_;
  dds_qos_t* qos_;
};

void on_data(dds_entity_t reader, void* recorder) {
  for (;;) {
    void* sample = nullptr;  // the reader lends its own
    dds_sample_info_t info;
    const dds_return_t count = ::dds_take(reader, &sample, &info, 1, 1);
    if (count <= 0) return;
    Stamp stamp{};
    std::memcpy(&stamp, sample, sizeof stamp);
    if (info.valid_data) static_cast<Recorder*>(recorder)->record(stamp);
    ::dds_return_loan(reader, &sample, count);
  }
}

bool wait_for_readers(dds_entity_t writer, const Setup& setup) {
  return wait_until(setup, [&] {
    dds_publication_matched_status_t matched{};
    return ::dds_get_publication_matched_status(writer, &matched) != DDS_RETCODE_OK ||
           matched.current_count >= setup.subscribers;
  });
}

class CycloneContender final : public Contender {
 public:
  explicit CycloneContender(bool shared_memory) : shared_memory_(shared_memory) {}

  const char* name() const override { return shared_memory_ ? "cyclone-shm" : "cyclone"; }
  bool cleans_up_at_exit() const override { return shared_memory_; }
  Daemon needs() const override { return shared_memory_ ? Daemon::roudi : Daemon::none; }
  bool supports(const Setup& setup) const override {
    return !shared_memory_ || setup.size_bytes <= most_bytes_of_iceoryx;
  }

  void subscribe(const Setup& setup, std::size_t, Recorder& recorder) override {
    const Node node(setup, shared_memory_);
    dds_listener_t* listener = ::dds_create_listener(&recorder);
    ::dds_lset_data_available(listener, on_data);
    if (node.create_reader(listener) > 0) recorder.ready();
    while (!recorder.stop()) ::usleep(100'000);
    ::dds_delete_listener(listener);
  }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    const auto node = std::make_shared<Node>(setup, shared_memory_);
    const dds_entity_t writer = node->create_writer();
    if (!wait_for_readers(writer, setup)) return {};
    if (shared_memory_ && ::dds_is_shared_memory_available(writer)) {
      return [node, writer, setup](std::uint64_t index) {
        const Span span(setup, index);
        void* sample = nullptr;
        if (::dds_loan_sample(writer, &sample) == DDS_RETCODE_OK) write(*node, writer, sample, span);
      };
    }
    const auto message = std::make_shared<std::vector<std::uint64_t>>(node->message_bytes() / 8);
    return [node, writer, message, setup](std::uint64_t index) {
      write(*node, writer, message->data(), Span(setup, index));
    };
  }

 private:
  static void write(const Node& node, dds_entity_t writer, void* sample, const Span& span) {
    span.fill(sample, node.message_bytes());
    const Stamp stamp = span.stamp();
    std::memcpy(sample, &stamp, sizeof stamp);
    ::dds_write(writer, sample);
  }

  const bool shared_memory_;
};

}  // namespace

std::unique_ptr<Contender> cyclone_contender() {
  return std::make_unique<CycloneContender>(false);
}
std::unique_ptr<Contender> cyclone_shm_contender() {
  return std::make_unique<CycloneContender>(true);
}

std::string cyclone_version() {
  return DDS_VERSION;
}

}  // namespace bench
}  // namespace tzc
