// The compiler knows the function that a pointer to member leads to, and the call has no name that leads there.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <vector>

template <class Object, class Argument, void (Object::*function)(Argument)>
void call(Object& object, Argument argument) {
  (object.*function)(argument);
}

class Node {
 public:
  Node() {
    pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
    sub_ = nh_.subscribe("in", 10, &Node::on_image, this);
  }
  void grab() {
    sensor_msgs::Image image;
    image.data.resize(100);
    call<Node, const sensor_msgs::Image&, &Node::send>(*this, image);
  }
  void bridge(const cv::Mat& mat) {
    cv_bridge::CvImage image(std_msgs::Header(), "mono8", mat);
    sensor_msgs::Image filled;
    (image.*method)(filled);
    pub_.publish(filled);
  }
  void on_image(const sensor_msgs::ImageConstPtr& image) {
    call<std::vector<sensor_msgs::ImageConstPtr>, const sensor_msgs::ImageConstPtr&,
         &std::vector<sensor_msgs::ImageConstPtr>::push_back>(kept_, image);
  }

 private:
  void send(const sensor_msgs::Image& image) { pub_.publish(image); }
  static constexpr void (cv_bridge::CvImage::*method)(sensor_msgs::Image&) const = &cv_bridge::CvImage::toImageMsg;

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  std::vector<sensor_msgs::ImageConstPtr> kept_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  node.grab();
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image'
// subscribe src/node.cpp:17 sensor_msgs/Image shared 'in'
// publish src/node.cpp:28 sensor_msgs/Image one_copy 'image' TZC1001 it is passed to a function that is not known here
// publish src/node.cpp:36 sensor_msgs/Image one_copy 'image' TZC1002 it is passed to 'std::vector::push_back', which is not part of the package
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// -    sub_ = nh_.subscribe("in", 10, &Node::on_image, this);
// +    pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10);
// +    sub_ = tzc::subscribe(nh_, "in", 10, &Node::on_image, this);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
