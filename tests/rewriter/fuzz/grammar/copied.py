# SPDX-License-Identifier: BSD-3-Clause
"""Outputs that publish a copy of the message, which has elements of its own until something has published it; and calls of publish that are
written in other ways."""
from . import publishers
from .fills import in_block
from .outputs import Output, stored, value_of


def in_parameter(program, message):
    publisher = stored(program, message)

    def send(argument, pointer=False):
        name = program.helper("void", "send", f"{message.cpp} msg", publisher.publish("msg"))
        return [f"{name}({value_of(argument, pointer)});"]

    return Output(send)


def in_queue(program, message):
    publisher = stored(program, message)
    queue = program.variable(f"std::deque<{message.cpp}>", "queue")
    put, first, out = program.rng.choice([("push_back", "front", "pop_front"), ("push_front", "back", "pop_back"),
                                          ("emplace_back", "front", "pop_front")])
    return Output(lambda argument, pointer=False: [f"{queue}.{put}({value_of(argument, pointer)});",
                                                   *publisher.publish(f"{queue}.{first}()"), f"{queue}.{out}();"])


def in_optional(program, message):
    publisher = stored(program, message)
    latest = program.variable(f"std::optional<{message.cpp}>", "latest")
    end = program.rng.choice([[f"{latest}.reset();"], []])
    return Output(lambda argument, pointer=False: [f"{latest} = {value_of(argument, pointer)};",
                                                   *publisher.publish(f"*{latest}"), *end])


def in_result(program, message):
    publisher = stored(program, message)

    def send(argument, pointer=False):
        kind = f"const {message.cpp}{'Ptr' if pointer else ''}& msg"
        name = program.helper(message.cpp, "copy", kind, [f"return {value_of('msg', pointer)};"], pure=True)
        return publisher.publish(f"{name}({argument})")

    return Output(send)


def in_member(program, message):
    publisher = stored(program, message)
    latest = program.variable(message.cpp, "latest")
    return Output(lambda argument, pointer=False: [f"{latest} = {value_of(argument, pointer)};",
                                                   *publisher.publish(latest)])


def plain(program, message):
    """A ros::Publisher, whatever else the program may have."""
    homes = [publishers.member, publishers.initialized_member, publishers.in_struct, publishers.by_shared_pointer, publishers.in_vector]
    return program.rng.choice(homes)(program, program.topic(message))[0]


def by_choice(program, message):
    """(k % 2 ? left : right).publish(msg)"""
    both = [plain(program, message), plain(program, message)]
    left, right = [one.call[:-1] if one.call.endswith(".") else f"*{one.call[:-2]}" for one in both]
    return Output(lambda argument, pointer=False: [
        f"(k % 2 ? {left} : {right}).publish({value_of(argument, pointer)});",
        f'fuzz::sent(k % 2 ? "{both[0].topic.name}" : "{both[1].topic.name}");'])


def with_its_type(program, message):
    """publish<Type>(msg)"""
    publisher = plain(program, message)
    return Output(lambda argument, pointer=False: [
        f"{publisher.call}publish<{message.cpp}>({value_of(argument, pointer)});", f'fuzz::sent("{publisher.topic.name}");'])


def in_closure_parameter(program, message):
    publisher = stored(program, message)
    return Output(lambda argument, pointer=False: in_block(
        [f"const auto send = [&]({message.cpp} copy) {{", *publisher.publish("copy"), "};",
         f"send({value_of(argument, pointer)});"]))


def in_closure_result(program, message):
    publisher = stored(program, message)
    return Output(lambda argument, pointer=False: in_block(
        [f"const auto copy = [&] {{ return {value_of(argument, pointer)}; }};", *publisher.publish("copy()")]))


def in_call_operator(program, message):
    publisher = stored(program, message)
    kind = program.unique("Copy")
    program.prelude += [f"struct {kind} {{", f"  const {message.cpp}& original;",
                        f"  {message.cpp} operator()() const {{ return original; }}", "};"]
    return Output(lambda argument, pointer=False: publisher.publish(f"{kind}{{{value_of(argument, pointer)}}}()"))


def in_pair(program, message):
    """What a structured binding takes apart."""
    publisher = stored(program, message)

    def send(argument, pointer=False):
        pair = f"std::pair<{message.cpp}, int>"
        name = program.helper(pair, "both", f"const {message.cpp}& msg", ["return {msg, 1};"], pure=True)
        return in_block([f"auto [copy, number] = {name}({value_of(argument, pointer)});", "(void)number;",
                         *publisher.publish("copy")])

    return Output(send)


def in_handler_of_call(program, message):
    """A handler copies; what throws is called."""
    publisher = stored(program, message)
    fail = program.helper("void", "fail", "int k", ["if (k >= 0) throw k;"])
    return Output(lambda argument, pointer=False: [
        "try {", f"  {fail}(k);", "} catch (int) {", f"  {message.cpp} copy = {value_of(argument, pointer)};",
        *publisher.publish("copy"), "}"])


WAYS = [in_parameter, in_queue, in_optional, in_result, in_member, by_choice, with_its_type, in_closure_parameter, in_closure_result,
        in_call_operator, in_pair, in_handler_of_call]
