# SPDX-License-Identifier: BSD-3-Clause
"""How a message is made and published. Each builder is given the program, the message type and the publisher, and
returns the statements of one step."""
from .fills import change, fill, in_block


def contents(program, message, access):
    return message.set_meta(access) + fill(program.rng, message, access, program.rng.randrange(1, 90))


def send(program, message, publisher, argument, access, pointer=False):
    """Publishes once, twice, changed in between, guarded."""
    once = publisher.publish(argument, pointer)
    again = program.rng.random()
    if again < 0.55:
        return once
    if again < 0.65:
        program.traits.append("published twice")
        return once + once
    if again < 0.9:
        program.traits.append("published, changed, published")
        return once + in_block(change(program.rng, message, access)) + once
    program.traits.append("changed after publishing")
    return once + in_block(change(program.rng, message, access))


def local(program, message, publisher):
    return [f"{message.cpp} msg;"] + contents(program, message, "msg.") + send(program, message, publisher, "msg",
                                                                               "msg.")


def local_in_loop(program, message, publisher):
    body = [f"{message.cpp} msg;"] + contents(program, message, "msg.") + publisher.publish("msg")
    return ["for (int turn = 0; turn < 2; ++turn) {"] + ["  " + line for line in body] + ["}"]


def local_outside_loop(program, message, publisher):
    body = contents(program, message, "msg.") + publisher.publish("msg")
    return [f"{message.cpp} msg;", "for (int turn = 0; turn < 2; ++turn) {"] + ["  " + line for line in body] + ["}"]


def shared_pointer(program, message, publisher):
    cpp = message.cpp
    made = program.rng.choice([f"{cpp}Ptr msg = boost::make_shared<{cpp}>();", f"{cpp}Ptr msg(new {cpp});",
                               f"auto msg = boost::make_shared<{cpp}>();",
                                f"boost::shared_ptr<{cpp}> msg(new {cpp}());",
                               f"{cpp}::Ptr msg(new {cpp}());"])
    lines = [made] + contents(program, message, "msg->")
    if program.rng.random() < 0.15:
        return lines + send(program, message, publisher, "*msg", "msg->")
    return lines + send(program, message, publisher, "msg", "msg->", True)


def kept_pointer(program, message, publisher):
    name = program.variable(f"{message.cpp}Ptr", "frame")
    made = program.rng.choice([f"{name} = boost::make_shared<{message.cpp}>();", f"{name}.reset(new {message.cpp});"])
    return [made] + contents(program, message, f"{name}->") + publisher.publish(name, True)


def reused(program, message, publisher):
    name = program.variable(message.cpp, "frame")
    return contents(program, message, f"{name}.") + send(program, message, publisher, name, f"{name}.")


def reused_and_set_up(program, message, publisher):
    """Fields and array are set once; every step changes some elements."""
    name = program.variable(message.cpp, "frame")
    field, element = message.arrays[0]
    program.setup += ["{", "  const int k = 3;"] + ["  " + line for line in contents(program, message, f"{name}.")]
    program.setup += [f"  {name}.{field}.resize(20);", "}"]
    return [element.put(f"{name}.{field}[k]", "k")] + publisher.publish(name)


def filled_elsewhere(program, message, publisher):
    name = program.variable(message.cpp, "frame")
    filler = program.helper("void", "fill", "int k", contents(program, message, f"{name}."))
    return [f"{filler}(k);"] + send(program, message, publisher, name, f"{name}.")


def static_local(program, message, publisher):
    return [f"static {message.cpp} msg;"] + contents(program, message, "msg.") + publisher.publish("msg")


def out_parameter(program, message, publisher):
    filler = program.helper("void", "fill", f"{message.cpp}& msg, int k", contents(program, message, "msg."), pure=True)
    return [f"{message.cpp} msg;", f"{filler}(msg, k);"] + send(program, message, publisher, "msg", "msg.")


def pointer_parameter(program, message, publisher):
    filler = program.helper("void", "fill", f"{message.cpp}* msg, int k", contents(program, message, "msg->"),
                            pure=True)
    return [f"{message.cpp} msg;", f"{filler}(&msg, k);"] + publisher.publish("msg")


def shared_parameter(program, message, publisher):
    filler = program.helper("void", "fill", f"const {message.cpp}Ptr& msg, int k", contents(program, message, "msg->"),
                            pure=True)
    return [f"{message.cpp}Ptr msg(new {message.cpp});", f"{filler}(msg, k);"] + publisher.publish("msg", True)


