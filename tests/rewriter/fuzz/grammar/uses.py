# SPDX-License-Identifier: BSD-3-Clause
"""What a program does with a message where it has it: fills it and publishes it, once or again."""
from .builders import contents
from .fills import change, in_block
from .program import indented


class Use:
    """A message's type and what publishes it. How the message is reached is said with each call: `access` is "msg." or
    "msg->", `argument` is what publish is given. Neither may
    name a variable as fills.py does: i, it, one."""

    def __init__(self, program, message, output):
        self.program, self.message = program, message
        self._output = output(program, message)

    @property
    def rng(self):
        return self.program.rng

    @property
    def pointer(self):
        """The type of a pointer that owns such a message."""
        return f"{self.message.cpp}Ptr"

    def make(self):
        """An expression that makes one."""
        return f"boost::make_shared<{self.message.cpp}>()"

    def fill(self, access):
        return in_block(self._contents(access))

    def fill_at_once(self, access):
        """By one statement, so that `access` is evaluated once."""
        field, element = self.message.arrays[0]
        array, count = f"{access}{field}", self.rng.choice(["16 + k", "1500"])
        return [self.rng.choice([f"{array}.assign({count}, static_cast<{element.cpp}>(7 + k));", f"{array}.resize({count});",
                                 f"{array} = std::vector<{element.cpp}>({count}, static_cast<{element.cpp}>(k));"])]

    def _contents(self, access):
        if self.rng.random() < 0.5:
            return contents(self.program, self.message, access)
        # No library is called, so that nothing unknown hides what is inserted in the wrong place.
        field, element = self.message.arrays[0]
        array = f"{access}{field}"
        return [f"{array}.resize({self.rng.choice([12, 700])} + k);", "int number = k;",
                f"for (auto& one : {array}) one = static_cast<{element.cpp}>(++number);"] + self.message.set_meta(access)

    def send(self, argument, pointer=False):
        return self._output.publish(argument, pointer)

    def whole(self, access, argument, pointer=False):
        once = self._contents(access) + self.send(argument, pointer)
        if self.rng.random() < 0.7:
            return once
        return in_block(once) + in_block(change(self.rng, self.message, access)) + self.send(argument, pointer)

    def whole_pointer(self, name):
        """Of a pointer that owns its message."""
        if self.rng.random() < 0.2:
            return self.whole(f"{name}->", f"*{name}")
        return self.whole(f"{name}->", name, True)

    def frame(self, more=()):
        """A struct of the program with a member `message`; its name."""
        kind = self.program.unique("Frame")
        self.program.prelude += [f"struct {kind} {{", f"  {self.message.cpp} message;", "  int count = 0;"]
        self.program.prelude += [f"  {line.replace('KIND', kind)}" for line in more] + ["};"]
        return kind


def within(begin, lines, end="}"):
    return [begin] + indented(lines) + [end]
