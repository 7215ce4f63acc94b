# SPDX-License-Identifier: BSD-3-Clause
"""Adversarial programs: who points into a message's data, how that is stored, and when it is used, composed with
publishing. What is written through an old pointer after a publish shows in the next message, which must be the same
before and after the port."""
from . import messages, publishers, subscribers
from .publishers import in_block

COUNT = 20
PLAIN = [message for message in messages.ALL if not message.arrays[0][1].fields and "." not in message.arrays[0][0]]


class Handle:
    """Statements that make a handle to the first element, and how an element is written through it."""

    def __init__(self, lines, target=None, call=None):
        self.lines, self.target, self.call = lines, target, call

    def write(self, index, value):
        if self.call:
            return [self.call.format(index=index, value=value)]
        return [f"{self.target.format(index=index)} = {value};"]


# Expressions for the address of the first element
# ----------------------------------------------------------------------------------------------------------------------


def reference(program, message, access, element):
    array = f"{access}{message.arrays[0][0]}"
    forms = [f"&{array}[0]", f"{array}.data()", f"&*{array}.begin()", f"&{array}.front()", f"(&{array}[3] - 3)",
             f"std::addressof({array}[0])", f"+&{array}[0]", f"(k % 2 ? &{array}[0] : {array}.data())",
             f"&*std::max_element({array}.begin(), {array}.begin() + 1)"]
    if access.endswith(".") and program.rng.random() < 0.15:
        maker = program.helper(f"{element}*", "first", f"{message.cpp}& msg",
                               [f"return &msg.{message.arrays[0][0]}[0];"], pure=True)
        return f"{maker}({access[:-1]})"
    return program.rng.choice(forms)


# Ways to store it
# ----------------------------------------------------------------------------------------------------------------------


def pointer(program, element, source, array):
    return Handle([f"{element}* h = {source};"], "h[{index}]")


def second_pointer(program, element, source, array):
    return Handle([f"{element}* h0 = {source};", f"{element}* h = h0 + 1;"], "h[{index} - 1]")


def element_reference(program, element, source, array):
    return Handle([f"{element}& h = *({source});"], "(&h)[{index}]")


def iterator(program, element, source, array):
    return Handle([f"auto h = {array}.begin();"], "h[{index}]")


def array_reference(program, element, source, array):
    return Handle([f"auto& h = {array};"], "h[{index}]")


def aggregate(program, element, source, array):
    kind = program.unique("Box")
    program.prelude += [f"struct {kind} {{", f"  {element}* p;", "};"]
    return Handle([f"{kind} h{{{source}}};"], "h.p[{index}]")


def in_vector(program, element, source, array):
    return Handle([f"std::vector<{element}*> h(1, {source});"], "h[0][{index}]")


def in_map(program, element, source, array):
    return Handle([f"std::map<int, {element}*> h;", f"h[0] = {source};"], "h[0][{index}]")


def in_pair(program, element, source, array):
    return Handle([f"auto h = std::make_pair(static_cast<{element}*>({source}), 1);"], "h.first[{index}]")


def in_closure(program, element, source, array):
    return Handle([f"{element}* h0 = {source};", f"auto h = [h0](int i, {element} v) {{ h0[i] = v; }};"],
                  call="h({index}, {value});")


def in_function(program, element, source, array):
    return Handle([f"{element}* h0 = {source};",
                   f"boost::function<void(int, {element})> h = [h0](int i, {element} v) {{ h0[i] = v; }};"],
                  call="h({index}, {value});")


def closure_over_message(program, element, source, array):
    return Handle([f"auto h = [&](int i, {element} v) {{ {array}[i] = v; }};"], call="h({index}, {value});")


def in_class(program, element, source, array):
    kind = program.unique("Writer")
    program.prelude += [f"class {kind} {{", " public:", f"  explicit {kind}({element}* p) : p_(p) {{}}",
                        f"  void set(int i, {element} v) {{ p_[i] = v; }}", " private:", f"  {element}* p_;", "};"]
    return Handle([f"{kind} h({source});"], call="h.set({index}, {value});")


def smart_pointer(program, element, source, array):
    return Handle([f"boost::shared_ptr<{element}> h({source}, [](void*) {{}});"], "h.get()[{index}]")


def as_integer(program, element, source, array):
    return Handle([f"std::uintptr_t h = reinterpret_cast<std::uintptr_t>({source});"],
                  f"reinterpret_cast<{element}*>(h)[{{index}}]")


def as_void(program, element, source, array):
    return Handle([f"void* h = {source};"], f"static_cast<{element}*>(h)[{{index}}]")


def as_bytes(program, element, source, array):
    return Handle([f"unsigned char* h = reinterpret_cast<unsigned char*>({source});"], "h[{index}]")


