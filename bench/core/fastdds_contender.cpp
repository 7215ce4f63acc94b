// SPDX-License-Identifier: BSD-3-Clause
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/config.h>
#include <unistd.h>
#include <fastdds/dds/core/LoanableSequence.hpp>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contenders.h"
#include "fastdds_type.h"
#include "span.h"

namespace tzc {
namespace bench {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;
using eprosima::fastrtps::types::ReturnCode_t;

/// How samples get from process to process.
enum class Way {
  udp,     // datagrams on the loopback interface
  memory,  // the shared memory transport: copied in and out
  loans,   // data sharing: the writer lends a sample of its own, the reader sees it
};

std::shared_ptr<rtps::TransportDescriptorInterface> loopback() {
  const auto udp = std::make_shared<rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {"127.0.0.1"};
  udp->maxInitialPeersRange = 2 * most_subscribers;
  return udp;
}

// With room for as many messages as the queue holds, each of them in one piece.
std::shared_ptr<rtps::TransportDescriptorInterface> shared_memory(const Setup& setup) {
  constexpr std::uint32_t headers = 64 << 10;
  const auto message = static_cast<std::uint32_t>(setup.size_bytes) + headers;
  const auto memory = std::make_shared<rtps::SharedMemTransportDescriptor>();
  memory->segment_size(message * static_cast<std::uint32_t>(setup.queue_size + 2));
  memory->max_message_size(message);
  return memory;
}

dds::DomainParticipantQos participant_qos(const Setup& setup, Way way) {
  dds::DomainParticipantQos qos;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(way == Way::memory ? shared_memory(setup) : loopback());
  if (way == Way::memory) return qos;
  rtps::Locator peer;  // the other processes of this machine, found without multicast
  eprosima::fastrtps::rtps::IPLocator::setIPv4(peer, 127, 0, 0, 1);
  qos.wire_protocol().builtin.initialPeersList.push_back(peer);
  return qos;
}

template <class Qos>
Qos endpoint_qos(Qos qos, const Setup& setup, Way way) {
  const auto depth = static_cast<std::int32_t>(setup.queue_size);
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = depth;
  qos.resource_limits().max_samples = depth;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = depth;
  qos.resource_limits().allocated_samples = depth;
  way == Way::loans ? qos.data_sharing().automatic() : qos.data_sharing().off();
  return qos;
}

/// A participant of the measurement, with its topic. Its files are gone when it ends.
class Node {
 public:
  Node(const Setup& setup, Way way) : setup_(setup), way_(way), type_(new FastDdsType(setup.size_bytes)) {
    dds::Log::SetVerbosity(dds::Log::Kind::Error);
    auto* factory = dds::DomainParticipantFactory::get_instance();
    // A domain of its own, as far as there are some: participants of other measurements are not discovered.
    const auto domain = static_cast<std::uint32_t>(1 + std::hash<std::string>()(setup.name) % 200);
    participant_ = factory->create_participant(domain, participant_qos(setup, way));
    type_.register_type(participant_);
    topic_ = participant_->create_topic(setup.name, type_.get_type_name(), dds::TOPIC_QOS_DEFAULT);
  }
  ~Node() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  dds::DataWriter* create_writer() {
    auto* publisher = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    return publisher->create_datawriter(topic_, endpoint_qos(dds::DataWriterQos(), setup_, way_));
  }
  dds::DataReader* create_reader(dds::DataReaderListener* listener) {
    auto* subscriber = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
    return subscriber->create_datareader(topic_, endpoint_qos(dds::DataReaderQos(), setup_, way_), listener);
  }

 private:
  const Setup setup_;
  const Way way_;
  dds::TypeSupport type_;
  dds::DomainParticipant* participant_;
  dds::Topic* topic_;
};

class Listener final : public dds::DataReaderListener {
 public:
  explicit Listener(Recorder& recorder) : recorder_(recorder) {}

  void on_data_available(dds::DataReader* reader) override {
    dds::LoanableSequence<Stamp> samples;  // the reader lends its own
    dds::SampleInfoSeq infos;
    while (reader->take(samples, infos) == ReturnCode_t::RETCODE_OK) {
      for (dds::LoanableCollection::size_type i = 0; i < samples.length(); ++i) {
        Stamp stamp{};
        std::memcpy(&stamp, samples.buffer()[i], sizeof stamp);
        if (infos[i].valid_data) recorder_.record(stamp);
      }
      reader->return_loan(samples, infos);
    }
  }

 private:
  Recorder& recorder_;
};

bool wait_for_readers(dds::DataWriter& writer, const Setup& setup) {
  return wait_until(setup, [&] {
    dds::PublicationMatchedStatus matched;
    return writer.get_publication_matched_status(matched) != ReturnCode_t::RETCODE_OK ||
           matched.current_count >= static_cast<std::int32_t>(setup.subscribers);
  });
}

void write(dds::DataWriter& writer, void* sample, std::size_t bytes, const Span& span) {
  span.fill(sample, bytes);
  const Stamp stamp = span.stamp();
  std::memcpy(sample, &stamp, sizeof stamp);
  writer.write(sample);
}

class FastDdsContender final : public Contender {
 public:
  FastDdsContender(const char* name, Way way) : name_(name), way_(way) {}

  const char* name() const override { return name_; }
  bool cleans_up_at_exit() const override { return true; }

  void subscribe(const Setup& setup, std::size_t, Recorder& recorder) override {
    Listener listener(recorder);
    Node node(setup, way_);
    if (node.create_reader(&listener) != nullptr) recorder.ready();
    while (!recorder.stop()) ::usleep(100'000);
  }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    const auto node = std::make_shared<Node>(setup, way_);
    dds::DataWriter* writer = node->create_writer();
    if (!wait_for_readers(*writer, setup)) return {};
    const std::size_t bytes = std::max(setup.size_bytes, sizeof(Stamp));
    if (way_ == Way::loans) {
      return [node, writer, bytes, setup](std::uint64_t index) {
        const Span span(setup, index);
        void* sample = nullptr;
        if (writer->loan_sample(sample) == ReturnCode_t::RETCODE_OK) write(*writer, sample, bytes, span);
      };
    }
    const auto message = std::make_shared<std::vector<char>>(bytes);
    return [node, writer, message, setup](std::uint64_t index) {
      write(*writer, message->data(), message->size(), Span(setup, index));
    };
  }

 private:
  const char* const name_;
  const Way way_;
};

}  // namespace

std::unique_ptr<Contender> fastdds_contender() {
  return std::make_unique<FastDdsContender>("fastdds", Way::udp);
}
std::unique_ptr<Contender> fastdds_shm_contender() {
  return std::make_unique<FastDdsContender>("fastdds-shm", Way::memory);
}
std::unique_ptr<Contender> fastdds_loan_contender() {
  return std::make_unique<FastDdsContender>("fastdds-loan", Way::loans);
}

std::string fastdds_version() {
  return FASTRTPS_VERSION_STR;
}

}  // namespace bench
}  // namespace tzc
