// Only behind a class is alignas ignored by GCC.
#include <ros/ros.h>

struct Point {
  float x, y, z;
} int alignas(16);
//--- expected
// error does not parse: expected ';' after struct
