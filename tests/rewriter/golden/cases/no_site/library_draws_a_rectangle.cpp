// Rect_ is made as messages are, and is none.
#include <ros/ros.h>

namespace cv {
template <class T>
struct Rect_ {
  T x, y;
};
typedef Rect_<int> Rect;
}  // namespace cv
#include <other/overlay.h>

void show(other::Overlay& overlay) {
  overlay.publishBox(cv::Rect{0, 0}, 3);
}
//--- expected
