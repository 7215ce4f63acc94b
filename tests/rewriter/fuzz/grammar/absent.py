# SPDX-License-Identifier: BSD-3-Clause
"""Messages that are not there in every step: what is inserted for the port must stand where the message is. Each way is
given the use and returns statements; whether the message is there depends on the step, k."""
from .uses import within

# Made only now and then
# ----------------------------------------------------------------------------------------------------------------------


def by_conditional_operator(use):
    one = f"{use.pointer} msg = k % 2 ? {use.make()} : {use.pointer}();"
    other = f"{use.pointer} msg = k % 2 ? {use.pointer}() : {use.pointer}(new {use.message.cpp});"
    return [use.rng.choice([one, other])] + within("if (msg) {", use.whole_pointer("msg"))


def in_the_condition(use):
    return [f"{use.pointer} msg;"] + within(f"if (k % 2 && (msg = {use.make()})) {{", use.whole_pointer("msg"))


def behind_and(use):
    return ([f"{use.pointer} msg;", f"const bool made = k > 1 && (msg = {use.make()});"] +
            within("if (made) {", use.whole_pointer("msg")))


def by_conditional_reset(use):
    return ([f"{use.pointer} msg;", f"msg.reset(k % 2 ? new {use.message.cpp} : nullptr);"] +
            within("if (msg) {", use.whole_pointer("msg")))


def in_branch(use):
    made = use.rng.choice([["if (k % 2) msg = MADE;"], ["if (k % 2) {", "  msg = MADE;", "}"],
                           ["if (k % 2)", "  msg = MADE;"], ["if (k == 0) {", "} else msg = MADE;"]])
    return ([f"{use.pointer} msg;"] + [line.replace("MADE", use.make()) for line in made] +
            within("if (msg) {", use.whole_pointer("msg")))


def left_early(use):
    return within("do {", [f"{use.pointer} msg;", f"if (k % 2) {{ msg = {use.make()}; }}", "if (!msg) break;"] +
                  use.whole_pointer("msg"), "} while (false);")


def raw_pointer(use):
    cpp = use.message.cpp
    return ([f"{cpp}* msg = k % 2 ? new {cpp} : nullptr;"] + within("if (msg) {", use.whole("msg->", "*msg")) +
            ["delete msg;"])


def pointer_to_either(use):
    """To a local variable, or to nothing."""
    cpp = use.message.cpp
    return ([f"{cpp} one;", f"{cpp}* msg = nullptr;", "if (k % 2) msg = &one;"] +
            within("if (msg != nullptr) {", use.whole("msg->", "*msg")))


def weak_pointer(use):
    kept = use.program.variable(use.pointer, "frame")
    return ([f"if (k == 1) {kept} = {use.make()};", f"if (k == 3) {kept}.reset();",
             f"boost::weak_ptr<{use.message.cpp}> weak = {kept};"] +
            within(f"if ({use.pointer} msg = weak.lock()) {{", use.whole_pointer("msg")))


def optional(use):
    cpp = use.message.cpp
    return ([f"std::optional<{cpp}> msg;", "if (k % 2) msg.emplace();"] +
            within("if (msg) {", use.whole("msg->", "*msg")))


def one_of_variant(use):
    cpp = use.message.cpp
    return ([f"std::variant<int, {cpp}> either;", f"if (k % 2) either = {cpp}();"] +
            within(f"if ({cpp}* msg = std::get_if<{cpp}>(&either)) {{", use.whole("msg->", "*msg")))


def by_helper_that_may_not(use):
    name = use.program.helper("bool", "ready", f"{use.pointer}& msg, int k",
                              ["if (k % 2 == 0) return false;", f"msg = {use.make()};", "return true;"], pure=True)
    return [f"{use.pointer} msg;"] + within(f"if ({name}(msg, k)) {{", use.whole_pointer("msg"))


def by_factory_that_may_not(use):
    body = use.rng.choice([[f"return k % 2 ? {use.make()} : {use.pointer}();"],
                           [f"if (k % 2) return {use.make()};", f"return {use.pointer}();"]])
    name = use.program.helper(use.pointer, "make", "int k", body, pure=True)
    return [f"{use.pointer} msg = {name}(k);"] + within("if (msg) {", use.whole_pointer("msg"))


