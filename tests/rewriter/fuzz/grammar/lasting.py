# SPDX-License-Identifier: BSD-3-Clause
"""What a program does to the elements of a message that lasts from step to step."""

SIZE = 40


class Lasting:
    def __init__(self, program, message, kind, ways):
        self.program, self.message = program, message
        self.field, self.element = message.arrays[0]
        self.way = program.rng.choice(ways)
        self.chosen = [(kind, self.way)]

    def let_go(self, name):
        how = self.program.rng.choice(["clear();", f"assign({SIZE}, 0);", "resize(0);"])
        return [f"{name}.{self.field}.{how}"]

    def write(self, name):
        array, value = f"{name}.{self.field}", self.element.value("3")
        return [f"if ({array}.size() < {SIZE}) {array}.resize({SIZE});", f"{array}[k % {SIZE}] = {value};"]
