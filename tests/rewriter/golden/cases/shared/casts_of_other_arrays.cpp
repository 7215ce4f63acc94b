// Const is cast away from arrays that are no message's: of an object's own, in a container, of a function that is given no others. Others
// are user data of a library, in a program in which no message's array loses its type; and one has other elements.
#include <map>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

size_t append(char* bytes, size_t n, size_t m, void* user) {
  auto* all = static_cast<std::vector<uint8_t>*>(user);
  all->insert(all->end(), bytes, bytes + n * m);
  return n * m;
}
void download(size_t (*write)(char*, size_t, size_t, void*), void* user);

static void clear(const std::vector<uint8_t>& bytes) { const_cast<std::vector<uint8_t>&>(bytes).clear(); }
const std::vector<double>& weights();

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : subscriber_(nh.subscribe("image", 1, &Node::on_image, this)) {
    std::vector<uint8_t> local(10);
    const std::vector<uint8_t>& name = local;
    const_cast<std::vector<uint8_t>&>(name).resize(5);
    clear(local);
    clear(own_);
    download(append, &local);
    const_cast<std::vector<double>&>(weights()).resize(3);
  }
  void reset() const {
    const_cast<std::vector<uint8_t>&>(own_).resize(5);
    const_cast<std::vector<uint8_t>*>(&rows_[0])->resize(5);
    const_cast<std::vector<uint8_t>&>(rows_.front()).resize(5);
  }

 private:
  void on_image(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%zu bytes", image->data.size()); }
  std::vector<uint8_t> own_;
  std::vector<std::vector<uint8_t>> rows_;
  ros::Subscriber subscriber_;
};
//--- expected
// subscribe src/node.cpp:21 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Node(ros::NodeHandle& nh) : subscriber_(nh.subscribe("image", 1, &Node::on_image, this)) {
// +  explicit Node(ros::NodeHandle& nh) : subscriber_(tzc::subscribe(nh, "image", 1, &Node::on_image, this)) {
