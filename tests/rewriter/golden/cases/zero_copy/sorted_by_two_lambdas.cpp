// The library's templates, and one of the package's, get one closure and another.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

template <class Less>
void sort_all(std::vector<int>& numbers, Less less) {
  std::sort(numbers.begin(), numbers.end(), less);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 5);
  std::vector<int> rows = {3, 1, 2}, columns = rows;
  std::sort(rows.begin(), rows.end(), [](int a, int b) { return a < b; });
  std::sort(columns.begin(), columns.end(), [](int a, int b) { return b < a; });
  sort_all(rows, [](int a, int b) { return a % 2 < b % 2; });
  sort_all(columns, [](int a, int b) { return a % 3 < b % 3; });
  sensor_msgs::Image out;
  out.height = rows[0];
  out.width = columns[0];
  out.data.resize(out.height * out.width);
  pub.publish(out);
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'out'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 5);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "out", 5);
// -  sensor_msgs::Image out;
// +  tzc::sensor_msgs::Image out;
// +  pub.allocate(out);
