// The thread filled it, says so, and goes on reading while the message is published.
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

#include <atomic>
#include <thread>

class Node {
 public:
  void step(int k) {
    std::atomic<bool> ready(false), done(false);
    std::thread reader([&] {
      frame_->data.assign(1000, static_cast<float>(k));
      ready = true;
      while (!done)
        for (auto at = frame_->data.begin(); at != frame_->data.end(); ++at) sum_ += *at;
    });
    while (!ready) std::this_thread::yield();
    send(frame_);
    done = true;
    reader.join();
  }

 private:
  void send(const std_msgs::Float32MultiArrayPtr& msg) { pub_.publish(msg); }
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<std_msgs::Float32MultiArray>("sums", 1);
  std_msgs::Float32MultiArrayPtr frame_ = boost::make_shared<std_msgs::Float32MultiArray>();
  float sum_ = 0;
};
//--- expected
// publish src/node.cpp:25 std_msgs/Float32MultiArray one_copy 'sums' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:27 std_msgs/Float32MultiArray one_copy 'sums'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<std_msgs::Float32MultiArray>("sums", 1);
// +  tzc::Publisher pub_ = tzc::advertise<std_msgs::Float32MultiArray>(nh_, "sums", 1);
