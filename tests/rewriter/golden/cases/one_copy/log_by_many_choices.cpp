// References to choices between references: which stream the last one is, is not followed through all of them.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <iostream>

static uint8_t* raw;

void run(ros::NodeHandle& nh, bool left) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
#define TWICE(to, from) std::ostream& to = left ? from : from
  TWICE(a, std::cout);
  TWICE(b, a);
  TWICE(c, b);
  TWICE(d, c);
  TWICE(e, d);
  TWICE(f, e);
  TWICE(g, f);
  TWICE(h, g);
  TWICE(i, h);
  TWICE(j, i);
  TWICE(k, j);
  TWICE(l, k);
  TWICE(m, l);
  TWICE(n, m);
  TWICE(o, n);
  TWICE(p, o);
  TWICE(q, p);
  TWICE(r, q);
  TWICE(s, r);
  TWICE(t, s);
  TWICE(u, t);
  TWICE(v, u);
  TWICE(w, v);
  TWICE(x, w);
  TWICE(y, x);
  TWICE(z, y);
  TWICE(aa, z);
  TWICE(ab, aa);
  TWICE(ac, ab);
  TWICE(ad, ac);
  TWICE(ae, ad);
  TWICE(af, ae);
  ad << "sent" << 1;
}
//--- expected
