// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscriber_link.h>
#include <ros/transport_subscriber_link.h>
#include <tzc/channel.h>

#include <boost/signals2/connection.hpp>
#include <chrono>
#include <memory>
#include <mutex>

#include "roscpp/publish/publication_stream.h"
#include "roscpp/publish/waiting_records.h"

namespace tzc {
namespace detail {

class SharedLink;

/// Who is told, on the thread that drops it, that the TCPROS connection of a link has ended.
class LinkEndListener {
 public:
  virtual ~LinkEndListener() = default;
  virtual void ended(const boost::shared_ptr<SharedLink>& link) = 0;
};

/// The link of a subscriber on shared memory. It takes the place of the TCPROS link in
/// Publication::subscriber_links_ and keeps that link parked. To roscpp it is an intraprocess link, because
/// only those get messages by pointer.
///
///   draining   what was queued for TCPROS goes there, what is newer waits here
///      v
///   live       straight into the channel
///      v       the channel breaks
///   broken     what is published waits here
///      v       the subscriber has delivered all that it took
///   returned   what it did not take goes over TCPROS, then what waited here, then what comes; LinkMigration puts
///              the TCPROS link back
///
/// From each of them the link may end with its TCPROS link.
class SharedLink : public ros::SubscriberLink {
 public:
  /// What a call of try_go_live or hand_back has done.
  enum class Progress { none, some, finished };

  /// @param queued messages in Publication::publish_queue_ that belong to the TCPROS link; the caller holds
  ///        the publication's locks
  SharedLink(std::shared_ptr<PublicationStream> stream, const ros::PublicationPtr& publication,
             ros::TransportSubscriberLinkPtr parked, channel::ConnectionPtr connection, std::size_t queued);
  ~SharedLink() override;

  /// \name ros::SubscriberLink
  /// @{
  /// roscpp's three ways: (ser, nocopy) = (0,1) publish by pointer; (1,0) the poll thread, with bytes; (1,1)
  /// bytes for this subscriber alone (SingleSubscriberPublisher). Waits for no other process.
  void enqueueMessage(const ros::SerializedMessage& message, bool ser, bool nocopy) override;
  void drop() override;
  std::string getTransportType() override { return "TZC"; }
  std::string getTransportInfo() override;
  bool isIntraprocess() override { return true; }
  void getPublishTypes(bool& ser, bool& nocopy, const std::type_info& type) override;
  /// @}

  /// Sends the message, or keeps it while draining. Under advertised_topics_mutex_, as everybody who publishes; never blocks.
  void deliver(const OutgoingMessage& message);

  /// Takes a message that roscpp has serialized and numbered. Under subscriber_links_mutex_; never blocks. False: it belongs to the
  /// TCPROS link, which the caller gives it by pass_to_tcpros(), before the next message.
  bool take_bytes(const ros::SerializedMessage& message);
  /// Takes a mutex of the TCPROS connection, which roscpp's poll thread may hold while it waits for subscriber_links_mutex_: a thread
  /// that is not that one must not hold it.
  void pass_to_tcpros(const ros::SerializedMessage& message);

  /// Goes live when TCPROS has sent everything that it was given; what waits is sent as fast as the
  /// subscriber takes it, but no longer than a second: then all of it at once, and the channel drops what its limit does not
  /// allow. Unless `finished`: call again.
  Progress try_go_live();

  /// Call it when the channel has broken and the subscriber has delivered all that it took: serializes the
  /// rest for TCPROS, as fast as TCPROS sends, but no longer than a second: then the newest `queue_size` of it, for which
  /// TCPROS drops what it could not send. One thread at a time, which holds no lock of roscpp's:
  /// serializing takes long. Unless `finished`: call again.
  Progress hand_back();
  /// Call it when hand_back() has finished: from now on everything goes over TCPROS. The caller holds the publication's
  /// locks. False: messages were published since; call hand_back() again.
  /// @param queued messages in Publication::publish_queue_
  bool try_return(std::size_t queued);
  /// True when the link has returned and none of the messages that it got by pointer waits in roscpp's queue:
  /// the TCPROS link can take its place.
  bool may_be_replaced() const;
  bool has_returned() const;

  /// Tells the listener once, when the TCPROS link is dropped (the subscriber or the publisher ended the
  /// connection).
  void tell_of_end(std::weak_ptr<LinkEndListener> listener);

  PublicationStream& stream() const { return *stream_; }
  const ros::TransportSubscriberLinkPtr& parked() const { return parked_; }
  const channel::ConnectionPtr& connection() const { return connection_; }

 private:
  void publish_by_pointer(const ros::SerializedMessage& message);
  void publish_alone(const ros::SerializedMessage& message);
  using Clock = std::chrono::steady_clock;
  enum class State { draining, live, broken, returned };

  /// \name Under mutex_
  /// @{
  /// False: the channel does not take it, nor any later message.
  bool send(const channel::RecordPtr& record);
  /// True: it has sent some.
  bool send_what_waits();
  void break_off();
  void collect_undelivered();
  void begin_patience();
  bool is_patient() const;
  bool belongs_to_tcpros(bool went_by_pointer);
  /// @}
  channel::RecordPtr next_to_hand_back();
  bool drop_waiting(const channel::RecordPtr& record);

  const std::shared_ptr<PublicationStream> stream_;  ///< keeps the publication's endpoint, too
  const ros::TransportSubscriberLinkPtr parked_;
  const channel::ConnectionPtr connection_;
  std::weak_ptr<LinkEndListener> end_listener_;  ///< before drop_listener_ is connected
  boost::signals2::connection drop_listener_;

  /// Guards what follows; innermost, but for the channel's.
  mutable std::mutex mutex_;
  State state_ = State::draining;
  bool switched_ = false;             ///< the subscriber was told that shared records follow
  std::size_t queued_for_tcpros_;     ///< draining: messages of roscpp's queue that belong to TCPROS
  std::size_t queued_at_return_ = 0;  ///< returned: messages of roscpp's queue that may have gone by pointer
  WaitingRecords waiting_;
  Clock::time_point patient_until_{};  ///< what waits is passed on as it is taken until then; not begun: zero
};
typedef boost::shared_ptr<SharedLink> SharedLinkPtr;

}  // namespace detail
}  // namespace tzc
