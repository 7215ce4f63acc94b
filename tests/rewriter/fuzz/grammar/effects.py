# SPDX-License-Identifier: BSD-3-Clause
"""Messages that are named by an expression which does something: it must not be evaluated once more, nor elsewhere. Each
way is given the use and returns statements."""
from .uses import within


def next_slot(use):
    slots = use.program.variable(use.pointer, "slots", "[3]")
    count = use.program.variable("unsigned", "count", " = 0")
    last = f"{slots}[({count} + 2) % 3]"
    return [f"{slots}[{count}++ % 3] = {use.make()};"] + use.whole_pointer(last)


def next_slot_reset(use):
    slots = use.program.variable(f"std::vector<{use.pointer}>", "slots")
    count = use.program.variable("int", "count", " = -1")
    use.program.setup.append(f"{slots}.resize(2);")
    return [f"{slots}[++{count} % 2].reset(new {use.message.cpp});"] + use.whole_pointer(f"{slots}[{count} % 2]")


twice = "for (int turn = 0; turn < 2; ++turn) {"  # not until the end: an output may leave the publish out


def iterator_that_steps(use):
    kind = use.frame()
    frames = use.program.variable(f"std::vector<{kind}>", "frames")
    use.program.setup.append(f"{frames}.resize(4);")  # an output may publish twice in each turn
    return ([f"auto at = {frames}.begin();"] +
            within(twice, use.fill("at->message.") + use.send("(at++)->message")))


def pointer_that_steps(use):
    frames = use.program.variable(use.message.cpp, "frames", "[4]")
    return ([f"{use.message.cpp}* at = {frames};"] +
            within(twice, use.fill("at->") + use.send("*at++")))


def by_counting_function(use):
    kind = use.frame()
    frames = use.program.variable(kind, "frames", "[2]")
    count = use.program.variable("int", "count", " = 0")
    name = use.program.helper(f"{kind}&", "next", "", [f"return {frames}[{count}++ % 2];"])
    if use.rng.random() < 0.5:
        return [f"{use.message.cpp}& msg = {name}().message;"] + use.whole("msg.", "msg")
    return use.fill_at_once(f"{name}().message.") + use.send(f"{name}().message")


def by_counting_closure(use):
    frames = use.program.variable(f"std::vector<{use.message.cpp}>", "frames")
    use.program.setup.append(f"{frames}.resize(3);")
    return (["std::size_t count = k;", f"auto next = [&]() -> {use.message.cpp}& {{ return {frames}[count++ % 3]; }};"] +
            use.fill_at_once("next().") + use.send("next()"))


def by_static_counter(use):
    name = use.program.unique("next_number")
    use.program.prelude += [f"inline int {name}() {{", "  static int number = 0;", "  return number++;", "}"]
    frames = use.program.variable(use.message.cpp, "frames", "[2]")
    return use.fill_at_once(f"{frames}[{name}() % 2].") + use.send(f"{frames}[{name}() % 2]")


def index_that_is_set(use):
    frames = use.program.variable(use.message.cpp, "frames", "[3]")
    index = use.program.variable("int", "index", " = 2")
    return ([f"{use.message.cpp}& msg = {frames}[{index} = ({index} + 1) % 3];"] + use.fill("msg.") +
            use.send(f"{frames}[{index}]"))


def index_that_changes_in_between(use):
    frames = use.program.variable(use.message.cpp, "frames", "[3]")
    return (["int index = k % 3;"] + use.fill(f"{frames}[index].") + ["index = (index + 1) % 3;"] +
            use.send(f"{frames}[index]"))


def pointer_that_is_set_in_between(use):
    frames = use.program.variable(use.message.cpp, "frames", "[2]")
    return ([f"{use.message.cpp}* msg = &{frames}[k % 2];"] + use.fill("msg->") + [f"msg = &{frames}[(k + 1) % 2];"] +
            use.send("*msg"))


def owner_that_is_set_in_between(use):
    return ([f"{use.pointer} msg = {use.make()};"] + use.fill("msg->") + [f"{use.pointer} first = msg;"] +
            [f"if (k % 2) msg = {use.make()};"] + use.send("msg", True) + use.send("first", True))


def popped(use):
    queue = use.program.variable(f"std::vector<{use.pointer}>", "queue")
    name = use.program.helper(use.pointer, "pop", "", [f"if ({queue}.empty()) return {use.pointer}();",
                                                       f"{use.pointer} last = {queue}.back();",
                                                       f"{queue}.pop_back();", "return last;"])
    return ([f"for (int i = 0; i < k; ++i) {queue}.push_back({use.make()});"] +
            within(f"while ({use.pointer} msg = {name}()) {{", use.whole_pointer("msg")))


def read_from_a_stream(use):
    frames = use.program.variable(use.message.cpp, "frames", "[4]")
    return (['std::istringstream numbers("2 0 3 1");', "int at = 0;"] +
            within("while (numbers >> at) {", use.whole(f"{frames}[at].", f"{frames}[at]")))


def swapped_buffers(use):
    """What is published is what was filled before the swap."""
    front, back = (use.program.variable(use.message.cpp, name) for name in ("front", "back"))
    swap = use.rng.choice([f"std::swap({front}, {back});", f"{front} = std::move({back});", f"{front} = {back};"])
    return use.fill(f"{back}.") + [swap] + use.send(front)


def swapped_owners(use):
    front, back = (use.program.variable(use.pointer, name) for name in ("front", "back"))
    use.program.setup += [f"{name} = {use.make()};" for name in (front, back)]
    return use.fill(f"{back}->") + [f"{front}.swap({back});"] + use.send(front, True)


WAYS = [next_slot, next_slot_reset, iterator_that_steps, pointer_that_steps, by_counting_function, by_counting_closure,
        by_static_counter, index_that_is_set, index_that_changes_in_between, pointer_that_is_set_in_between,
        owner_that_is_set_in_between, popped, read_from_a_stream, swapped_buffers, swapped_owners]
