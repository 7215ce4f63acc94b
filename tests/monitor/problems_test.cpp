// SPDX-License-Identifier: BSD-3-Clause
#include "problems.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tzc::monitor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Problems : testing::Test {
  Problems() {
    camera.name = "/camera";
    camera.pid = 42;
    Topic image;
    image.name = "/image";
    camera.topics = {image};
  }

  Connection& connect(const std::string& subscriber, Transport transport = Transport::shared,
                      const std::string& reason = "") {
    Connection connection;
    connection.subscriber = subscriber;
    connection.transport = transport;
    connection.reason = reason;
    camera.topics[0].connections.push_back(connection);
    return camera.topics[0].connections.back();
  }
  static std::vector<std::string> texts(const std::vector<Node>& nodes) {
    std::vector<std::string> found;
    for (const Problem& problem : problems(nodes)) found.push_back(problem.text);
    return found;
  }
  std::vector<std::string> texts() const { return texts({camera}); }

  Node camera;
};

TEST_F(Problems, are_none_where_all_is_well) {
  connect("/viewer").held = 3;
  connect("/nodelet", Transport::intraprocess, "it is in the same process and gets the message itself");
  EXPECT_THAT(texts(), IsEmpty());
}

TEST_F(Problems, a_stopped_process_is_named_once) {
  for (int i = 0; i < 2; ++i) {
    Connection& connection = connect("/viewer");
    connection.pid = 77;
    connection.is_stopped = true;
  }
  EXPECT_THAT(texts(), ElementsAre("/viewer (process 77) is stopped. kill -CONT 77 lets it go on."));
  camera.topics.clear();
  camera.state = State::stopped;
  camera.age_s = 12;
  EXPECT_THAT(texts(),
              ElementsAre("/camera (process 42) is stopped, for 12 s so far. kill -CONT 42 lets it go on."));
}

TEST_F(Problems, of_memory_name_who_keeps_it) {
  camera.topics[0].counters.exhausted = 9;
  camera.topics[0].memory.used = camera.topics[0].memory.size = 4 << 20;
  Connection& hoarder = connect("/hoarder");
  hoarder.held = 40;
  hoarder.oldest_held_s = 31;
  connect("/viewer");
  EXPECT_THAT(texts(),
              ElementsAre("/camera has no shared memory left for /image: 9 messages were sent "
                          "serialized; 4.0M of 4.0M are in use. /hoarder holds 40 blocks for up to 31 "
                          "s, 0 messages are in flight to it. Raise ~tzc/memory_size, or let "
                          "subscribers keep less."));
}

TEST_F(Problems, of_memory_that_nobody_keeps_do_not_ask_for_more) {
  camera.topics[0].counters.exhausted = 9;
  connect("/viewer");
  EXPECT_THAT(texts(), ElementsAre(HasSubstr(
                           "/camera finds no shared memory for messages of /image: 9 messages were sent "
                           "serialized. None of ")));
}

TEST_F(Problems, of_memory_that_are_over_are_none) {
  camera.topics[0].counters.exhausted = 9;
  camera.rates = {Rates{30, 30, 0, 0, 0}};
  EXPECT_THAT(texts(), IsEmpty());
  camera.rates = {Rates{30, 30, 2, 0, 2}};
  EXPECT_THAT(texts(), ElementsAre(HasSubstr("no shared memory for")));
}

TEST_F(Problems, lost_messages_have_their_cause) {
  connect("/slow").revoked_for_queue = 5;
  connect("/late").revoked_for_memory = 2;
  connect("/gone").revoked_at_end = 7;  // what a subscriber leaves behind is no problem
  EXPECT_THAT(
      texts(),
      ElementsAre("/slow did not take 5 messages of /image from /camera in time: its queue was full.",
                  "/late did not take 2 messages of /image from /camera in time: their memory was needed."));
}

