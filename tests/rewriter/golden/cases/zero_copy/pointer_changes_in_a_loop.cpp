// What a loop changes behind the message, or in front of it, holds for its next pass; a label, a handler and another case are ways around.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Output {
  ros::Publisher pub;
  Output* next = nullptr;
};

void each(Output* output) {
  if (output->pub.getNumSubscribers() > 7) return;
  for (int i = 0; i < 3; ++i) {
    sensor_msgs::Image image;
    image.data.resize(101);
    if (output) output->pub.publish(image);
    output = output ? output->next : nullptr;
  }
}

void later(Output* output, Output* other) {
  sensor_msgs::ImagePtr last;
  for (int i = 0; i < 3; ++i) {
    if (i == 1) output = other;
    last.reset(new sensor_msgs::Image);
    last->data.resize(102);
  }
  output->pub.publish(last);
}

void other_case(int mode, Output* output) {
  switch (mode) {
    case 0:
      output->pub.getNumSubscribers();
      break;
    case 1: {
      sensor_msgs::Image image;
      image.data.resize(103);
      if (output) output->pub.publish(image);
    }
  }
}

void handled(const std::string& number, Output* output) {
  try {
    if (std::stoi(number) > 0) ROS_INFO("positive");
    output->pub.getNumSubscribers();
  } catch (const std::exception&) {
  }
  sensor_msgs::Image image;
  image.data.resize(104);
  if (output) output->pub.publish(image);
}

void in_one_pass(Output* output) {
  for (int i = 0; i < 3; ++i) {
    sensor_msgs::Image image;
    image.data.resize(105);
    output->pub.publish(image);
    output = output->next;
  }
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Output output{nh.advertise<sensor_msgs::Image>("image", 1)};
  each(&output);
  later(&output, &output);
  other_case(argc, &output);
  handled(argv[0], &output);
  in_one_pass(&output);
}
//--- expected
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:27 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:38 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:51 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:58 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:66 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub;
// +  tzc::Publisher pub;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  sensor_msgs::ImagePtr last;
// +  tzc::sensor_msgs::ImagePtr last;
// -    last.reset(new sensor_msgs::Image);
// +    last.reset(new tzc::sensor_msgs::Image);
// +    tzc::allocate(*last);
// -      sensor_msgs::Image image;
// +      tzc::sensor_msgs::Image image;
// +      tzc::allocate(image);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    output->pub.allocate(image);
// -  Output output{nh.advertise<sensor_msgs::Image>("image", 1)};
// +  Output output{tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)};
