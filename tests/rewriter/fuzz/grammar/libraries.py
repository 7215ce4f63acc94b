# SPDX-License-Identifier: BSD-3-Clause
"""Messages that a library builds (cv_bridge, PCL, sensor_msgs), and image_transport's publishers. Each pattern adds its
publishers and steps to the program."""
from . import messages, publishers


def picture(rng):
    """A cv::Mat `picture` and its encoding."""
    kind, encoding = rng.choice([("CV_8UC1", "mono8"), ("CV_8UC3", "bgr8"), ("CV_16UC1", "mono16")])
    return [f"cv::Mat picture(3 + k, 5, {kind});",
            "for (std::size_t i = 0; i < picture.total() * picture.elemSize(); ++i)",
            "  picture.data[i] = static_cast<uint8_t>(fuzz::value(static_cast<int>(i), k));"], encoding


def cv_publisher(program):
    topic = program.topic(messages.IMAGE)
    program.includes |= {"cv_bridge/cv_bridge.h", "sensor_msgs/image_encodings.h"}
    if program.rng.random() < 0.5:
        return publishers.choose(program, topic)
    return transport(program, topic), publishers.as_it_is


def perhaps_borrowed(program, name):
    """An image publisher that stays image_transport's."""
    if program.rng.random() < 0.35:
        program.traits.append("borrowed image publisher")
        program.setup.append(f"fuzz::borrow({name});")


def transport(program, topic):
    program.includes.add("image_transport/image_transport.h")
    program.traits.append("image_transport")
    name = program.variable("image_transport::Publisher", "pub")
    made = program.rng.choice([["image_transport::ImageTransport it(nh);",
                                f'{name} = it.advertise("{topic.name}", 50);'],
                               [f'{name} = image_transport::ImageTransport(nh).advertise("{topic.name}", 50);']])
    program.setup += ["{"] + ["  " + line for line in made] + ["}"]
    perhaps_borrowed(program, name)
    return publishers.Publisher(f"{name}.", topic)


def cv_temporary(program):
    publisher, wrap = cv_publisher(program)
    lines, encoding = picture(program.rng)
    lines += ["std_msgs::Header header;", "header.stamp = ros::Time(50 + k, 1);"]
    lines += publisher.publish(f'cv_bridge::CvImage(header, "{encoding}", picture).toImageMsg()', True)
    program.steps += publishers.in_block(wrap(lines))


def cv_variable(program):
    publisher, wrap = cv_publisher(program)
    lines, encoding = picture(program.rng)
    image = f'cv_bridge::CvImage(std_msgs::Header(), "{encoding}", picture)'
    lines += [f"sensor_msgs::ImagePtr msg = {image}.toImageMsg();",
              "msg->header.stamp = ros::Time(60 + k, 2);", 'msg->header.frame_id = "cv";']
    if program.rng.random() < 0.4:
        lines.append("if (!msg->data.empty()) msg->data[0] = 42;")
    program.steps += publishers.in_block(wrap(lines + publisher.publish("msg", True)))


def cv_out_parameter(program):
    publisher, wrap = cv_publisher(program)
    lines, encoding = picture(program.rng)
    lines += ["cv_bridge::CvImage image;", f'image.encoding = "{encoding}";', "image.image = picture;",
              "image.header.stamp = ros::Time(70 + k, 3);"]
    if program.rng.random() < 0.5:
        lines += ["sensor_msgs::Image msg;", "image.toImageMsg(msg);"] + publisher.publish("msg")
    else:
        lines += publisher.publish("image.toImageMsg()", True)
    program.steps += publishers.in_block(wrap(lines))


def cv_over_message(program):
    """A cv::Mat made over the message's data."""
    publisher, wrap = cv_publisher(program)
    lines = ["sensor_msgs::Image msg;", 'msg.encoding = "mono8";', "msg.height = 4;", "msg.width = 6;", "msg.step = 6;",
             "msg.data.resize(24);", "cv::Mat view(4, 6, CV_8UC1, &msg.data[0]);", "view.setTo(cv::Scalar(7 + k));"]
    program.steps += publishers.in_block(wrap(lines + publisher.publish("msg")))


def camera(program):
    topic = program.topic(messages.IMAGE)
    info = program.topic(messages.Message("sensor_msgs/CameraInfo", [("D", messages.Element("double"))]))
    program.includes.add("image_transport/image_transport.h")
    topic.name, info.name = f"/{program.name}/camera/image", f"/{program.name}/camera/camera_info"
    name = program.variable("image_transport::CameraPublisher", "pub")
    program.setup.append(f'{name} = image_transport::ImageTransport(nh).advertiseCamera("{topic.name}", 50);')
    perhaps_borrowed(program, name)
    lines = (["sensor_msgs::ImagePtr msg(new sensor_msgs::Image);",
              "sensor_msgs::CameraInfoPtr info(new sensor_msgs::CameraInfo);"] +
             messages.IMAGE.set_meta("msg->") + ["msg->data.resize(30, static_cast<uint8_t>(k));",
                                                 "info->D.resize(5, 0.5 * k);",
             "info->header = msg->header;", f"{name}.publish(msg, info);", f'fuzz::sent("{topic.name}");',
              f'fuzz::sent("{info.name}");'])
    program.steps += publishers.in_block(lines)


