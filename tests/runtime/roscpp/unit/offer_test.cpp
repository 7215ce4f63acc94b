// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/offer.h"

#include <gtest/gtest.h>

#include "roscpp/upgrade/other_version.h"

namespace tzc {
namespace detail {
namespace {

Offer an_offer() {
  return Offer{"/image", "060021388200f6f0f447d0fcd9c64743", "/camera", "@tzc-1", "boot/4:5", "40000-50000",
               "token"};
}

TEST(Offer, travels_whole) {
  const Offer sent = an_offer();
  XmlRpc::XmlRpcValue params = to_xmlrpc(sent);
  Offer received;
  ASSERT_TRUE(from_xmlrpc(params, received));
  EXPECT_EQ(received.topic, sent.topic);
  EXPECT_EQ(received.md5sum, sent.md5sum);
  EXPECT_EQ(received.publisher, sent.publisher);
  EXPECT_EQ(received.address, sent.address);
  EXPECT_EQ(received.identity, sent.identity);
  EXPECT_EQ(received.connection, sent.connection);
  EXPECT_EQ(received.token, sent.token);
}

TEST(Offer, of_another_version_is_refused) {
  XmlRpc::XmlRpcValue params = to_xmlrpc(an_offer());
  params[0] = kOfferVersion + 1;
  Offer received;
  EXPECT_FALSE(from_xmlrpc(params, received));
}

TEST(Offer, of_another_version_still_names_topic_and_publisher) {
  XmlRpc::XmlRpcValue whole = to_xmlrpc(an_offer()), shorter, longer = to_xmlrpc(an_offer());
  whole[0] = 1;  // what releases sent that knew no number but the protocol's
  longer[0] = kOfferVersion + 1;
  longer[8] = "a field of the future";
  shorter[0] = kOfferVersion + 1;
  for (int i = 1; i <= 3; ++i) shorter[i] = static_cast<std::string>(whole[i]);
  for (XmlRpc::XmlRpcValue* params : {&whole, &shorter, &longer}) {
    Offer received;
    ASSERT_TRUE(is_other_version(*params, received));
    EXPECT_EQ(received.topic, "/image");
    EXPECT_EQ(received.publisher, "/camera");
    EXPECT_FALSE(from_xmlrpc(*params, received));
  }
}

TEST(Offer, of_this_version_or_of_none_is_not_one_of_another) {
  XmlRpc::XmlRpcValue same = to_xmlrpc(an_offer()), text("offer"), nothing, missing;
  missing[0] = kOfferVersion + 1;
  missing[1] = "/image";
  Offer received;
  for (XmlRpc::XmlRpcValue* params : {&same, &text, &nothing, &missing})
    EXPECT_FALSE(is_other_version(*params, received));
}

TEST(Offer, every_number_that_two_nodes_must_share_is_in_its_version) {
  EXPECT_EQ(kOfferVersion / 1000000, kProtocolVersion);
  EXPECT_EQ(static_cast<unsigned>(kOfferVersion / 1000 % 1000), channel::wire_version);
  EXPECT_EQ(static_cast<unsigned>(kOfferVersion % 1000), segment::layout_version);
}

TEST(ToldPeers, each_is_new_once_and_their_number_is_bounded) {
  ToldPeers told(2);
  EXPECT_TRUE(told.is_new("/camera"));
  EXPECT_FALSE(told.is_new("/camera"));
  EXPECT_TRUE(told.is_new("/viewer"));
  EXPECT_FALSE(told.is_new("/another"));
  EXPECT_FALSE(told.is_new("/camera"));
}

TEST(Offer, of_another_shape_is_refused) {
  Offer received;
  XmlRpc::XmlRpcValue text("offer"), nothing, missing, more = to_xmlrpc(an_offer()), number = more;
  missing[0] = kOfferVersion;
  more[8] = "one more";
  number[3] = 5;
  for (XmlRpc::XmlRpcValue* params : {&text, &nothing, &missing, &more, &number})
    EXPECT_FALSE(from_xmlrpc(*params, received));
}

TEST(Offer, the_response_is_ross) {
  XmlRpc::XmlRpcValue answer = response(0, "this node has not attached /image");
  EXPECT_EQ(static_cast<int>(answer[0]), 0);
  EXPECT_EQ(static_cast<std::string>(answer[1]), "this node has not attached /image");
  EXPECT_EQ(answer.size(), 3);
}

}  // namespace
}  // namespace detail
}  // namespace tzc
