// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "why.h"
#include "words.h"

namespace tzc::monitor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Node camera_and_depth() {
  Connection shared, plain;
  shared.subscriber = "/viewer";
  shared.transport = Transport::shared;
  plain.subscriber = "/rviz";
  plain.transport = Transport::tcpros;
  plain.reason = "this node has not attached /image";
  Topic image, depth;
  image.name = "/image";
  image.connections = {shared, plain};
  depth.name = "/depth";
  Node node;
  node.name = "/camera";
  node.topics = {image, depth};
  return node;
}

TEST(Explain, a_shared_connection_by_its_subscriber) {
  EXPECT_THAT(explain({camera_and_depth()}, "viewer", "image").sentences,
              ElementsAre("/camera sends /image to /viewer through shared memory."));
}

TEST(Explain, all_connections_of_a_publisher) {
  EXPECT_THAT(explain({camera_and_depth()}, "/camera", "/image").sentences,
              ElementsAre("/camera sends /image to /viewer through shared memory.",
                          "/camera sends /image to /rviz over TCPROS: /rviz has not attached /image. It "
                          "subscribes by nh.subscribe: use tzc::subscribe or tzc::attach there. Or TZC is "
                          "switched off there: rosparam get NODE/tzc, TZC_DISABLE."));
}

TEST(Explain, what_a_subscriber_gets_from_publishers_without_a_page) {
  Node viewer;
  viewer.name = "/viewer";
  for (const char* publisher : {"/camera", "/plain", "/hidden"}) {
    Subscription subscription;
    subscription.topic = "/image";
    subscription.publisher = publisher;
    subscription.transport = subscription.publisher == "/plain" ? Transport::tcpros : Transport::shared;
    viewer.subscriptions.push_back(subscription);
  }
  EXPECT_THAT(
      explain({camera_and_depth(), viewer}, "/viewer", "/image").sentences,
      ElementsAre(
          "/camera sends /image to /viewer through shared memory.",
          "/viewer gets /image from /plain over TCPROS: there is no statistics page of /plain here. It "
          "may not use TZC, or have it switched off, be another user's, run on another machine, or be "
          "gone.",
          "/viewer gets /image from /hidden through shared memory."));
  EXPECT_TRUE(explain({viewer}, "/viewer", "/depth").sentences.empty());
}

TEST(Explain, what_a_subscriber_gets_from_a_node_that_does_not_attach_the_topic) {
  Node camera = camera_and_depth(), viewer;
  viewer.name = "/viewer";
  Subscription subscription;
  subscription.topic = "/raw";
  subscription.publisher = "/camera";
  subscription.transport = Transport::tcpros;
  viewer.subscriptions = {subscription};
  const std::string sentence =
      "/viewer gets /raw from /camera over TCPROS: /camera uses TZC and has not attached /raw. It advertises "
      "it by nh.advertise: port that place (tzc-rewrite's report names it), or give what it returns to "
      "tzc::attached there.";
  EXPECT_THAT(explain({camera, viewer}, "/viewer", "/raw").sentences, ElementsAre(sentence));
  camera.state = State::silent;
  camera.age_s = 12;
  EXPECT_THAT(explain({camera, viewer}, "/viewer", "/raw").sentences,
              ElementsAre(sentence + " (/camera is silent: this is as of 12 s ago.)"));
}

TEST(Explain, what_a_full_page_left_out_is_not_known) {
  Node camera = camera_and_depth(), viewer;
  camera.left_out = 3;
  viewer.name = "/viewer";
  Subscription subscription;
  subscription.topic = "/late";
  subscription.publisher = "/camera";
  subscription.transport = Transport::tcpros;
  viewer.subscriptions = {subscription};
  EXPECT_THAT(
      explain({camera, viewer}, "/viewer", "/late").sentences,
      ElementsAre("/viewer gets /late from /camera over TCPROS. Why, the statistics page of /camera does not "
                  "say: it had no room for all its rows."));
  EXPECT_THAT(explain({camera}, "/camera", "/late").nothing,
              HasSubstr(" Or it is /camera, whose statistics page had no room"));
  camera.left_out = 0;
  EXPECT_THAT(explain({camera}, "/camera", "/late").nothing, testing::Not(HasSubstr("no room")));
}

TEST(Explain, a_reason_that_is_a_question_ends_with_its_mark) {
  Node node = camera_and_depth();
  node.topics[0].connections[1].reason = "no answer, and does it run?";
  EXPECT_THAT(explain({node}, "/rviz", "/image").sentences,
              ElementsAre("/camera sends /image to /rviz over TCPROS: no answer, and does it run?"));
}

TEST(Explain, that_a_process_is_stopped) {
  Node node = camera_and_depth();
  node.state = State::stopped;
  node.age_s = 12;
  node.topics[0].connections[0].is_stopped = true;
  EXPECT_THAT(
      explain({node}, "/viewer", "/image").sentences,
      ElementsAre("/camera sends /image to /viewer through shared memory. (/camera is stopped: this is as of "
                  "12 s ago.) (/viewer is stopped.)"));
}

TEST(Explain, what_was_not_found) {
  EXPECT_THAT(explain({camera_and_depth()}, "/camera", "/depth").sentences,
              ElementsAre("/camera publishes /depth and has no subscriber."));
  const Explanation no_connection = explain({camera_and_depth()}, "/nobody", "/image");
  EXPECT_TRUE(no_connection.sentences.empty());
  EXPECT_EQ(no_connection.nothing, "/image is published by /camera, which has no connection to /nobody.");
  EXPECT_THAT(explain({camera_and_depth()}, "/viewer", "/none").nothing,
              HasSubstr("publishes /none with TZC"));
}

TEST(Words, of_every_reason_that_the_upgrade_gives_have_advice) {
  for (const char* reason :
       {"the node at http://a:1/ does not know the method tzcOffer", "this node has not attached /image",
        "this node is on another machine or network namespace", "it belongs to another user",
        "the publisher is a process of another user", "not an offer of this version of TZC",
        "this node expects another message type on /image",
        "the publisher: more than seven eighths of the 64 file descriptors that this process may have are in "
        "use",
        "asked again, at last every five minutes, after 10 tries: no answer from http://a:1/; does this "
        "address lead "
        "to it",
        "the subscriber asked for UDPROS"})
    EXPECT_NE(advice(reason), "") << reason;
  EXPECT_EQ(advice("shared memory was not offered yet"), "");
}

TEST(Words, bytes_are_short) {
  EXPECT_EQ(short_bytes(0), "0");
  EXPECT_EQ(short_bytes(512), "512");
  EXPECT_EQ(short_bytes(1536), "1.5K");
  EXPECT_EQ(short_bytes(24.9 * (1 << 20)), "24.9M");
  EXPECT_EQ(short_bytes(1e18), "909495T");
}

}  // namespace
}  // namespace tzc::monitor
