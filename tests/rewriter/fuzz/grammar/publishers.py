# SPDX-License-Identifier: BSD-3-Clause
"""Where a publisher lives. Each home returns the publisher and a function that puts the statements that use it in their
place."""
from .fills import in_block


class Publisher:
    asks = True  # knows getNumSubscribers

    def __init__(self, call, topic):
        self.call, self.topic = call, topic  # "pub_." or "pub_->"

    def publish(self, argument, pointer=False):
        return [f"{self.call}publish({argument});", f'fuzz::sent("{self.topic.name}");']


def as_it_is(lines):
    return lines


def advertise(program, topic, latch_chance=0.1):
    latch = ", true" if program.rng.random() < latch_chance else ""
    return f'nh.advertise<{topic.message.cpp}>("{topic.name}", 50{latch})'


def member(program, topic):
    name = program.variable("ros::Publisher", "pub")
    program.setup.append(f"{name} = {advertise(program, topic)};")
    return Publisher(f"{name}.", topic), as_it_is


def initialized_member(program, topic):
    name = program.variable("ros::Publisher", "pub")
    program.initializers.append(f"{name}({advertise(program, topic)})")
    return Publisher(f"{name}.", topic), as_it_is


def in_vector(program, topic):
    name = program.variable("std::vector<ros::Publisher>", "pubs")
    program.setup.append(f"{name}.push_back({advertise(program, topic)});")
    return Publisher(f"{name}[0].", topic), as_it_is


def in_map(program, topic):
    name = program.variable("std::map<std::string, ros::Publisher>", "pubs")
    program.setup.append(f'{name}["out"] = {advertise(program, topic)};')
    return Publisher(f'{name}["out"].', topic), as_it_is


def in_array(program, topic):
    name = program.variable("ros::Publisher", "pubs", "[2]")
    program.setup.append(f"{name}[1] = {advertise(program, topic)};")
    return Publisher(f"{name}[1].", topic), as_it_is


def by_shared_pointer(program, topic):
    name = program.variable("boost::shared_ptr<ros::Publisher>", "pub")
    program.setup.append(f"{name}.reset(new ros::Publisher({advertise(program, topic)}));")
    return Publisher(f"{name}->", topic), as_it_is


def in_struct(program, topic):
    kind = program.unique("Output")
    program.prelude += [f"struct {kind} {{", "  ros::Publisher publisher;", "  int count = 0;", "};"]
    name = program.variable(kind, "output")
    program.setup.append(f"{name}.publisher = {advertise(program, topic)};")
    return Publisher(f"{name}.publisher.", topic), as_it_is


def in_base_class(program, topic):
    if not program.is_class:
        return member(program, topic)
    kind = program.unique("Base")
    program.prelude += [f"class {kind} {{", " public:", f"  explicit {kind}(ros::NodeHandle& nh) {{",
                        f"    out_ = {advertise(program, topic)};", "  }", " protected:",
                        "  ros::Publisher out_;", "};"]
    derived = program.unique("Derived")
    program.prelude += [f"class {derived} : public {kind} {{", " public:",
                        f"  explicit {derived}(ros::NodeHandle& nh) : {kind}(nh) {{}}",
                        f"  void send(const {topic.message.cpp}& msg) {{ out_.publish(msg); }}", "};"]
    name = program.variable(f"boost::shared_ptr<{derived}>", "sender")
    program.setup.append(f"{name}.reset(new {derived}(nh));")
    return BySender(f"{name}->", topic), as_it_is


class BySender(Publisher):
    """Publishes through a function of the package that takes the message by reference."""

    asks = False

    def publish(self, argument, pointer=False):
        value = f"*{argument}" if pointer else argument
        return [f"{self.call}send({value});", f'fuzz::sent("{self.topic.name}");']


def local(program, topic):
    program.traits.append("local publisher")

    def wrap(lines):
        inner = ["[&] {"] + ["  " +
                             line for line in lines] + ["}();"] if any("return;" in line for line in lines) else lines
        return in_block(["ros::NodeHandle nh;", f"ros::Publisher out = {advertise(program, topic, 0)};",
                         f'fuzz::wait("{topic.name}");'] + inner + [f'fuzz::drain("{topic.name}");'])

    return Publisher("out.", topic), wrap


def parameter(program, topic):
    stored, _ = member(program, topic)
    kind, argument, call = program.rng.choice([("ros::Publisher& out", "{}", "out."),
                                               ("const ros::Publisher& out", "{}", "out."),
                                               ("ros::Publisher out", "{}", "out."), ("ros::Publisher* out", "&{}",
                                                                                      "out->")])

    def wrap(lines):
        name = program.helper("void", "send", f"{kind}, int k", lines)
        return [f"{name}({argument.format(stored.call[:-1])}, k);"]

    return Publisher(call, topic), wrap


