// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The private members of roscpp 1.15.9 to 1.17 that the transport needs, all of them here. Access goes through explicit
/// template instantiation, where the standard ([temp.spec]/6) does not check access. Everything is read only, except
/// that Publication::subscriber_links_ gets one pointer replaced in place (adding and removing links would fire the
/// user's connect callbacks), Publication::publish_queue_ is emptied when its messages are sent (queued_messages.cpp), the connect callback of an advertisement and the queue on which it runs (connect_hook.cpp), the
/// callback queue that a callback of a Subscription names (fault_ready_queue.h), the Subscriber of a direct callback, whose implementation is wrapped (waiting_end.cpp), and the object that a Subscription keeps of
/// a latched message (subscription_endpoint.cpp). A roscpp where a member is missing
/// fails to compile right here; with a version that was not looked at (roscpp_version.h) nothing here is used.

#include <ros/connection.h>
#include <ros/connection_manager.h>  // has no include guard: nobody else may include it
#include <ros/intraprocess_publisher_link.h>
#include <ros/intraprocess_subscriber_link.h>
#include <ros/publication.h>
#include <ros/publisher_link.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/subscriber.h>
#include <ros/subscription.h>
#include <ros/subscription_queue.h>
#include <ros/topic_manager.h>
#include <ros/transport/transport_tcp.h>
#include <ros/transport_subscriber_link.h>

#include <list>
#include <queue>
#include <set>
#include <vector>

namespace tzc {
namespace roscpp_access {

template <class Tag, typename Tag::type Member>
struct Grant {
  friend typename Tag::type member(Tag) { return Member; }
};

#define TZC_GRANT(Name, Class, Type, Field)          \
  struct Name {                                      \
    typedef Type Class::* type;                      \
    friend type member(Name);                        \
  };                                                 \
  template struct Grant<Name, &Class::Field>;        \
  inline Type& Field(Class& object, Name = Name()) { \
    return object.*member(Name());                   \
  }

template <class Tag, auto Member>
struct GrantUnnamed {
  friend auto member(Tag) { return Member; }
};

/// For a member whose type has a private name.
#define TZC_GRANT_UNNAMED(Name, Class, Field)        \
  struct Name {                                      \
    friend auto member(Name);                        \
  };                                                 \
  template struct GrantUnnamed<Name, &Class::Field>; \
  inline auto& Field(Class& object) {                \
    return object.*member(Name());                   \
  }

typedef std::list<ros::SubscriptionPtr> SubscriptionList;
typedef std::vector<ros::PublisherLinkPtr> PublisherLinks;
typedef std::vector<ros::SerializedMessage> SerializedMessages;
typedef std::queue<ros::SerializedMessage> SerializedQueue;
typedef std::set<ros::ConnectionPtr> ConnectionSet;

TZC_GRANT(Subscriptions, ros::TopicManager, SubscriptionList, subscriptions_)
TZC_GRANT(SubsMutex, ros::TopicManager, boost::mutex, subs_mutex_)
TZC_GRANT(AdvertisedTopicsMutex, ros::TopicManager, boost::recursive_mutex, advertised_topics_mutex_)

TZC_GRANT(PublisherLinksOf, ros::Subscription, PublisherLinks, publisher_links_)
TZC_GRANT(PublisherLinksMutex, ros::Subscription, boost::mutex, publisher_links_mutex_)
TZC_GRANT(NonconstCallbacks, ros::Subscription, std::uint32_t, nonconst_callbacks_)
TZC_GRANT(CallbacksMutex, ros::Subscription, boost::mutex, callbacks_mutex_)

TZC_GRANT_UNNAMED(Callbacks, ros::Subscription, callbacks_)
TZC_GRANT_UNNAMED(LatchedMessages, ros::Subscription, latched_messages_)
TZC_GRANT(Statistics, ros::Subscription, ros::StatisticsLogger, statistics_)
TZC_GRANT(EnableStatistics, ros::StatisticsLogger, bool, enable_statistics)

TZC_GRANT_UNNAMED(SubscriberImpl, ros::Subscriber, impl_)

TZC_GRANT(CallbackMutex, ros::SubscriptionQueue, boost::recursive_mutex, callback_mutex_)
TZC_GRANT(QueueMutex, ros::SubscriptionQueue, boost::mutex, queue_mutex_)
TZC_GRANT(QueueSize, ros::SubscriptionQueue, std::uint32_t, queue_size_)
TZC_GRANT(AllowConcurrentCallbacks, ros::SubscriptionQueue, bool, allow_concurrent_callbacks_)

TZC_GRANT(SubscriberLinks, ros::Publication, ros::V_SubscriberLink, subscriber_links_)
TZC_GRANT(SubscriberLinksMutex, ros::Publication, boost::mutex, subscriber_links_mutex_)
TZC_GRANT(HasHeader, ros::Publication, bool, has_header_)
TZC_GRANT(PublicationCallbacks, ros::Publication, std::vector<ros::SubscriberCallbacksPtr>, callbacks_)
TZC_GRANT(PublicationCallbacksMutex, ros::Publication, boost::mutex, callbacks_mutex_)
TZC_GRANT(PublishQueue, ros::Publication, SerializedMessages, publish_queue_)
TZC_GRANT(PublishQueueMutex, ros::Publication, boost::mutex, publish_queue_mutex_)

TZC_GRANT(SingleLink, ros::SingleSubscriberPublisher, ros::SubscriberLinkPtr, link_)

TZC_GRANT(LocalPublisherLink, ros::IntraProcessSubscriberLink, ros::IntraProcessPublisherLinkPtr, subscriber_)
TZC_GRANT(LocalLinkDropped, ros::IntraProcessSubscriberLink, bool, dropped_)
TZC_GRANT(LocalLinkMutex, ros::IntraProcessSubscriberLink, boost::recursive_mutex, drop_mutex_)
TZC_GRANT(SubscriptionOf, ros::PublisherLink, ros::SubscriptionWPtr, parent_)

TZC_GRANT(Outbox, ros::TransportSubscriberLink, SerializedQueue, outbox_)
TZC_GRANT(OutboxMutex, ros::TransportSubscriberLink, boost::mutex, outbox_mutex_)
TZC_GRANT(WritingMessage, ros::TransportSubscriberLink, bool, writing_message_)
TZC_GRANT(HeaderWritten, ros::TransportSubscriberLink, bool, header_written_)

TZC_GRANT(Socket, ros::TransportTCP, int, sock_)
TZC_GRANT(ReadMutex, ros::Connection, boost::recursive_mutex, read_mutex_)
TZC_GRANT(Connections, ros::ConnectionManager, ConnectionSet, connections_)
TZC_GRANT(ConnectionsMutex, ros::ConnectionManager, boost::mutex, connections_mutex_)

#undef TZC_GRANT
#undef TZC_GRANT_UNNAMED

}  // namespace roscpp_access
}  // namespace tzc