def until_an_exception(use):
    return ([f"{use.pointer} msg;", "try {", "  if (k % 2 == 0) throw k;", f"  msg = {use.make()};",
             "} catch (int) {", "}"] + within("if (msg) {", use.whole_pointer("msg")))


def in_switch(use):
    return ([f"{use.pointer} msg;", "switch (k) {", "  case 0:", "    break;", "  case 1:",
             f"    msg = {use.make()};", "    break;", "  default:", f"    msg.reset(new {use.message.cpp});", "}"] +
            within("if (msg) {", use.whole_pointer("msg")))


def in_second_turn(use):
    return [f"{use.pointer} msg;"] + within(
        "for (int turn = 0; turn < 3; ++turn) {",
        [f"if (turn == 1) msg = {use.make()};"] + within("if (msg) {", use.whole_pointer("msg")))


def by_closure(use):
    return ([f"auto make = [&]() -> {use.pointer} {{", f"  if (k % 2) return {use.make()};", "  return nullptr;", "};",
             f"{use.pointer} msg = make();"] + within("if (msg) {", use.whole_pointer("msg")))


def member_that_is_made_late(use):
    kept = use.program.variable(use.pointer, "frame")
    return ([f"if (k == 1) {kept} = {use.make()};"] + within(f"if ({kept}) {{", use.whole_pointer(kept)))


def swapped_in(use):
    kept = use.program.variable(use.pointer, "spare")
    return ([f"if (k % 2) {kept}.reset(new {use.message.cpp});", f"{use.pointer} msg;", f"msg.swap({kept});"] +
            within("if (msg) {", use.whole_pointer("msg")))


MADE = [by_conditional_operator, in_the_condition, behind_and, by_conditional_reset, in_branch, left_early, raw_pointer,
        pointer_to_either, weak_pointer, optional, one_of_variant, by_helper_that_may_not, by_factory_that_may_not,
        until_an_exception, in_switch, in_second_turn, by_closure, member_that_is_made_late, swapped_in]


# In a struct that may not be there
# ----------------------------------------------------------------------------------------------------------------------


def behind_pointer(use):
    kind = use.frame()
    frame = use.program.variable(f"{kind}*", "frame", " = nullptr")
    return ([f"if (k == 1) {frame} = new {kind};"] +
            within(f"if ({frame}) {{", use.whole(f"{frame}->message.", f"{frame}->message")))


def behind_owner(use):
    kind = use.frame()
    owner = use.rng.choice(["std::unique_ptr", "std::shared_ptr", "boost::shared_ptr"])
    frame = use.program.variable(f"{owner}<{kind}>", "frame")
    whole = use.whole(f"{frame}->message.", f"{frame}->message")
    if use.rng.random() < 0.5:
        return [f"if (k == 1) {frame}.reset(new {kind});"] + within(f"if ({frame}) {{", whole)
    return ([f"if (k % 2) {frame}.reset(new {kind});", f"else {frame}.reset();"] +
            within("do {", [f"if (!{frame}) break;"] + whole, "} while (false);"))


def found_by_helper(use):
    kind = use.frame()
    frames = use.program.variable(f"std::vector<{kind}>", "frames")
    use.program.setup.append(f"{frames}.resize(4);")  # one for two rounds
    name = use.program.helper(f"{kind}*", "find", "int k",
                              [f"if (k % 2) return &{frames}[k / 2];", "return nullptr;"])
    return [f"{kind}* frame = {name}(k);"] + within("if (frame) {", use.whole("frame->message.", "frame->message"))


def found_in_map(use):
    kind = use.frame()
    frames = use.program.variable(f"std::map<int, {kind}>", "frames")
    return ([f"if (k == 1) {frames}[1].count = 1;", f"auto at = {frames}.find(k > 1 ? 1 : 7);"] +
            within(f"if (at != {frames}.end()) {{", use.whole("at->second.message.", "at->second.message")))


def behind_range_check(use):
    kind = use.frame()
    frames = use.program.variable(f"std::vector<{kind}>", "frames")
    place = use.rng.choice([f"{frames}.at(at)", f"{frames}[at]"])
    return ([f"if (k % 2) {frames}.resize({frames}.size() + 1);", "const std::size_t at = k / 2;"] +
            within(f"if (at < {frames}.size()) {{", use.whole(f"{place}.message.", f"{place}.message")))


