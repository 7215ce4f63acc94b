// The message of a struct that is moved as a whole is another one's, which nothing has bound.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <deque>
#include <vector>

struct Frame {
  sensor_msgs::Image image;
  std::vector<float> meta;
};

class Queue {
 public:
  void push(Frame&& frame) { frames_.emplace_back(std::move(frame)); }
  bool pop(Frame& frame) {
    if (frames_.empty()) return false;
    frame = std::move(frames_.front());
    frames_.pop_front();
    return true;
  }

 private:
  std::deque<Frame> frames_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "queued");
  ros::NodeHandle nh("~");
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("queued", 1);
  Queue queue;
  for (int k = 0; ros::ok(); ++k) {
    Frame frame;
    frame.image.data.resize(640 * 480, k);
    queue.push(std::move(frame));
    Frame next;
    while (queue.pop(next)) pub.publish(next.image);
  }
}
//--- expected
// advertise src/node.cpp:30 sensor_msgs/Image one_copy 'queued'
// publish src/node.cpp:37 sensor_msgs/Image one_copy 'queued' TZC1022 line 18 gives it elements that lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("queued", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "queued", 1);
// +    pub.allocate(next.image);
