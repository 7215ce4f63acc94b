// Algorithms that get no code of the package that takes elements, although types of the package and function objects stand there.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud.h>

#include <algorithm>
#include <functional>
#include <ostream>
#include <random>
#include <set>
#include <vector>

static void change(int) {}

struct Spot {
  float x = 0, y = 0;
  Spot() {}
  Spot(float a, float b) : x(a), y(b) {}
  bool operator<(const Spot& other) const { return x < other.x; }
};
static std::ostream& operator<<(std::ostream& out, const Spot& spot) { return out << spot.x; }
struct Named {
  explicit Named(const geometry_msgs::Point& p) : value(p.x) {}
  double value;
};

void stock_functions(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("stock_functions", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::mt19937 random(1);
  std::sort(image.data.begin(), image.data.end(), std::greater<uint8_t>());
  std::transform(image.data.begin(), image.data.end(), image.data.begin(), std::negate<>());
  std::shuffle(image.data.begin(), image.data.end(), random);
  std::generate(image.data.begin(), image.data.end(), std::ref(random));
  pub.publish(image);
  change(1);
}
void own_elements(ros::NodeHandle& nh, const std::vector<Spot>& spots) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud>("own_elements", 10);
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(spots.size());
  std::transform(spots.begin(), spots.end(), cloud.points.begin(), [](const Spot& spot) {
    geometry_msgs::Point p;
    p.x = spot.x;
    return p;
  });
  pub.publish(cloud);
  change(1);
}
void made_of_elements(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud>("made_of_elements", 10);
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(100);
  std::vector<Named> named;
  std::vector<Spot> spots;
  std::transform(cloud.points.begin(), cloud.points.end(), std::back_inserter(named),
                 [](const geometry_msgs::Point& p) { return Named(p); });
  spots.emplace_back(cloud.points[0].x, cloud.points[0].y);
  pub.publish(cloud);
  change(1);
}
//--- expected
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy 'stock_functions'
// publish src/node.cpp:36 sensor_msgs/Image zero_copy 'stock_functions'
// advertise src/node.cpp:40 sensor_msgs/PointCloud zero_copy 'own_elements'
// publish src/node.cpp:48 sensor_msgs/PointCloud zero_copy 'own_elements'
// advertise src/node.cpp:52 sensor_msgs/PointCloud zero_copy 'made_of_elements'
// publish src/node.cpp:60 sensor_msgs/PointCloud zero_copy 'made_of_elements'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("stock_functions", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "stock_functions", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud>("own_elements", 10);
// -  sensor_msgs::PointCloud cloud;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "own_elements", 10);
// +  tzc::sensor_msgs::PointCloud cloud;
// +  pub.allocate(cloud);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud>("made_of_elements", 10);
// -  sensor_msgs::PointCloud cloud;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "made_of_elements", 10);
// +  tzc::sensor_msgs::PointCloud cloud;
// +  pub.allocate(cloud);
