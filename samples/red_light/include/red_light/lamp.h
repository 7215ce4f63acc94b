// SPDX-License-Identifier: BSD-3-Clause
#ifndef RED_LIGHT_LAMP_H
#define RED_LIGHT_LAMP_H

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

/// What a traffic light looks like: shared by the simulated cameras and by the detectors' templates.
namespace red_light {

const cv::Scalar HOUSING(16, 16, 16);
const cv::Scalar UNLIT(70, 70, 70);

inline cv::Scalar lampColour(const std::string& name) {  // bgr8
  if (name == "red") return cv::Scalar(0, 0, 255);
  if (name == "yellow") return cv::Scalar(0, 255, 255);
  if (name == "green") return cv::Scalar(0, 255, 0);
  throw std::invalid_argument("a lamp is red, yellow or green, not '" + name + "'");
}

/// A lamp in its housing.
inline void drawLamp(cv::Mat& image, cv::Point centre, int radius, const cv::Scalar& colour) {
  const int half = radius * 5 / 4;
  cv::rectangle(image, centre - cv::Point(half, half), centre + cv::Point(half, half), HOUSING, cv::FILLED);
  cv::circle(image, centre, radius, colour, cv::FILLED, cv::LINE_AA);
}

/// What a detector looks for. Smaller than the housing, so that what is behind the light has no part in it.
inline cv::Mat makeTemplate(int radius, const cv::Scalar& colour) {
  const int half = radius + 2;
  cv::Mat lamp(2 * half + 1, 2 * half + 1, CV_8UC3);
  drawLamp(lamp, cv::Point(half, half), radius, colour);
  return lamp;
}

/// Red above yellow above green; the one that `lit` names is lit. `centre` is the yellow lamp's.
inline void drawTrafficLight(cv::Mat& image, cv::Point centre, int radius, const std::string& lit) {
  int y = centre.y - radius * 5 / 2;
  for (const char* name : {"red", "yellow", "green"}) {
    drawLamp(image, cv::Point(centre.x, y), radius, lit == name ? lampColour(name) : UNLIT);
    y += radius * 5 / 2;
  }
}

/// A street without edges that look like a lamp: sky, asphalt and grain, the same in each run.
inline cv::Mat drawStreet(int width, int height) {
  cv::Mat street(height, width, CV_8UC3, cv::Scalar(200, 170, 140));
  street.rowRange(height * 3 / 5, height).setTo(cv::Scalar(90, 90, 90));
  cv::Mat grain(height, width, CV_8UC3);
  cv::RNG(7).fill(grain, cv::RNG::UNIFORM, 0, 40);
  return street + grain;
}

}  // namespace red_light

#endif
