# SPDX-License-Identifier: BSD-3-Clause
"""What listens to a topic, in another process, and what passes a message on, in the same one."""
from . import messages
from .builders import contents
from .fills import change
from .publishers import choose as choose_publisher, in_block, parameter, perhaps_missing


def note(topic):
    return f'fuzz::received("{topic.name}", *msg);'


def subscriber(program):
    name = program.unique("sub") + "_"
    program.listener_state.append(f"ros::Subscriber {name};")
    return name


def callback(program, parameter, body, qualifier=""):
    name = program.unique("on")
    program.listener_functions.append(f"{qualifier}void {name}({parameter}) {{ {body} }}")
    return name


def subscribe_member(program, topic, name, owner=", this"):
    call = f'nh.subscribe("{topic.name}", 100, &Listener::{name}{owner});'
    program.listener_setup.append(f"{subscriber(program)} = {call}")


def by_const_pointer(program, topic):
    name = callback(program, f"const {topic.message.cpp}ConstPtr& msg", note(topic))
    subscribe_member(program, topic, name)


def keep(program, topic):
    """Keeps what it receives, which must not change afterwards."""
    name = callback(program, f"const {topic.message.cpp}ConstPtr& msg", f'{note(topic)} fuzz::keep("{topic.name}", msg);')
    subscribe_member(program, topic, name)


def by_pointer_value(program, topic):
    name = callback(program, f"{topic.message.cpp}::ConstPtr msg", note(topic))
    subscribe_member(program, topic, name)


def by_static_function(program, topic):
    name = callback(program, f"const {topic.message.cpp}ConstPtr& msg", note(topic), "static ")
    subscribe_member(program, topic, name, owner="")


def by_reference(program, topic):
    name = callback(program, f"const {topic.message.cpp}& msg", f'fuzz::received("{topic.name}", msg);')
    subscribe_member(program, topic, name)


def by_writable_pointer(program, topic):
    array = topic.message.arrays[0][0]
    name = callback(program, f"const {topic.message.cpp}Ptr& msg",
                    f"msg->{array}.resize(msg->{array}.size() + 1); {note(topic)}")
    subscribe_member(program, topic, name)


def by_bind(program, topic):
    name = callback(program, f"const {topic.message.cpp}ConstPtr& msg, int", note(topic))
    program.listener_setup.append(f'{subscriber(program)} = nh.subscribe<{topic.message.cpp}>("{topic.name}", 100, '
                                  f"boost::bind(&Listener::{name}, this, boost::placeholders::_1, 3));")


def by_lambda(program, topic):
    program.listener_setup.append(f'{subscriber(program)} = nh.subscribe<{topic.message.cpp}>("{topic.name}", 100, '
                                  f"[this](const {topic.message.cpp}ConstPtr& msg) {{ {note(topic)} }});")


def by_event(program, topic):
    name = callback(program, f"const ros::MessageEvent<{topic.message.cpp} const>& event",
                    f'fuzz::received("{topic.name}", *event.getMessage());')
    subscribe_member(program, topic, name)


def by_options(program, topic):
    name = callback(program, f"const {topic.message.cpp}ConstPtr& msg", note(topic))
    options = program.unique("options")
    program.listener_setup += [
        f'ros::SubscribeOptions {options} = ros::SubscribeOptions::create<{topic.message.cpp}>("{topic.name}", 100, '
        f"boost::bind(&Listener::{name}, this, boost::placeholders::_1), ros::VoidPtr(), nullptr);",
        f"{subscriber(program)} = nh.subscribe({options});"]


def by_filter(program, topic):
    program.includes.add("message_filters/subscriber.h")
    name = callback(program, f"const {topic.message.cpp}ConstPtr& msg", note(topic))
    kept = program.unique("filter") + "_"
    kind = f"message_filters::Subscriber<{topic.message.cpp}>"
    if program.rng.random() < 0.5:
        program.listener_state.append(f"{kind} {kept};")
        program.listener_setup += [f'{kept}.subscribe(nh, "{topic.name}", 100);',
                                   f"{kept}.registerCallback(&Listener::{name}, this);"]
    else:
        program.listener_state.append(f"boost::shared_ptr<{kind} > {kept};")
        program.listener_setup += [f'{kept}.reset(new {kind}(nh, "{topic.name}", 100));',
                                   f"{kept}->registerCallback(&Listener::{name}, this);"]


