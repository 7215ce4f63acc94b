# SPDX-License-Identifier: BSD-3-Clause
"""One generated program: what it declares, does at its start and in each step, and what listens to it. It is written
as a class or as free functions, over one to three files."""


class Topic:
    def __init__(self, name, message, relays=0):
        self.name, self.message, self.relays = name, message, relays
        self.traits = []  # of what publishes on it alone


class Program:
    def __init__(self, rng, index, siblings=False):
        self.rng, self.index = rng, index
        self.siblings = siblings  # pure functions are another package's
        self.name = f"p{index:03d}"
        self.is_class = rng.random() < 0.7
        self.split = rng.random() < 0.6  # a declaration in the header, definitions in two files
        self.topics, self.traits = [], []
        self.includes = {"ros/ros.h"}
        self.prelude, self.state, self.initializers, self.setup = [], [], [], []
        self.helpers, self.steps = [], []
        self.listener_state, self.listener_setup, self.listener_functions = [], [], []
        self._count = 0

    # Building
    # ------------------------------------------------------------------------------------------------------------------

    def unique(self, stem):
        self._count += 1
        return f"{stem}{self._count}"

    def topic(self, message, relays=0):
        self.includes.add(message.include)
        topic = Topic(f"/{self.name}/{self.unique('topic')}", message, relays)
        self.topics.append(topic)
        return topic

    def variable(self, cpp_type, stem, suffix=""):
        """A member or a global; its name."""
        name = self.unique(stem) + "_" if self.is_class else "g_" + self.unique(stem)
        self.state.append(f"{cpp_type} {name}{suffix};")
        return name

    def helper(self, result, stem, parameters, body, pure=False):
        """A function of the program; its name. Pure ones use nothing but their parameters."""
        name = self.unique(stem)
        self.helpers.append((result, name, parameters, body, pure))
        return name

    # Writing
    # ------------------------------------------------------------------------------------------------------------------

    def render(self):
        """(header, first source, second source) without includes."""
        own = [helper for helper in self.helpers if helper not in self._sibling()]
        header, first, second = self._class_form(own) if self.is_class else self._free_form(own)
        listener = self._listener()
        (second if self.split else first).extend(listener)
        return [self._in_namespace(part) for part in (header, first, second)]

    def render_sibling(self):
        """(header, source) of the functions that another package has, without includes; some are in its header alone."""
        header, source = [], []
        for result, name, parameters, body, _ in self._sibling():
            if self.rng.random() < 0.3:
                header += definition("inline " + result, name, parameters, body)
            else:
                header.append(declaration(result, name, parameters))
                source += definition(result, name, parameters, body)
        return [self._in_namespace(part) for part in (header, source)]

    def _sibling(self):
        return [helper for helper in self.helpers if self.siblings and helper[4]]

    def _in_namespace(self, lines):
        return [f"namespace {self.name} {{"] + lines + [f"}}  // namespace {self.name}", ""] if lines else []

    def _class_form(self, helpers):
        header = self.prelude + ["class Node {", " public:", "  explicit Node(ros::NodeHandle& nh);",
                                 "  void step(int k);", "", " private:"]
        header += ["  " + declaration(*helper[:3]) for helper in helpers]
        header += ["  " + line for line in self.state] + ["};"]
        initializers = " : " + ", ".join(self.initializers) if self.initializers else ""
        first = [f"Node::Node(ros::NodeHandle& nh){initializers} {{"] + indented(self.setup) + ["}"]
        first += ["void Node::step(int k) {"] + indented(self.steps) + ["}"]
        second = []
        for result, name, parameters, body, _ in helpers:
            target = second if self.split and self.rng.random() < 0.6 else first
            target += definition(result, f"Node::{name}", parameters, body)
        first += ["boost::shared_ptr<Node> node;", "void start(ros::NodeHandle& nh) { node.reset(new Node(nh)); }",
                  "void step(int k) { node->step(k); }"]
        return (header, first, second) if self.split else ([], header + first, [])

    def _free_form(self, helpers):
        header, first, second = list(self.prelude), list(self.state), []
        for result, name, parameters, body, pure in helpers:
            apart = pure and self.split
            (header if apart else first).append(declaration(result, name, parameters))
            (second if apart else first).extend(definition(result, name, parameters, body))
        setup = [f"{one[:one.index('(')]} = {one[one.index('(') + 1:-1]};" for one in self.initializers]
        first += ["void start(ros::NodeHandle& nh) {"] + indented(setup + self.setup) + ["}"]
        first += ["void step(int k) {"] + indented(self.steps) + ["}"]
        return header, first, second

    def _listener(self):
        lines = ["class Listener {", " public:", "  explicit Listener(ros::NodeHandle& nh);"]
        lines += ["  " + line for line in self.listener_functions] + ["", " private:"]
        lines += ["  " + line for line in self.listener_state] + ["};"]
        lines += ["Listener::Listener(ros::NodeHandle& nh) {"] + indented(self.listener_setup) + ["}"]
        return lines + ["boost::shared_ptr<Listener> listener;",
                        "void listen(ros::NodeHandle& nh) { listener.reset(new Listener(nh)); }"]


def declaration(result, name, parameters):
    return f"{result} {name}({parameters});"


def definition(result, name, parameters, body):
    return [f"{result} {name}({parameters}) {{"] + indented(body) + ["}"]


def indented(lines):
    return ["  " + line if line else line for line in lines]
