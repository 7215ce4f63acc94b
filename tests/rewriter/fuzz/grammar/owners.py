# SPDX-License-Identifier: BSD-3-Clause
"""Who owns the message that is pointed into, and what takes its elements over before they are published."""


class Owned:
    """Statements that make a message, how its fields are reached, and what publish is given."""

    def __init__(self, lines, access, argument, pointer=False):
        self.lines, self.access, self.argument, self.pointer = lines, access, argument, pointer

    @property
    def value(self):
        return f"*{self.argument}" if self.pointer else self.argument


# Owners
# ----------------------------------------------------------------------------------------------------------------------


def local(program, message):
    return Owned([f"{message.cpp} msg;"], "msg.", "msg")


def shared(program, message):
    return Owned([f"{message.cpp}Ptr msg(new {message.cpp});"], "msg->", "msg", True)


def kept(program, message):
    name = program.variable(message.cpp, "frame")
    return Owned([], f"{name}.", name)


def static(program, message):
    return Owned([f"static {message.cpp} msg;"], "msg.", "msg")


def second_name(program, message):
    return Owned([f"{message.cpp} msg;", f"{message.cpp}& same = msg;"], "same.", "msg")


def second_shared_pointer(program, message):
    return Owned([f"{message.cpp}Ptr msg = boost::make_shared<{message.cpp}>();", f"{message.cpp}Ptr same = msg;"],
                 "same->", "msg", True)


def raw_pointer_to_local(program, message):
    return Owned([f"{message.cpp} msg;", f"{message.cpp}* same = &msg;"], "same->", "msg")


# Names whose type the compiler deduces: nothing but the analysis ties them to the message.


def deduced_name(program, message):
    return Owned([f"{message.cpp} msg;", f"auto{program.rng.choice(['&', '&&'])} same = msg;"], "same.", "msg")


def value_of_assignment(program, message):
    """Of a pointer's own operator, and of the language's."""
    if program.rng.random() < 0.5:
        return Owned([f"{message.cpp}Ptr msg;", f"auto same = (msg = boost::make_shared<{message.cpp}>());"], "same->",
                     "msg", True)
    ways = [["auto& same = *(at = &msg);", "auto* const access = &same;"], ["auto* access = (at = &msg);"],
            ["auto* access = at;", "access = at = &msg;"]]
    return Owned([f"{message.cpp} msg;", f"{message.cpp}* at = nullptr;"] + program.rng.choice(ways), "access->", "*at")


def stepped_pointer(program, message):
    return Owned([f"{message.cpp} both[2];", f"{message.cpp}* at = both;",
                  f"auto* same = {program.rng.choice(['(at += 1)', '++at', '(k, 1 + at++)'])};"], "same->", "both[1]")


def value_of_statements(program, message):
    return Owned([f"{message.cpp} msg;", f"auto* same = ({{ {message.cpp}* at = &msg; at; }});"], "same->", "msg")


def cast_pointer(program, message):
    made = f"{message.cpp}Ptr(new {message.cpp})"
    lines = program.rng.choice([[f"{message.cpp}Ptr msg;", f"msg = {made};"], [f"auto msg = {made};"]])
    return Owned(lines, "msg->", "msg", True)


def unique_pointer(program, message):
    return Owned([f"std::unique_ptr<{message.cpp}> msg(new {message.cpp});"], "msg->", "*msg")


def optional(program, message):
    return Owned([f"std::optional<{message.cpp}> msg;", "msg.emplace();"], "msg->", "*msg")


def kept_pointer(program, message):
    name = program.variable(f"{message.cpp}Ptr", "frame")
    return Owned([f"{name}.reset(new {message.cpp});"], f"{name}->", name, True)


def kept_pointer_made_once(program, message):
    name = program.variable(f"{message.cpp}Ptr", "frame")
    program.setup.append(f"{name} = boost::make_shared<{message.cpp}>();")
    return Owned([], f"{name}->", name, True)


def in_struct(program, message):
    kind = program.unique("Frame")
    program.prelude += [f"struct {kind} {{", f"  {message.cpp} message;", "  int count = 0;", "};"]
    name = program.variable(kind, "frame")
    return Owned([], f"{name}.message.", f"{name}.message")


def in_container(program, message):
    name = program.variable(f"std::vector<{message.cpp}>", "frames")
    program.setup.append(f"{name}.resize(2);")
    return Owned([f"{message.cpp}& msg = {name}[k % 2];"], "msg.", "msg")