def fill_image(program):
    topic = program.topic(messages.IMAGE)
    program.includes.add("sensor_msgs/fill_image.h")
    publisher, wrap = publishers.choose(program, topic)
    lines = ["const std::vector<uint8_t> pixels = fuzz::elements<uint8_t>(60, k);", "sensor_msgs::Image msg;",
             'sensor_msgs::fillImage(msg, "rgb8", 4, 5, 15, &pixels[0]);'] + publisher.publish("msg")
    program.steps += publishers.in_block(wrap(lines))


def modifier(program):
    topic = program.topic(messages.CLOUD2)
    program.includes.add("sensor_msgs/point_cloud2_iterator.h")
    publisher, wrap = publishers.choose(program, topic)
    pointer = program.rng.random() < 0.4
    cpp = "sensor_msgs::PointCloud2"
    made = f"{cpp}Ptr msg(new {cpp});" if pointer else f"{cpp} msg;"
    value = "*msg" if pointer else "msg"
    number = "sensor_msgs::PointField::FLOAT32"
    fields = program.rng.choice(['setPointCloud2FieldsByString(1, "xyz")',
                                 f'setPointCloud2Fields(2, "x", 1, {number}, "y", 1, {number})'])
    lines = [made, f"sensor_msgs::PointCloud2Modifier modifier({value});", f"modifier.{fields};",
             "modifier.resize(6 + k);",
             f'sensor_msgs::PointCloud2Iterator<float> x({value}, "x"), y({value}, "y");',
             "for (int i = 0; i < 6 + k; ++i, ++x, ++y) {", "  *x = fuzz::value(i, k) % 100;", "  *y = 0.25f * i;", "}"]
    program.steps += publishers.in_block(wrap(lines + publisher.publish("msg", pointer)))


def cloud(rng):
    return ["pcl::PointCloud<pcl::PointXYZ> cloud;", "cloud.header.stamp = 1000000ull * k;",
            "for (int i = 0; i < 5 + k; ++i) cloud.push_back(pcl::PointXYZ(i, k, fuzz::value(i, k) % 50));"]


def pcl_to_message(program):
    topic = program.topic(messages.CLOUD2)
    program.includes.add("pcl_conversions/pcl_conversions.h")
    publisher, wrap = publishers.choose(program, topic)
    lines = cloud(program.rng)
    if program.rng.random() < 0.5:
        lines += ["sensor_msgs::PointCloud2 msg;", "pcl::toROSMsg(cloud, msg);",
                  'msg.header.frame_id = "map";'] + publisher.publish("msg")
    else:
        lines += ["sensor_msgs::PointCloud2Ptr msg(new sensor_msgs::PointCloud2);", "pcl::toROSMsg(cloud, *msg);",
                  "msg->header.stamp = ros::Time(5 + k, 0);"] + publisher.publish("msg", True)
    program.steps += publishers.in_block(wrap(lines))


def pcl_from_pcl(program):
    topic = program.topic(messages.CLOUD2)
    program.includes.add("pcl_conversions/pcl_conversions.h")
    publisher, wrap = publishers.choose(program, topic)
    call = program.rng.choice(["fromPCL", "moveFromPCL"])
    lines = cloud(program.rng) + ["pcl::PCLPointCloud2 flat;", "pcl::toPCLPointCloud2(cloud, flat);",
                                  "sensor_msgs::PointCloud2 msg;",
                                  f"pcl_conversions::{call}(flat, msg);"] + publisher.publish("msg")
    program.steps += publishers.in_block(wrap(lines))


def pcl_as_such(program):
    topic = program.topic(messages.CLOUD2)
    program.includes.add("pcl_ros/point_cloud.h")
    name = program.variable("ros::Publisher", "pub")
    kind = program.rng.choice(["pcl::PointCloud<pcl::PointXYZ> ", "sensor_msgs::PointCloud2"])
    program.setup.append(f'{name} = nh.advertise<{kind}>("{topic.name}", 50);')
    lines = cloud(program.rng)
    pointer = program.rng.random() < 0.5
    argument = "boost::make_shared<pcl::PointCloud<pcl::PointXYZ> >(cloud)" if pointer else "cloud"
    lines += publishers.Publisher(f"{name}.", topic).publish(argument)
    program.steps += publishers.in_block(lines)


SENSORS = [fill_image, modifier]
VISION = [cv_temporary, cv_variable, cv_out_parameter, cv_over_message, camera, fill_image]
CLOUDS = [pcl_to_message, pcl_to_message, pcl_from_pcl, pcl_as_such, modifier]