def in_variable(program, element, source, array):
    kept = program.variable(f"{element}*", "kept", " = nullptr")
    return Handle([f"{kept} = {source};"], f"{kept}[{{index}}]")


def const_cast(program, element, source, array):
    return Handle([f"const {element}* h = {source};"], f"const_cast<{element}*>(h)[{{index}}]")


def const_access(program, element, source, array):
    pointer = "->" in array
    message, field = array.split("->" if pointer else ".", 1)
    message = "*" + message if pointer else message
    return Handle([f"const auto& read_only = {message};", f"const {element}* h = read_only.{field}.data();"],
                  f"const_cast<{element}*>(h)[{{index}}]")


def kept_by_algorithm(program, element, source, array):
    pair = f"std::pair<int, {element}>"
    return Handle([f"{element}* h0 = {source};", f"std::vector<{pair}> none;",
                   f"auto h = std::for_each(none.begin(), none.end(), [h0](const {pair}& p) {{ h0[p.first] = p.second; }});"],
                  call=f"h({pair}({{index}}, {{value}}));")


def by_function(program, element, source, array):
    name = program.unique("write")
    program.prelude += [f"inline void {name}({element}* p, int i, {element} v) {{ p[i] = v; }}"]
    return Handle([f"{element}* h = {source};"], call=f"{name}(h, {{index}}, {{value}});")


STORES = [pointer, second_pointer, element_reference, iterator, array_reference, aggregate, in_vector, in_map, in_pair,
          in_closure, in_function, closure_over_message, in_class, smart_pointer, as_integer, as_void, as_bytes, in_variable,
          by_function, const_cast, const_access, kept_by_algorithm]


# Who owns the message
# ----------------------------------------------------------------------------------------------------------------------


def local(program, message):
    return [f"{message.cpp} msg;"], "msg.", "msg", False


def shared(program, message):
    return [f"{message.cpp}Ptr msg(new {message.cpp});"], "msg->", "msg", True


def kept(program, message):
    name = program.variable(message.cpp, "frame")
    return [], f"{name}.", name, False


def static(program, message):
    return [f"static {message.cpp} msg;"], "msg.", "msg", False


def second_name(program, message):
    return [f"{message.cpp} msg;", f"{message.cpp}& same = msg;"], "same.", "msg", False


OWNERS = [local, shared, kept, static, second_name]


# When it is used
# ----------------------------------------------------------------------------------------------------------------------


def before(handle, publish, value):
    return handle.lines + handle.write(1, value) + publish


def after(handle, publish, value):
    return handle.lines + publish + handle.write(1, value) + publish


def between(handle, publish, value):
    return publish + handle.lines + handle.write(2, value) + publish


def before_and_after(handle, publish, value):
    return handle.lines + handle.write(1, value) + publish + handle.write(2, value) + publish


def in_loop(handle, publish, value):
    body = handle.write("(1 + turn)", value) + publish
    return handle.lines + ["for (int turn = 0; turn < 2; ++turn) {"] + ["  " + line for line in body] + ["}"]


def made_in_loop(handle, publish, value):
    body = handle.lines + handle.write("(1 + turn)", value) + publish
    return ["for (int turn = 0; turn < 2; ++turn) {"] + ["  " + line for line in body] + ["}"]


def ends_in_block(handle, publish, value):
    return ["{"] + ["  " + line for line in handle.lines + handle.write(1, value)] + ["}"] + publish


def through_closure(handle, publish, value):
    send = ["auto send = [&] {"] + ["  " + line for line in publish] + ["};"]
    return send + handle.lines + ["send();"] + handle.write(1, value) + ["send();"]


TIMES = [before, after, between, before_and_after, in_loop, made_in_loop, ends_in_block, through_closure]


def attack(program):
    """One publisher whose message is pointed into."""
    message = program.rng.choice(PLAIN)
    field, element = message.arrays[0]
    publisher = publishers.member(program, program.topic(message))[0]
    owner, store, time = (program.rng.choice(some) for some in (OWNERS, STORES, TIMES))
    lines, access, argument, is_pointer = owner(program, message)
    array = f"{access}{field}"
    source = reference(program, message, access, element.cpp)
    handle = store(program, element.cpp, source, array)
    lines = lines + message.set_meta(access) + [f"{array}.resize({COUNT});", f"for (int i = 0; i < {COUNT}; ++i) {{",
                                               f"  {element.put(array + '[i]')}", "}"]
    value = element.value("3") if store is not as_bytes else "static_cast<unsigned char>(fuzz::value(3, k))"
    lines += time(handle, publisher.publish(argument, is_pointer), value)
    program.traits += [f"owner: {owner.__name__}", f"store: {store.__name__}", f"time: {time.__name__}"]
    program.steps += in_block(lines)


def make(program):
    for _ in range(program.rng.choice([2, 3])):
        attack(program)
    for topic in program.topics:
        subscribers.listen(program, topic)
    return program