def result(program, message, publisher):
    body = [f"{message.cpp} msg;"] + contents(program, message, "msg.") + ["return msg;"]
    maker = program.helper(message.cpp, "make", "int k", body, pure=True)
    if program.rng.random() < 0.4:
        return publisher.publish(f"{maker}(k)")
    return [f"{message.cpp} msg = {maker}(k);"] + send(program, message, publisher, "msg", "msg.")


def shared_result(program, message, publisher):
    body = [f"{message.cpp}Ptr msg(new {message.cpp});"] + contents(program, message, "msg->") + ["return msg;"]
    maker = program.helper(f"{message.cpp}Ptr", "make", "int k", body, pure=True)
    if program.rng.random() < 0.4:
        return publisher.publish(f"{maker}(k)", True)
    return [f"{message.cpp}Ptr msg = {maker}(k);"] + publisher.publish("msg", True)


def copied_from_member(program, message, publisher):
    name = program.variable(message.cpp, "pattern")
    program.setup += ["{", "  const int k = 2;"] + ["  " + line for line in contents(program, message,
                                                                                     f"{name}.")] + ["}"]
    return [f"{message.cpp} msg = {name};"] + in_block(change(program.rng, message, "msg.")) + publisher.publish("msg")


def in_container(program, message, publisher):
    name = program.variable(f"std::vector<{message.cpp}>", "frames")
    program.setup.append(f"{name}.resize(2);")
    return [f"{message.cpp}& msg = {name}[k % 2];"] + contents(program, message, "msg.") + publisher.publish("msg")


def part_of_struct(program, message, publisher):
    kind = program.unique("Frame")
    program.prelude += [f"struct {kind} {{", f"  {message.cpp} message;", "  int count = 0;", "};"]
    name = program.variable(kind, "frame")
    return contents(program, message, f"{name}.message.") + publisher.publish(f"{name}.message")


def raw_pointer(program, message, publisher):
    return ([f"{message.cpp}* msg = new {message.cpp};"] + contents(program, message, "msg->") +
            publisher.publish("*msg") +
            ["delete msg;"])


def alias(program, message, publisher):
    return [f"{message.cpp} msg;", f"{message.cpp}& same = msg;"] + contents(program, message,
                                                                             "same.") + publisher.publish("msg")


def without_arrays(program, message, publisher):
    return [f"{message.cpp} msg;"] + message.set_meta("msg.") + publisher.publish("msg")


def template_function(program, message, publisher):
    name = program.unique("stamp")
    program.prelude += ["template <class M>", f"void {name}(M& message, int k) {{"]
    program.prelude += ["  " + line for line in message.set_meta("message.")] + ["}"]
    lines = fill(program.rng, message, "msg.", program.rng.randrange(1, 90))
    return [f"{message.cpp} msg;", f"{name}(msg, k);"] + lines + publisher.publish("msg")


def either_way(program, message, publisher):
    one = contents(program, message, "msg.")
    other = contents(program, message, "msg.")
    return ([f"{message.cpp} msg;", "if (k % 2 == 0) {"] + ["  " + line for line in one] + ["} else {"] +
            ["  " + line for line in other] + ["}"] + publisher.publish("msg"))


def early_return(program, message, publisher):
    lines = local(program, message, publisher)
    return [lines[0], "if (k == 1) return;"] + lines[1:]


WAYS = {local: 8, local_in_loop: 2, local_outside_loop: 2, shared_pointer: 8, kept_pointer: 2, reused: 6,
        reused_and_set_up: 2,
        filled_elsewhere: 3, static_local: 1, out_parameter: 4, pointer_parameter: 1, shared_parameter: 2, result: 3,
        shared_result: 2, copied_from_member: 2, in_container: 1, part_of_struct: 1, raw_pointer: 1, alias: 1,
        without_arrays: 2, template_function: 1, either_way: 2, early_return: 1}


def choose(program, message, publisher):
    way = program.rng.choices(list(WAYS), list(WAYS.values()))[0]
    program.traits.append(way.__name__)
    lines = way(program, message, publisher)
    guard = program.rng.random()
    if guard < 0.1 and publisher.asks and publisher.call != "out.":
        return [f"if ({publisher.call}getNumSubscribers() > 0) {{"] + ["  " + line for line in lines] + ["}"]
    return lines
