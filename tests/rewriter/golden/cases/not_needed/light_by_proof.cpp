// Every use of the arrays makes a number of elements that the compiler knows.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<std_msgs::Float32MultiArray>("member", 10)) {
    member_.data.resize(kSize);
  }
  void update(ros::NodeHandle& nh) {
    member_.data[2] = 1;
    pub_.publish(member_);
    ros::Publisher other = nh.advertise<std_msgs::Float32MultiArray>("local", 10);
    std_msgs::Float32MultiArray assigned;
    assigned.data.assign(12, 0.5f);
    other.publish(assigned);
    std_msgs::Float32MultiArray listed;
    listed.data = {1, 2, 3};
    other.publish(listed);
    std_msgs::Float32MultiArray pushed;
    pushed.data.push_back(1);
    if (assigned.data.size() > 3) pushed.data.push_back(2);
    for (float& value : pushed.data) value *= 2;
    other.publish(pushed);
  }

 private:
  enum { kSize = 6 };
  ros::Publisher pub_;
  std_msgs::Float32MultiArray member_;
};
//--- expected
// advertise src/node.cpp:8 std_msgs/Float32MultiArray not_needed 'member' what is published with it needs no shared memory
// publish src/node.cpp:13 std_msgs/Float32MultiArray not_needed 'member' its arrays hold at most 24 bytes
// advertise src/node.cpp:14 std_msgs/Float32MultiArray not_needed 'local' what is published with it needs no shared memory
// publish src/node.cpp:17 std_msgs/Float32MultiArray not_needed 'local' its arrays hold at most 48 bytes
// publish src/node.cpp:20 std_msgs/Float32MultiArray not_needed 'local' its arrays hold at most 12 bytes
// publish src/node.cpp:25 std_msgs/Float32MultiArray not_needed 'local' its arrays hold at most 8 bytes
