// SPDX-License-Identifier: BSD-3-Clause
// Every way in which a package gets TZC headers, in one program: that it builds is most of the test.
#include <tzc/lone_msgs/Scan.h>               // made by this package
#include <tzc/plain_msgs/Samples.h>           // made by probe_msgs, which uses it
#include <tzc/probe_msgs/Ask.h>               // services and
#include <tzc/probe_msgs/AskResponse.h>       // their halves
#include <tzc/probe_msgs/GoActionFeedback.h>  // messages of an action
#include <tzc/probe_msgs/Probe.h>             // probe_msgs' own
#include <tzc/sensor_msgs/Image.h>            // comes with tzc

#include <iostream>

int main() {
  tzc::probe_msgs::Probe probe;
  probe.image.data.resize(12);
  probe.samples.resize(2);
  probe.samples[1].values.push_back(2.5f);
  probe.joints.resize(3);
  const probe_msgs::Probe stock(probe);
  const bool same = static_cast<probe_msgs::Probe>(tzc::probe_msgs::Probe(stock)) == stock;
  const bool constants = tzc::probe_msgs::Probe::KIND == 3 && tzc::probe_msgs::Probe::NAME == "probe # kept";

  tzc::lone_msgs::Scan scan;
  scan.returns[1].energy.push_back(1);
  const lone_msgs::Scan plain(scan);
  const bool fixed_array = plain.returns[1].energy.size() == 1 && tzc::lone_msgs::Scan(plain) == scan;

  tzc::probe_msgs::AskResponse response;
  response.answer.push_back(42);
  tzc::probe_msgs::GoActionFeedback feedback;
  feedback.feedback.path.resize(7);
  std::cout << (same && constants && fixed_array ? "probe: all as expected" : "probe: WRONG") << std::endl;
}
