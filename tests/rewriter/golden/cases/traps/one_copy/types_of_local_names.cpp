// In the port an iterator is a pointer, and a copy or a reference that auto declares is no std::vector: the program asks what they are.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <any>
#include <type_traits>
#include <typeinfo>
#include <vector>

template <class T>
struct Step {
  static constexpr int value = 1;
};
template <class T>
struct Step<T*> {
  static constexpr int value = 2;
};
template <class T>
struct Box {
  T kept;
  int pad() const { return std::is_pointer<T>::value; }
};
template <class T>
Box(T) -> Box<T>;

inline int kind_of(float*) {
  return 1;
}
template <class T>
long kind_of(T) {
  return 2;
}

class Node {
 public:
  void iterator() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto it = scan.ranges.begin();
    scan.angle_min = std::is_pointer<decltype(it)>::value;
    pub_.publish(scan);
  }
  void copy() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto copy = scan.ranges;
    scan.angle_min = std::is_same<decltype(copy), std::vector<float>>::value;
    pub_.publish(scan);
  }
  void reference() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    std::vector<float>& same = scan.ranges;
    scan.angle_min = std::is_same<std::decay<decltype(same)>::type, std::vector<float>>::value;
    pub_.publish(scan);
  }
  void alias_in_loop() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    for (auto it = scan.ranges.begin(); it != scan.ranges.end(); ++it) {
      using It = decltype(it);
      *it = std::is_class<It>::value;
    }
    pub_.publish(scan);
  }
  void specialised() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto it = scan.ranges.begin();
    scan.angle_min = Step<__typeof__(it)>::value;
    pub_.publish(scan);
  }
  void name() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto it = scan.ranges.begin();
    scan.header.frame_id = typeid(it).name();
    pub_.publish(scan);
  }
  void pair() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto ends = std::minmax_element(scan.ranges.begin(), scan.ranges.end());
    scan.angle_min = std::is_pointer<decltype(ends.first)>::value;
    pub_.publish(scan);
  }
  void overload_that_is_not_called() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto it = scan.ranges.begin();
    scan.angle_min = sizeof(decltype(kind_of(it)));
    pub_.publish(scan);
  }
  void exception() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto& same = scan.ranges;
    scan.angle_min = noexcept(same[0]);
    pub_.publish(scan);
  }
  void thrown() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    try {
      throw scan.ranges.begin();
    } catch (float*) {
      scan.angle_min = 1;
    } catch (...) {
    }
    pub_.publish(scan);
  }
  void aggregate() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    {
      Box box{scan.ranges.begin()};
      scan.angle_min = box.pad();
    }
    pub_.publish(scan);
  }
  void kept_with_its_type() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    std::any any(scan.ranges.begin());
    scan.angle_min = any.type() == typeid(float*);
    pub_.publish(scan);
  }
  void null_iterator() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto it = scan.ranges.begin();
    decltype(it) found;
    if (found == decltype(it)()) scan.angle_min = 1;
    pub_.publish(scan);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
};
//--- expected
// publish src/node.cpp:41 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:48 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:55 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:64 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:71 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:78 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:85 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:92 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:99 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:110 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:119 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// publish src/node.cpp:126 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data is kept in a 'std::any'
// publish src/node.cpp:134 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data has a type that the program asks for
// advertise src/node.cpp:139 sensor_msgs/LaserScan one_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::LaserScan>(nh_, "scan", 1);
