# SPDX-License-Identifier: BSD-3-Clause
"""Names of lasting messages: one of two is filled under one name in a step, and published under another. Whatever the names
are, it is the message that was published two steps before, so that filling it again costs a copy, which the report's
level has to say."""
from .program import indented

# The homes of two messages. Each returns expressions that denote the message of step k.
# ----------------------------------------------------------------------------------------------------------------------


def in_vector(program, cpp):
    name = program.variable(f"std::vector<{cpp}>", "frames")
    program.setup.append(f"{name}.resize(2);")
    return [f"{name}[k % 2]", f"{name}.at(k % 2)", f"(*({name}.begin() + k % 2))",
            f"(*std::next({name}.begin(), k % 2))", f"{name}.data()[k % 2]",
            f"(k % 2 ? {name}.back() : {name}.front())"]


def in_map(program, cpp):
    name = program.variable(f"std::map<int, {cpp}>", "frames")
    program.setup += [f"{name}[0];", f"{name}[1];"]
    return [f"{name}[k % 2]", f"{name}.at(k % 2)", f"{name}.find(k % 2)->second",
            f"std::next({name}.begin(), k % 2)->second", f"std::get<1>(*{name}.lower_bound(k % 2))"]


def in_list(program, cpp):
    name = program.variable(f"std::list<{cpp}>", "frames")
    program.setup.append(f"{name}.resize(2);")
    return [f"(*std::next({name}.begin(), k % 2))", f"(k % 2 ? {name}.back() : {name}.front())"]


def in_array(program, cpp):
    name = program.variable(f"std::array<{cpp}, 2>", "frames")
    return [f"{name}[k % 2]", f"{name}.at(k % 2)", f"(*({name}.data() + k % 2))",
            f"std::get<1>(std::tie({name}[1], {name}[k % 2]))"]


def in_pair(program, cpp):
    name = program.variable(f"std::pair<{cpp}, {cpp}>", "frames")
    return [f"(k % 2 ? {name}.first : {name}.second)", f"(k % 2 ? std::get<0>({name}) : std::get<1>({name}))"]


def two_variables(program, cpp):
    one, other = program.variable(cpp, "frame"), program.variable(cpp, "frame")
    return [f"(k % 2 ? {one} : {other})", f"(*(k % 2 ? &{one} : &{other}))", f"(k % 2 == 0 ? {other} : {one})"]


def in_pointers(program, cpp):
    name = program.variable(f"std::vector<boost::shared_ptr<{cpp}>>", "frames")
    program.setup.append(f"for (int i = 0; i < 2; ++i) {name}.push_back(boost::make_shared<{cpp}>());")
    return [f"(*{name}[k % 2])", f"(**({name}.begin() + k % 2))", f"(*{name}.at(k % 2).get())",
            f"(*(k % 2 ? {name}.back() : {name}.front()))"]


def behind_virtual_function(program, cpp):
    base, derived = program.unique("Base"), program.unique("Derived")
    program.prelude += [f"struct {base} {{", f"  virtual ~{base}() = default;",
                        f"  virtual {cpp}& frame(int k) {{ return frames[k % 2]; }}", f"  {cpp} frames[2];", "};",
                        f"struct {derived} : {base} {{", f"  {cpp}& frame(int k) override {{ return others[k % 2]; }}",
                        f"  {cpp} others[2];", "};"]
    name = program.variable(f"std::unique_ptr<{base}>", "holder")
    program.setup.append(f"{name}.reset(new {derived});")
    return [f"{name}->frame(k)", f"static_cast<{derived}&>(*{name}).others[k % 2]"]


HOMES = [in_vector, in_map, in_list, in_array, in_pair, two_variables, in_pointers, behind_virtual_function]


# What else may stand for such an expression. Each returns statements, and an expression.
# ----------------------------------------------------------------------------------------------------------------------


def as_it_is(program, cpp, name):
    return [], name


def reference(program, cpp, name):
    named = program.unique("named")
    return [f"{cpp}& {named} = {name};"], named


def pointer(program, cpp, name):
    named = program.unique("named")
    return [f"{cpp}* {named} = &({name});"], f"(*{named})"


def pointer_given_later(program, cpp, name):
    named = program.unique("named")
    return [f"{cpp}* {named} = nullptr;", f"{named} = &({name});"], f"(*{named})"


def of_function(program, cpp, name):
    return [], f"{program.helper(cpp + '&', 'frame', 'int k', [f'return {name};'])}(k)"