def in_map(program, message):
    name = program.variable(f"std::map<std::string, {message.cpp}>", "frames")
    return Owned([], f'{name}["one"].', f'{name}["one"]')


def in_array(program, message):
    return Owned([f"{message.cpp} both[2];", f"{message.cpp}& msg = both[k % 2];"], "msg.", "msg")


def one_of_two(program, message):
    return Owned([f"{message.cpp} one;", f"{message.cpp} other;", f"{message.cpp}& msg = k % 2 ? one : other;"], "msg.",
                 "msg")


def behind_accessor(program, message):
    kind = program.unique("Holder")
    program.prelude += [f"class {kind} {{", " public:", f"  {message.cpp}& message() {{ return message_; }}", " private:",
                        f"  {message.cpp} message_;", "};"]
    name = program.variable(kind, "holder")
    return Owned([], f"{name}.message().", f"{name}.message()")


def from_factory(program, message):
    maker = program.helper(message.cpp, "make", "", [f"{message.cpp} msg;"] + ["return msg;"], pure=True)
    return Owned([f"{message.cpp} msg = {maker}();"], "msg.", "msg")


def from_shared_factory(program, message):
    maker = program.helper(f"{message.cpp}Ptr", "make", "", [f"return boost::make_shared<{message.cpp}>();"], pure=True)
    return Owned([f"{message.cpp}Ptr msg = {maker}();"], "msg->", "msg", True)


LASTING = [kept, static, kept_pointer_made_once, in_struct, in_map, behind_accessor]
DEDUCED = [deduced_name, value_of_assignment, stepped_pointer, value_of_statements, cast_pointer]
FRESH = [local, shared, second_name, raw_pointer_to_local, from_factory, from_shared_factory] + DEDUCED
OWNERS = [local, shared, kept, static, second_name, second_shared_pointer, raw_pointer_to_local, unique_pointer,
          optional, kept_pointer, kept_pointer_made_once, in_struct, in_container, in_map, in_array, one_of_two,
          behind_accessor, from_factory, from_shared_factory] + DEDUCED


# What takes the elements over, after a handle to them was made. Each returns statements and the new owner.
# ----------------------------------------------------------------------------------------------------------------------


def unchanged(message, owned):
    return [], owned


def by_move(message, owned):
    return [f"{message.cpp} next = std::move({owned.value});"], Owned([], "next.", "next")


def by_move_assignment(message, owned):
    return [f"{message.cpp} next;", f"next = std::move({owned.value});"], Owned([], "next.", "next")


def by_swap(message, owned):
    return [f"{message.cpp} next;", f"std::swap(next, {owned.value});"], Owned([], "next.", "next")


def by_exchange(message, owned):
    return ([f"{message.cpp} next = std::exchange({owned.value}, {message.cpp}());"], Owned([], "next.", "next"))


def by_moved_array(message, owned):
    field = message.arrays[0][0]
    return ([f"{message.cpp} next;"] + message.set_meta("next.") +
            [f"next.{field} = std::move({owned.access}{field});"], Owned([], "next.", "next"))


def by_swapped_array(message, owned):
    field = message.arrays[0][0]
    return ([f"{message.cpp} next;"] + message.set_meta("next.") + [f"next.{field}.swap({owned.access}{field});"],
            Owned([], "next.", "next"))


def by_copy(message, owned):
    return [f"{message.cpp} next = {owned.value};"], Owned([], "next.", "next")


def by_new_message(message, owned):
    return ([f"{message.cpp}Ptr next(new {message.cpp}(std::move({owned.value})));"], Owned([], "next->", "next", True))


def by_second_pointer(message, owned):
    if not owned.pointer:
        return by_move(message, owned)
    return [f"{message.cpp}Ptr next = {owned.argument};"], Owned([], "next->", "next", True)


def by_swapped_pointer(message, owned):
    if not owned.pointer:
        return by_swap(message, owned)
    # An owner that is made once is there in the next step, too, and has to point to a message then.
    made = "" if owned.lines else f" = boost::make_shared<{message.cpp}>()"
    return ([f"{message.cpp}Ptr next{made};", f"next.swap({owned.argument});"], Owned([], "next->", "next", True))


TRANSFERS = [by_move, by_move_assignment, by_swap, by_exchange, by_moved_array, by_swapped_array, by_copy,
             by_new_message, by_second_pointer, by_swapped_pointer]
