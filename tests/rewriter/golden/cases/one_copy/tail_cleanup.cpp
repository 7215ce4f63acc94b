// GCC calls a function where the scope of a variable ends, which no expression says: behind the publish, with a pointer into the
// message, and with a message itself.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

static ros::Publisher pub;
static uint8_t* raw;
static uint8_t* kept;
static sensor_msgs::Image last;

static void write(int*) {
  *raw = 1;
}
static void keep(uint8_t** at) {
  kept = *at;
}
static void send(sensor_msgs::Image** at) {
  pub.publish(**at);
}

void behind() {
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  __attribute__((cleanup(write))) int number = 0;
}
void before() {
  sensor_msgs::Image image;
  __attribute__((cleanup(write))) int number = 0;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
}
void pointer() {
  sensor_msgs::Image image;
  image.data.resize(100);
  {
    __attribute__((cleanup(keep))) uint8_t* at = image.data.data();
  }
  pub.publish(image);
  kept[0] = 1;
}
void message() {
  last.data.resize(100);
  uint8_t* at = last.data.data();
  {
    __attribute__((cleanup(send))) sensor_msgs::Image* sent = &last;
  }
  at[0] = 1;
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("image", 1);
  behind();
}
//--- expected
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1019 no call that gives 'at' a message was found
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:33 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:41 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is given to a function where the scope of its variable ends
// advertise src/node.cpp:56 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -static ros::Publisher pub;
// +static tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