def of_function_with_two_returns(program, cpp, name):
    body = [f"if (k % 2) return {name};", f"return {name};"]
    return [], f"{program.helper(cpp + '&', 'frame', 'int k', body)}(k)"


def of_function_with_pointer(program, cpp, name):
    body = [f"{cpp}* found = &({name});", "return found;"]
    return [], f"(*{program.helper(cpp + '*', 'frame', 'int k', body)}(k))"


def of_closure(program, cpp, name):
    named = program.unique("named")
    return [f"const auto {named} = [&](int k) -> {cpp}& {{ return {name}; }};"], f"{named}(k)"


def in_tuple(program, cpp, name):
    named = program.unique("named")
    return [f"std::tuple<{cpp}&, int> {named}({name}, k);"], f"std::get<0>({named})"


def kept_pointer(program, cpp, name):
    kept = program.variable(f"{cpp}*", "current", " = nullptr")
    return [f"{kept} = &({name});"], f"(*{kept})"


def in_aggregate(program, cpp, name):
    kind, named = program.unique("Slot"), program.unique("named")
    program.prelude += [f"struct {kind} {{", f"  {cpp}* message;", "  int count;", "};"]
    return [f"{kind} {named}{{&({name}), k}};"], f"(*{named}.message)"


def in_object_with_reference(program, cpp, name):
    kind, named = program.unique("View"), program.unique("named")
    program.prelude += [f"struct {kind} {{", f"  explicit {kind}({cpp}& given) : message(given) {{}}",
                        f"  {cpp}& message;", "};"]
    return [f"{kind} {named}({name});"], f"{named}.message"


def pushed_pointer(program, cpp, name):
    named = program.unique("named")
    return [f"std::vector<{cpp}*> {named};", f"{named}.push_back(&({name}));"], f"(*{named}.back())"


def reference_wrapper(program, cpp, name):
    named = program.unique("named")
    return [f"std::reference_wrapper<{cpp}> {named} = {name};"], f"{named}.get()"


def pointer_to_pointer(program, cpp, name):
    named, at = program.unique("named"), program.unique("at")
    return [f"{cpp}* {named}[] = {{&({name})}};", f"{cpp}** {at} = {named};"], f"(**{at})"


STANDS_FOR = [as_it_is, reference, pointer, pointer_given_later, of_function, of_function_with_two_returns,
              of_function_with_pointer, of_closure, in_tuple, kept_pointer, in_aggregate, in_object_with_reference,
              pushed_pointer, reference_wrapper, pointer_to_pointer]


# What is done under the name
# ----------------------------------------------------------------------------------------------------------------------


def directly(program, cpp, name, body):
    return body(name)


def by_function_of_reference(program, cpp, name, body):
    return [f"{program.helper('void', 'use', f'{cpp}& shown, int k', body('shown'))}({name}, k);"]


def by_function_of_pointer(program, cpp, name, body):
    return [f"{program.helper('void', 'use', f'{cpp}* shown, int k', body('(*shown)'))}(&({name}), k);"]


def by_closure(program, cpp, name, body):
    named = program.unique("use")
    return [f"const auto {named} = [&]({cpp}& shown) {{"] + indented(body("shown")) + ["};", f"{named}({name});"]


def by_function_object(program, cpp, name, body):
    named = program.unique("use")
    return [f"const std::function<void({cpp}&)> {named} = [&]({cpp}& shown) {{"] + indented(body("shown")) + [
        "};", f"{named}({name});"]


def by_algorithm(program, cpp, name, body):
    return [f"std::for_each(&({name}), &({name}) + 1, [&]({cpp}& shown) {{"] + indented(body("shown")) + ["});"]


DOES = [directly, by_function_of_reference, by_function_of_pointer, by_closure, by_function_object, by_algorithm]


class Names:
    """The names of one home's messages. What stands for them is of two kinds only: the more kinds, the likelier is one that is
    refused, and says nothing about levels."""

    def __init__(self, program, home, cpp):
        self.program, self.cpp = program, cpp
        self.names = home(program, cpp)
        self.stands_for = program.rng.sample(STANDS_FOR, 2)
        self.does = [directly, directly, program.rng.choice(DOES)]
        self.chosen = [("home", home)]

    def use(self, body):
        """Statements that do something with the message of step k."""
        stands_for, does = self.program.rng.choice(self.stands_for), self.program.rng.choice(self.does)
        self.chosen += [("name", stands_for), ("use", does)]
        lines, name = stands_for(self.program, self.cpp, self.program.rng.choice(self.names))
        return lines + does(self.program, self.cpp, name, body)
