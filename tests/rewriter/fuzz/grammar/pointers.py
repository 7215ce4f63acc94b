# SPDX-License-Identifier: BSD-3-Clause
"""What points into a message's array, as a value: pointers, references, iterators, containers and views of them."""

COUNT = 40  # elements of an array


class Handle:
    """Statements that make a handle to the first element, and how an element is written through it and read."""

    def __init__(self, lines, target=None, call=None):
        self.lines, self.target, self.call = lines, target, call

    def write(self, index, value):
        if self.call:
            return [self.call.format(index=index, value=value)]
        return [f"{self.target.format(index=index)} = {value};"]

    def read(self, index):
        """An expression; none where the handle only writes."""
        return self.target.format(index=index) if self.target else None


# Expressions for the address of the first element
# ----------------------------------------------------------------------------------------------------------------------


def plain_reference(program, message, access, element):
    array = f"{access}{message.arrays[0][0]}"
    return program.rng.choice([f"&{array}[0]", f"{array}.data()"])


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
    message, field = array.rsplit("->" if pointer else ".", 1)
    message = "*" + message if pointer else message
    return Handle([f"const auto& read_only = {message};", f"const {element}* h = read_only.{field}.data();"],
                  f"const_cast<{element}*>(h)[{{index}}]")


def in_tuple(program, element, source, array):
    return Handle([f"std::tuple<int, {element}*> h(1, {source});"], "std::get<1>(h)[{index}]")


def in_standard_array(program, element, source, array):
    return Handle([f"std::array<{element}*, 2> h{{{{nullptr, {source}}}}};"], "h[1][{index}]")


def in_initializer_list(program, element, source, array):
    return Handle([f"std::vector<{element}*> h = {{nullptr, {source}}};"], "h.back()[{index}]")


def in_optional(program, element, source, array):
    return Handle([f"std::optional<{element}*> h;", f"h = {source};"], "(*h)[{index}]")


def in_any(program, element, source, array):
    return Handle([f"std::any h = static_cast<{element}*>({source});"], f"std::any_cast<{element}*>(h)[{{index}}]")


def in_atomic(program, element, source, array):
    return Handle([f"std::atomic<{element}*> h(nullptr);", f"h.store({source});"], "h.load()[{index}]")


def in_reference_wrapper(program, element, source, array):
    return Handle([f"std::reference_wrapper<{element}> h = std::ref(*({source}));"], "(&h.get())[{index}]")


def in_union(program, element, source, array):
    kind = program.unique("Either")
    program.prelude += [f"union {kind} {{", f"  {element}* p;", "  std::uintptr_t number;", "};"]
    return Handle([f"{kind} h;", f"h.p = {source};"], "h.p[{index}]")


def in_static(program, element, source, array):
    return Handle([f"static {element}* h;", f"h = {source};"], "h[{index}]")


def in_container_member(program, element, source, array):
    kept = program.variable(f"std::vector<{element}*>", "pointers")
    return Handle([f"{kept}.clear();", f"{kept}.push_back({source});"], f"{kept}.front()[{{index}}]")


def in_struct_member(program, element, source, array):
    kind = program.unique("State")
    program.prelude += [f"struct {kind} {{", "  int count = 0;", f"  {element}* place = nullptr;", "};"]
    kept = program.variable(kind, "state")
    return Handle([f"{kept}.place = {source};"], f"{kept}.place[{{index}}]")


def swapped(program, element, source, array):
    return Handle([f"{element}* h0 = {source};", f"{element}* h = nullptr;", "std::swap(h, h0);"], "h[{index}]")


def exchanged(program, element, source, array):
    return Handle([f"{element}* h0 = {source};",
                   f"{element}* h = std::exchange(h0, static_cast<{element}*>(nullptr));"], "h[{index}]")


def moved(program, element, source, array):
    return Handle([f"std::vector<{element}*> h0(1, {source});", f"std::vector<{element}*> h = std::move(h0);"],
                  "h[0][{index}]")


def copied_as_bytes(program, element, source, array):
    return Handle([f"{element}* h0 = {source};", f"{element}* h;", "std::memcpy(&h, &h0, sizeof(h));"], "h[{index}]")


def bound_by_structure(program, element, source, array):
    return Handle([f"auto [h, count] = std::make_pair(static_cast<{element}*>({source}), {COUNT});", "(void)count;"],
                  "h[{index}]")


def pointer_to_pointer(program, element, source, array):
    return Handle([f"{element}* h0 = {source};", f"{element}** h = &h0;"], "(*h)[{index}]")


def reverse_iterator(program, element, source, array):
    return Handle([f"auto h = {array}.rend() - 1;"], "*(h - ({index}))")


def iterator_range(program, element, source, array):
    return Handle([f"auto h = std::make_pair({array}.begin(), {array}.end());"], "h.first[{index}]")


def pointer_to_array(program, element, source, array):
    return Handle([f"auto* h = &{array};"], "(*h)[{index}]")


def pointer_to_middle(program, element, source, array):
    return Handle([f"auto h = std::next({array}.begin(), 5);"], "*(h + ({index}) - 5)")


def chosen(program, element, source, array):
    return Handle([f"{element} spare[{COUNT}] = {{}};", f"{element}* h = k % 2 ? {source} : spare;"], "h[{index}]")


def assigned_later(program, element, source, array):
    return Handle([f"{element} spare[{COUNT}] = {{}};", f"{element}* h = spare;", f"if (k != 1) h = {source};"], "h[{index}]")


STORES = [pointer, second_pointer, element_reference, iterator, array_reference, aggregate, in_vector, in_map,
          in_pair, as_integer, as_void, as_bytes, in_variable, const_cast, const_access, in_tuple, in_standard_array,
          in_initializer_list, in_optional, in_any, in_atomic, in_reference_wrapper, in_union, in_static,
          in_container_member, in_struct_member, swapped, exchanged, moved, copied_as_bytes, bound_by_structure,
          pointer_to_pointer, reverse_iterator, iterator_range, pointer_to_array, pointer_to_middle, chosen,
          assigned_later]
# Those that an analysis can follow to their end.
LOCAL = [pointer, second_pointer, element_reference, iterator, array_reference, as_bytes, pointer_to_middle]
