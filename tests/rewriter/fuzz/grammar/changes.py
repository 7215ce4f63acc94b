# SPDX-License-Identifier: BSD-3-Clause
"""One spelling, two messages: the elements of one lasting message are let go, and then another one, which subscribers have since
the step before, is written and published by the same name, or by one that is easily taken for it. Each write costs a copy, which
the report's level has to say."""
from .lasting import SIZE, Lasting
from .program import indented

# What the two are called, and what happens in between. Each returns (statements before, the name of the message that is let go,
# statements in between, the name of the one that is written). None of the statements declares anything but what it names.
# ----------------------------------------------------------------------------------------------------------------------


def two_in(program, kind, cpp):
    name = program.variable(f"std::{kind}<{cpp}>", "frames")
    program.setup += [f"{name}.resize(2);", f"for (auto& one : {name}) one.{{field}}.resize({SIZE});"]
    return name


def local_index(program, cpp):
    frames, at = two_in(program, "vector", cpp), program.unique("at")
    return [f"int {at} = 1;"], f"{frames}[{at}]", [f"{at} = 0;"], f"{frames}[{at}]"


def local_index_given_away(program, cpp):
    frames, at = two_in(program, "deque", cpp), program.unique("at")
    name = program.helper("void", "step", "int& at", ["at = 0;"])
    return [f"int {at} = 1;"], f"{frames}[{at}]", [f"{name}({at});"], f"{frames}[{at}]"


def member_index(program, cpp):
    frames, at = two_in(program, "vector", cpp), program.variable("int", "at", " = 1")
    return [f"{at} = 1;"], f"{frames}[{at}]", [f"{at} = 0;"], f"{frames}[{at}]"


def member_index_of_function(program, cpp):
    frames, at = two_in(program, "vector", cpp), program.variable("int", "at", " = 1")
    name = program.helper("void", "step", "", [f"{at} = 1 - {at};"])
    return [f"{at} = 1;"], f"{frames}[{at}]", [f"{name}();"], f"{frames}[{at}]"


def reference_by_member_index(program, cpp):
    frames, at = two_in(program, "vector", cpp), program.variable("int", "at", " = 1")
    one = program.unique("named")
    return ([f"{at} = 0;", f"{cpp}& {one} = {frames}[{at}];", f"{at} = 1;"], f"{frames}[{at}]", [f"(void){one};"], one)


def counted(program, cpp):
    frames, at = two_in(program, "vector", cpp), program.unique("at")
    return [f"int {at} = 1;"], f"{frames}[{at}--]", [], f"{frames}[{at}]"


def iterator(program, cpp):
    frames, at = two_in(program, "list", cpp), program.unique("at")
    return [f"auto {at} = {frames}.begin();"], f"(*{at})", [f"++{at};"], f"(*{at})"


def pointer(program, cpp):
    frames, at = two_in(program, "vector", cpp), program.unique("at")
    step = program.rng.choice([f"++{at};", f"{at} += 1;", f"{at}++;"])
    return [f"{cpp}* {at} = {frames}.data();"], f"(*{at})", [step], f"(*{at})"


def front(program, cpp):
    frames = two_in(program, "deque", cpp)
    change = program.rng.choice([[f"std::swap({frames}[0], {frames}[1]);"],
                                 [f"std::rotate({frames}.begin(), {frames}.begin() + 1, {frames}.end());"],
                                 [f"{frames}.push_back({frames}.front());", f"{frames}.pop_front();"]])
    return [], f"{frames}.front()", change, f"{frames}.front()"


def pair_part(program, cpp):
    name = program.variable(f"std::pair<{cpp}, {cpp}>", "frames")
    program.setup += [f"{name}.first.{{field}}.resize({SIZE});", f"{name}.second.{{field}}.resize({SIZE});"]
    first = program.rng.choice([f"{name}.first", f"std::get<0>({name})"])
    return [], first, [], program.rng.choice([f"{name}.second", f"std::get<1>({name})"])


def tuple_part(program, cpp):
    name = program.variable(f"std::tuple<{cpp}, int, {cpp}>", "frames")
    program.setup += [f"std::get<{part}>({name}).{{field}}.resize({SIZE});" for part in (0, 2)]
    return [], f"std::get<0>({name})", [], f"std::get<2>({name})"


def key(program, cpp):
    name = program.variable(f"std::map<std::string, {cpp}>", "frames")
    program.setup += [f'{name}["{one}"].{{field}}.resize({SIZE});' for one in ("one", "other")]
    at = program.unique("at")
    return [f'std::string {at} = "one";'], f"{name}[{at}]", [f'{at} = "other";'], f"{name}[{at}]"


CHANGES = [local_index, local_index_given_away, member_index, member_index_of_function, reference_by_member_index, counted, iterator,
           pointer, front, pair_part, tuple_part, key]


def given_container(program, cpp, let_go, write):
    """By a function that is given the container."""
    frames = two_in(program, "vector", cpp)
    name = program.helper("void", "change", f"std::vector<{cpp}>& given, int k", let_go("given[1]") + write("given[0]"))
    return [f"{name}({frames}, k);"], f"{frames}[0]"


def left_loop(program, cpp, let_go, write):
    frames = two_in(program, "vector", cpp)
    lines = [f"for (auto& one : {frames}) {{"] + indented(let_go("one") + ["break;"]) + ["}"]
    return lines + [f"for (auto& one : {frames}) {{"] + indented(write("one")) + ["}"], f"{frames}[1]"


def array_of_result(program, cpp, let_go, write):
    """By a reference to the array of what a function returns."""
    frames = two_in(program, "vector", cpp)
    frame = program.helper(f"{cpp}&", "frame", "int k", [f"if (k % 2) return {frames}[0];", f"return {frames}[1];"])
    named = program.unique("named")
    return let_go(f"{frame}(k + 1)") + [f"auto& {named} = {frame}(k).{{field}};", f"{named}[0] = {{value}};"], f"{frame}(k)"


WHOLE = [given_container, left_loop, array_of_result]


class Change(Lasting):
    def __init__(self, program, message):
        super().__init__(program, message, "change", CHANGES + WHOLE)

    def lines(self, send):
        """Statements that write one of two messages, and `send` it."""
        program, cpp = self.program, self.message.cpp
        begun = len(program.setup)
        if self.way in WHOLE:
            lines, name = self.way(program, cpp, self.let_go, self.write)
        else:
            before, gone, between, name = self.way(program, cpp)
            lines = before + self.let_go(gone) + between + self.write(name)
        program.setup[begun:] = [self._filled_in(line) for line in program.setup[begun:]]
        return [self._filled_in(line) for line in lines] + send(name)

    def _filled_in(self, line):
        return line.replace("{field}", self.field).replace("{value}", self.element.value("3"))