def by_image_transport(program, topic):
    if topic.message is not messages.IMAGE:
        return by_const_pointer(program, topic)
    program.includes.add("image_transport/image_transport.h")
    name = callback(program, "const sensor_msgs::ImageConstPtr& msg", note(topic))
    kept = program.unique("sub") + "_"
    program.listener_state.append(f"image_transport::Subscriber {kept};")
    call = f'subscribe("{topic.name}", 100, &Listener::{name}, this);'
    program.listener_setup.append(f"{kept} = image_transport::ImageTransport(nh).{call}")


WAYS = {by_const_pointer: 8, by_pointer_value: 1, by_static_function: 3, by_reference: 2, by_writable_pointer: 1,
        by_bind: 2,
        by_lambda: 1, by_event: 1, by_options: 1, by_filter: 2, by_image_transport: 3}


def listen(program, topic):
    program.rng.choices(list(WAYS), list(WAYS.values()))[0](program, topic)


# Passing on
# ----------------------------------------------------------------------------------------------------------------------


def forward(program, topic, publisher):
    return publisher.publish("in", True)


def change_copy(program, topic, publisher):
    cpp = topic.message.cpp
    return [f"{cpp} msg = *in;"] + in_block(change(program.rng, topic.message, "msg.")) + publisher.publish("msg")


def change_shared_copy(program, topic, publisher):
    cpp = topic.message.cpp
    made = program.rng.choice([f"{cpp}Ptr msg(new {cpp}(*in));", f"{cpp}Ptr msg = boost::make_shared<{cpp}>(*in);"])
    return [made] + in_block(change(program.rng, topic.message, "msg->")) + publisher.publish("msg", True)


def rebuild(program, topic, publisher):
    field, element = topic.message.arrays[0]
    last = f"in->{field}.size() - 1"
    copy = program.rng.choice([
        [f"msg.{field} = in->{field};"],
        [f"msg.{field}.resize(in->{field}.size());",
         f"for (std::size_t i = 0; i < in->{field}.size(); ++i) msg.{field}[i] = in->{field}[{last} - i];"],
        [f"for (const auto& one : in->{field}) msg.{field}.push_back(one);"],
    ])
    return [f"{topic.message.cpp} msg;", "msg.header = in->header;"] + copy + publisher.publish("msg")


def answer(program, topic, publisher):
    """Another message, of which only the header comes from the received one."""
    return ([f"{topic.message.cpp} msg;"] + contents(program, topic.message, "msg.") + ["msg.header = in->header;"] +
            publisher.publish("msg"))


RELAYS = [forward, change_copy, change_shared_copy, rebuild, rebuild, answer]


def relay(program):
    message = program.rng.choice([m for m in messages.ALL if m.header])
    source, target = program.topic(message, relays=1), program.topic(message)
    way = program.rng.choice(RELAYS)
    program.traits.append("relay: " + way.__name__)
    name = program.variable("ros::Publisher", "source")
    program.setup.append(f'{name} = nh.advertise<{message.cpp}>("{source.name}", 50);')
    by_pointer = program.rng.random() < 0.5
    made = f"{message.cpp}Ptr msg(new {message.cpp});" if by_pointer else f"{message.cpp} msg;"
    access = "msg->" if by_pointer else "msg."
    program.steps += in_block([made] + contents(program, message, access) +
                              [f"{name}.publish(msg);", f'fuzz::sent("{source.name}");'])
    # What is sent depends on the received message, which functions of their own would not know.
    publisher, wrap = choose_publisher(program, target, without=(parameter, perhaps_missing))
    body = ["const int k = static_cast<int>(in->header.stamp.sec % 10);"] + wrap(way(program, target, publisher))
    handler = program.helper("void", "relay", f"const {message.cpp}ConstPtr& in", body +
                             [f'fuzz::handled("{source.name}");'])
    kept = program.variable("ros::Subscriber", "sub")
    target_function = f"&Node::{handler}, this" if program.is_class else handler
    program.setup.append(f'{kept} = nh.subscribe("{source.name}", 50, {target_function});')
