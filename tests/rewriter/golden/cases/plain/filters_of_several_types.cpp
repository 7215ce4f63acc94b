// Each instance of a template has a filter of its own type, which is written once.
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

struct Images {
  typedef message_filters::Subscriber<sensor_msgs::Image> Filter;
};
struct Clouds {
  typedef message_filters::Subscriber<sensor_msgs::PointCloud2> Filter;
};

template <class Kind>
class Listener {
 public:
  explicit Listener(ros::NodeHandle& nh) { filter_.subscribe(nh, "topic", 1); }

 private:
  typename Kind::Filter filter_;
};

void run(ros::NodeHandle& nh) {
  Listener<Images> images(nh);
  Listener<Clouds> clouds(nh);
}
//--- expected
// subscribe src/node.cpp:16 sensor_msgs/Image plain 'topic' TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
// subscribe src/node.cpp:16 sensor_msgs/PointCloud2 plain 'topic' TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
