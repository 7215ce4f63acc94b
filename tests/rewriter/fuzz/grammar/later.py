# SPDX-License-Identifier: BSD-3-Clause
"""A lasting message is filled anew and published; then something that is not called by its name writes to it, which costs a
copy: a function object, a library, or the end of an object. Often the elements are let go behind that, so that the next step finds none."""
from .lasting import Lasting
from .program import indented

# Each returns (statements before the publish, statements behind it). `write` makes the statements that write to a message of
# that name, in step `k`.
# ----------------------------------------------------------------------------------------------------------------------


def closure(write):
    return ["[&](int k) {"] + indented(write) + ["}"]


def assigned(left, value):
    """left = value;"""
    return [f"{left} = {value[0]}"] + value[1:-1] + [value[-1] + ";"]


def function(program, cpp, frame, write):
    call = program.unique("call")
    kind = program.rng.choice(["std::function", "boost::function"])
    return assigned(f"{kind}<void(int)> {call}", closure(write(frame))), [f"{call}(k);"]


def function_of_function(program, cpp, frame, write):
    inner, outer = program.unique("inner"), program.unique("outer")
    return (assigned(f"std::function<void(int)> {inner}", closure(write(frame))) +
            [f"const std::function<void(int)> {outer} = [&](int k) {{ {inner}(k); }};"], [f"{outer}(k);"])


def function_by_reference(program, cpp, frame, write):
    inner, outer = program.unique("inner"), program.unique("outer")
    return (assigned(f"auto {inner}", closure(write(frame))) + [f"std::function<void(int)> {outer} = std::ref({inner});"],
            [f"{outer}(k);"])


def lasting_function(program, cpp, frame, write):
    call = program.variable("std::function<void(int)>", "call")
    program.setup += assigned(call, closure(write(frame)))
    return [], [f"{call}(k);"]


def list_of_functions(program, cpp, frame, write):
    calls = program.unique("calls")
    return ([f"std::vector<std::function<void(int)>> {calls};", f"{calls}.push_back({closure(write(frame))[0]}"] +
            closure(write(frame))[1:-1] + ["});"], [f"for (auto& one : {calls}) one(k);"])


def notified(program, cpp, frame, write):
    """By a function of the program, which names no message itself."""
    before, behind = list_of_functions(program, cpp, frame, write)
    notify = program.unique("notify")
    return before + [f"const auto {notify} = [&] {{ {behind[0]} }};"], [f"{notify}();"]


def signal(program, cpp, frame, write):
    program.includes.add("boost/signals2/signal.hpp")
    changed = program.unique("changed")
    lines = closure(write(frame))
    return ([f"boost::signals2::signal<void(int)> {changed};", f"{changed}.connect({lines[0]}"] + lines[1:-1] + ["});"],
            [f"{changed}(k);"])


def posted(program, cpp, frame, write):
    """In a library that is not known to call anything."""
    program.includes.add("boost/asio/io_service.hpp")
    loop = program.unique("loop")
    run = program.rng.choice(["run()", "poll()", "run_one()"])
    return [f"boost::asio::io_service {loop};", f"{loop}.post([&] {{"] + indented(write(frame)) + ["});"], [f"{loop}.{run};"]


def deferred(program, cpp, frame, write):
    later = program.unique("later")
    return ([f"auto {later} = std::async(std::launch::deferred, [&] {{"] + indented(write(frame)) + ["});"],
            [f"{later}.get();"])


def algorithm(program, cpp, frame, write):
    once = program.unique("once")
    return ([f"const int {once}[] = {{1}};"],
            [f"std::for_each({once}, {once} + 1, [&](int) {{"] + indented(write(frame)) + ["});"])


def function_object(program, cpp, frame, write):
    kind, call = program.unique("Change"), program.unique("call")
    holder = program.rng.choice([kind, "std::function<void(int)>"])
    return ([f"struct {kind} {{", f"  {cpp}& frame;", "  void operator()(int k) const {"] + indented(indented(write("frame"))) +
            ["  }", "};", f"{holder} {call} = {kind}{{{frame}}};"], [f"{call}(k);"])


def guard(program, cpp, write):
    kind = program.unique("Guard")
    return kind, ([f"struct {kind} {{", f"  {cpp}& frame;", "  int k;", f"  ~{kind}() {{"] +
                  indented(indented(write("frame"))) + ["  }", "};"])


def end_of_scope(program, cpp, frame, write):
    kind, lines = guard(program, cpp, write)
    return lines, ["{", f"  {kind} guard{{{frame}, k}};", "  (void)guard;", "}"]


def end_of_temporary(program, cpp, frame, write):
    kind, lines = guard(program, cpp, write)
    return lines, [f"(void){kind}{{{frame}, k}};"]


def end_by_delete(program, cpp, frame, write):
    kind, lines = guard(program, cpp, write)
    name = program.unique("guard")
    return lines + [f"{kind}* {name} = new {kind}{{{frame}, k}};"], [f"delete {name};"]


def end_by_reset(program, cpp, frame, write):
    kind, lines = guard(program, cpp, write)
    name = program.unique("guard")
    pointer = program.rng.choice(["std::unique_ptr", "std::shared_ptr", "boost::shared_ptr"])
    end = program.rng.choice([f"{name}.reset();", f"{name} = nullptr;"] if pointer != "boost::shared_ptr" else [f"{name}.reset();"])
    return lines + [f"{pointer}<{kind}> {name}(new {kind}{{{frame}, k}});"], [end]


def end_by_clear(program, cpp, frame, write):
    kind, lines = guard(program, cpp, write)
    name = program.unique("guards")
    end = program.rng.choice(["clear()", "pop_back()", "erase(NAME.begin())", "resize(0)"]).replace("NAME", name)
    return lines + [f"std::vector<std::unique_ptr<{kind}>> {name};",
                    f"{name}.emplace_back(new {kind}{{{frame}, k}});"], [f"{name}.{end};"]


def end_of_pointer(program, cpp, frame, write):
    """By a deleter that its type does not show."""
    pointer, end = program.rng.choice(["std::shared_ptr", "boost::shared_ptr"]), program.unique("end")
    return ([f"{pointer}<void> {end}(static_cast<void*>(nullptr), [&](void*) {{"] + indented(write(frame)) + ["});"],
            [f"{end}.reset();"])


WAYS = [function, function_of_function, function_by_reference, lasting_function, list_of_functions, notified, signal, posted,
        deferred, algorithm, function_object, end_of_scope, end_of_temporary, end_of_pointer, end_by_delete, end_by_reset,
        end_by_clear]


class Later(Lasting):
    def __init__(self, program, message):
        super().__init__(program, message, "later", WAYS)

    def lines(self, send):
        """Statements that fill a message, `send` it, and have it written to."""
        frame = self.program.variable(self.message.cpp, "frame")
        before, behind = self.way(self.program, self.message.cpp, frame, self.write)
        last = self.let_go(frame) if self.program.rng.random() < 0.5 else []
        first = self.let_go(frame) + self.write(frame) + before
        if self.program.rng.random() < 0.25:  # not later: nothing is copied
            return first + behind + send(frame) + last
        return first + send(frame) + behind + last