class Asked(Publisher):
    """One that is not always there."""

    asks = False

    def __init__(self, condition, call, topic):
        super().__init__(call, topic)
        self.condition = condition

    def publish(self, argument, pointer=False):
        return [f"if ({self.condition}) {{"] + ["  " + line for line in super().publish(argument, pointer)] + ["}"]


SHARED = "boost::shared_ptr<ros::Publisher>"


def perhaps_missing(program, topic):
    """The same function is called with a publisher and without one."""
    home, parameter_type, argument, nothing, condition, call = program.rng.choice([
        (by_shared_pointer, f"const {SHARED}& out", "{}", f"{SHARED}()", "out", "out->"),
        (member, "ros::Publisher* out", "&{}", "nullptr", "out != nullptr", "out->"),
        (in_vector, "std::vector<ros::Publisher>& outs", "{}", "none", "!outs.empty()",
         program.rng.choice(["outs[0].", "outs.at(0).", "outs.front().", "outs.back()."]))])
    stored, _ = home(program, topic)

    def wrap(lines):
        name = program.helper("void", "send", f"{parameter_type}, int k", lines)
        there = argument.format(stored.call.rstrip("->.").replace("[0]", ""))
        empty = ["std::vector<ros::Publisher> none;"] if nothing == "none" else []
        return empty + [f"{name}({there}, k);", f"{name}({nothing}, k);"]

    return Asked(condition, call, topic), wrap


def in_lambda(program, topic):
    stored, _ = member(program, topic)

    def wrap(lines):
        name = program.unique("send")
        return [f"auto {name} = [&](int k) {{"] + ["  " + line for line in lines] + ["};", f"{name}(k);"]

    return stored, wrap


def returned(program, topic):
    """The publisher comes from a function of the program."""
    name = program.variable("ros::Publisher", "pub")
    maker = program.helper("ros::Publisher", "open", "ros::NodeHandle& nh", [f"return {advertise(program, topic)};"])
    program.setup.append(f"{name} = {maker}(nh);")
    return Publisher(f"{name}.", topic), as_it_is


def by_options(program, topic):
    name = program.variable("ros::Publisher", "pub")
    program.setup += in_block(["ros::AdvertiseOptions options;",
                               f'options.init<{topic.message.cpp}>("{topic.name}", 50);',
                               f"{name} = nh.advertise(options);"])
    return Publisher(f"{name}.", topic), as_it_is


def with_status_callback(program, topic):
    name = program.variable("ros::Publisher", "pub")
    status = program.helper("void", "connected", "const ros::SingleSubscriberPublisher& subscriber",
                            ["(void)subscriber;"])
    bound = f"boost::bind(&Node::{status}, this, boost::placeholders::_1)" if program.is_class else status
    program.setup += in_block([f"ros::SubscriberStatusCallback callback = {bound};",
                               f'{name} = nh.advertise<{topic.message.cpp}>("{topic.name}", 50, callback);'])
    return Publisher(f"{name}.", topic), as_it_is


def in_library_object(program, topic):
    """A class of another package advertises, and has the publisher, which stays roscpp's."""
    name = program.variable("fuzz::Outlet", "outlet")
    program.setup.append(f'{name}.open<{topic.message.cpp}>(nh, "{topic.name}");')
    return Publisher(f"{name}.out.", topic), as_it_is


def object_of(call):
    return f"*{call[:-2]}" if call.endswith("->") else call[:-1]


def given_to_library(program, topic):
    """So it stays roscpp's, and the program publishes with it."""
    publisher, wrap = program.rng.choice([member, in_vector, by_shared_pointer, in_struct])(program, topic)
    program.setup.append(f"fuzz::borrow({object_of(publisher.call)});")
    return publisher, wrap


class ByLibrary(Publisher):

    def publish(self, argument, pointer=False):
        value = f"*{argument}" if pointer else argument
        return [f"fuzz::publish_for({object_of(self.call)}, {value});", f'fuzz::sent("{self.topic.name}");']


def published_by_library(program, topic):
    publisher, wrap = program.rng.choice([member, by_shared_pointer])(program, topic)
    return ByLibrary(publisher.call, topic), wrap


def in_any(program, topic):
    program.includes.add("any")
    name = program.variable("std::any", "pub")
    program.setup.append(f"{name} = {advertise(program, topic)};")
    return Publisher(f"std::any_cast<ros::Publisher&>({name}).", topic), as_it_is


HOMES = {member: 8, initialized_member: 3, in_vector: 1, in_map: 1, in_array: 1, by_shared_pointer: 2, in_struct: 1,
         in_base_class: 1, local: 1, parameter: 3, perhaps_missing: 2, in_lambda: 1, returned: 1, by_options: 1,
         with_status_callback: 1, in_library_object: 1, given_to_library: 3, published_by_library: 1, in_any: 1}


def choose(program, topic, without=()):
    homes = [home for home in HOMES if home not in without]
    home = program.rng.choices(homes, [HOMES[one] for one in homes])[0]
    program.traits.append(home.__name__)
    return home(program, topic)