TEST_F(Problems, lost_messages_with_two_causes_have_both) {
  Connection& slow = connect("/slow");
  slow.revoked_for_queue = 4;
  slow.revoked_for_memory = 1;
  EXPECT_THAT(texts(),
              ElementsAre("/slow did not take 5 messages of /image from /camera in time: 4 because its queue "
                          "was full, 1 because their memory was needed."));
}

// The cause of what was lost long ago says nothing about now.
TEST_F(Problems, lost_messages_have_the_cause_of_those_since_the_last_look) {
  Connection& slow = connect("/slow");
  slow.revoked_for_queue = 5;
  slow.revoked_for_memory = 40;
  slow.lost_since = Losses{3, 0};
  EXPECT_THAT(texts(),
              ElementsAre("/slow did not take 3 messages of /image from /camera in time (45 since it "
                          "connected): its queue was full."));
  slow.lost_since = Losses{2, 1};
  EXPECT_THAT(texts(),
              ElementsAre("/slow did not take 3 messages of /image from /camera in time (45 since it "
                          "connected): 2 because its queue was full, 1 because their memory was needed."));
}

TEST_F(Problems, lost_messages_of_long_ago_are_none) {
  Connection& slow = connect("/slow");
  slow.revoked_for_queue = 5;
  slow.lost_since = Losses{};
  EXPECT_THAT(texts(), IsEmpty());
  slow.lost_since = Losses{1, 0};
  EXPECT_THAT(texts(), ElementsAre(HasSubstr("did not take 1 messages")));
}

TEST_F(Problems, of_a_stopped_process_are_not_told_twice) {
  Connection& stopped = connect("/viewer");
  stopped.pid = 77;
  stopped.is_stopped = true;
  stopped.revoked_for_queue = 5;
  EXPECT_THAT(texts(), ElementsAre(HasSubstr("/viewer (process 77) is stopped")));
}

TEST_F(Problems, of_connections_say_what_to_do_and_come_last) {
  connect("/rviz", Transport::tcpros, "the node at http://a:1/ does not know the method tzcOffer");
  Connection& stopped = connect("/viewer");
  stopped.pid = 77;
  stopped.is_stopped = true;
  const auto found = problems({camera});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, ProblemKind::stopped);
  EXPECT_EQ(found[1].kind, ProblemKind::tcpros);
  EXPECT_THAT(found[1].text,
              HasSubstr("/camera sends /image to /rviz over TCPROS: the node at http://a:1/ does"));
  EXPECT_THAT(found[1].text, HasSubstr("port it, or start it with tzc-run"));
}

/// Of /viewer to /camera.
Node viewer_of(const std::string& topic, Transport transport) {
  Subscription subscription;
  subscription.topic = topic;
  subscription.publisher = "/camera";
  subscription.transport = transport;
  Node viewer;
  viewer.name = "/viewer";
  viewer.pid = 77;
  viewer.subscriptions = {subscription};
  return viewer;
}

// Nothing was wrong with a ported subscriber of an unported publisher.
TEST_F(Problems, of_subscriptions_are_told_where_the_publisher_s_page_does_not) {
  const Node viewer = viewer_of("/raw", Transport::tcpros);
  const auto found = problems({camera, viewer});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, ProblemKind::tcpros);
  EXPECT_EQ(found[0].node, "/viewer");
  EXPECT_THAT(found[0].text,
              HasSubstr("/viewer gets /raw from /camera over TCPROS: /camera uses TZC and has not attached"));
  EXPECT_THAT(texts({viewer}), ElementsAre(HasSubstr("there is no statistics page of /camera here")));
}

TEST_F(Problems, of_subscriptions_are_told_once) {
  connect("/viewer", Transport::tcpros, "it has no TZC");
  EXPECT_THAT(texts({camera, viewer_of("/image", Transport::tcpros)}),
              ElementsAre("/camera sends /image to /viewer over TCPROS: it has no TZC."));
  EXPECT_THAT(texts({viewer_of("/image", Transport::shared)}), IsEmpty());
}

}  // namespace
}  // namespace tzc::monitor