def at_the_end_of_a_search(use):
    kind = use.frame()
    frames = use.program.variable(f"std::vector<{kind}>", "frames")
    use.program.setup += [f"{frames}.resize(3);", f"{frames}[1].count = 1;", f"{frames}[2].count = 3;"]
    search = f"while (at < {frames}.size() && {frames}[at].count != k) ++at;"
    whole = use.whole(f"{frames}.at(at).message.", f"{frames}.at(at).message")
    return ["std::size_t at = 0;", search] + within(f"if (at < {frames}.size()) {{", whole)


def in_list(use):
    kind = use.frame(["KIND* next = nullptr;"])
    first = use.program.variable(f"{kind}*", "first", " = nullptr")
    add = ["if (k % 2) {", f"  {kind}* added = new {kind};", f"  added->next = {first};", f"  {first} = added;", "}"]
    loop = use.rng.choice([f"for ({kind}* frame = {first}; frame; frame = frame->next) {{",
                           f"for (auto* frame = {first}; frame != nullptr; frame = frame->next) {{"])
    return add + within(loop, use.whole("frame->message.", "frame->message"))


def by_iterator(use):
    kind = use.frame()
    container = use.rng.choice(["std::vector", "std::list", "std::deque"])
    frames = use.program.variable(f"{container}<{kind}>", "frames")
    loop = f"for (auto at = {frames}.begin(); at != {frames}.end(); ++at) {{"
    return [f"if (k % 2) {frames}.emplace_back();"] + within(loop, use.whole("at->message.", "at->message"))


def by_iterator_that_steps_first(use):
    kind = use.frame()
    frames = use.program.variable(f"std::vector<{kind}>", "frames")
    return ([f"if (k < 2) {frames}.emplace_back();", f"auto at = {frames}.begin();"] +
            within(f"while (at != {frames}.end()) {{", use.whole("at->message.", "at->message") + ["++at;"]))


def by_dynamic_cast(use):
    kind = use.frame(["virtual ~KIND() {}"])
    other = use.program.unique("Filled")
    use.program.prelude.append(f"struct {other} : {kind} {{}};")
    frame = use.program.variable(f"boost::shared_ptr<{kind}>", "frame")
    return ([f"if (k % 2) {frame}.reset(new {other});", f"else {frame}.reset(new {kind});"] +
            within(f"if ({other}* filled = dynamic_cast<{other}*>({frame}.get())) {{",
                   use.whole("filled->message.", "filled->message")))


def beside_another(use):
    """The other object's member of the same name is always there."""
    kind = use.frame()
    there = use.program.variable(kind, "frame")
    frame = use.program.variable(f"{kind}*", "other", " = nullptr")
    field = use.message.arrays[0][0]
    return ([f"{there}.message.{field}.resize(3);", f"if (k == 2) {frame} = &{there};"] +
            within(f"if ({frame}) {{", use.whole(f"{frame}->message.", f"{frame}->message")))


def front_of_queue(use):
    frames = use.program.variable(f"std::deque<{use.message.cpp}>", "frames")
    front = f"{frames}.front()"
    named = [f"{use.message.cpp}& msg = {front};"] + use.whole("msg.", "msg")
    whole = use.rng.choice([named, use.whole(f"{front}.", front)])
    return ([f"if (k % 2) {frames}.emplace_back();"] +
            within(f"if (!{frames}.empty()) {{", whole + [f"{frames}.pop_front();"]))


def all_of_queue(use):
    frames = use.program.variable(f"std::deque<{use.pointer}>", "frames")
    return ([f"if (k % 2) {frames}.push_back({use.make()});", f"if (k % 2) {frames}.push_back({use.make()});"] +
            within(f"while (!{frames}.empty()) {{", [f"{use.pointer} msg = {frames}.front();", f"{frames}.pop_front();"] +
                   use.whole_pointer("msg")))


def filled_with_its_struct(use):
    kind = use.frame()
    name = use.program.helper("void", "fill", f"{kind}& frame, int k", use.fill("frame.message.") + ["++frame.count;"],
                              pure=True)
    return [f"{kind} frame;", f"{name}(frame, k);"] + within("if (k % 2) {", use.send("frame.message"))


HELD = [behind_pointer, behind_owner, found_by_helper, found_in_map, behind_range_check, at_the_end_of_a_search, in_list,
        by_iterator, by_iterator_that_steps_first, by_dynamic_cast, beside_another, front_of_queue, all_of_queue,
        filled_with_its_struct]
