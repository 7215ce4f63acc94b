# SPDX-License-Identifier: BSD-3-Clause
"""Ways to fill one array of a message. Each is given the array's expression, its element type and the name of a count,
and returns statements."""


def resize_and_index(rng, array, element, n):
    return [f"{array}.resize({n});", f"for (int i = 0; i < {n}; ++i) {{", f"  {element.put(array + '[i]')}", "}"]


def resize_one_line(rng, array, element, n):
    return [f"{array}.resize({n});", f"for (int i = 0; i < {n}; ++i) {element.put(array + '[i]').split(';')[0]};"]


def resize_and_part(rng, array, element, n):
    """What is not written stays zero."""
    return [f"{array}.resize({n});", f"for (int i = 0; i < {n}; i += 2) {{ {element.put(array + '[i]')} }}"]


def resize_only(rng, array, element, n):
    return [f"{array}.resize({n});"]


def resize_and_copy(rng, array, element, n):
    return [f"const std::vector<{element.cpp}> source = fuzz::elements<{element.cpp}>({n}, k);",
            f"{array}.resize({n});",
            f"if ({n} > 0) std::memcpy(&{array}[0], &source[0], {n} * sizeof({element.cpp}));"]


def resize_and_copy_part(rng, array, element, n):
    return [f"const std::vector<{element.cpp}> source = fuzz::elements<{element.cpp}>({n}, k);",
            f"{array}.resize({n} + 3);",
            f"std::memcpy({array}.data(), source.data(), {n} * sizeof({element.cpp}));"]


def push_back(rng, array, element, n):
    return [f"for (int i = 0; i < {n}; ++i) {{", f"  if (fuzz::value(i, k) % 3 == 0) continue;",
            f"  {array}.push_back({element.value()});", "}"]


def clear_reserve_push(rng, array, element, n):
    return [f"{array}.clear();", f"{array}.reserve({n});", f"for (int i = 0; i < {n}; ++i)",
            f"  {array}.push_back({element.value()});"]


def assign_value(rng, array, element, n):
    return [f"{array}.assign({n}, {element.value('7')});",
            f"if (!{array}.empty()) {{ {element.put(array + '[0]', '1')} }}"]


def assign_range(rng, array, element, n):
    return [f"const std::vector<{element.cpp}> source = fuzz::elements<{element.cpp}>({n}, k);",
            f"{array}.assign(source.begin(), source.end());"]


def whole_vector(rng, array, element, n):
    return [f"{array} = fuzz::elements<{element.cpp}>({n}, k);"]


def made_vector(rng, array, element, n):
    """Of others' elements, of the array's own, or of none."""
    source = f"fuzz::elements<{element.cpp}>({n}, k)"
    made = f"{array} = std::vector<{element.cpp}>"
    return rng.choice([
        [f"{made}({n});", f"if ({n} > 2) {{ {element.put(array + '[1]', '3')} }}"],
        [f"{made}({n}, {element.value('6')});"],
        [f"{made}(fuzz::size(k, 3) + {n});"],
        [f"const std::deque<{element.cpp}> all({n}, {element.value('2')});", f"{made}(all.begin(), all.end());"],
        [f"const std::vector<{element.cpp}> source = {source};", f"{made}(source.rbegin(), source.rend());"],
        [f"const std::vector<{element.cpp}> source = {source};", f"{made}(source.data(), source.data() + {n});"],
        [f"{array}.resize({n});", f"for (int i = 0; i < {n}; ++i) {{ {element.put(array + '[i]')} }}",
         f"{made}({array}.rbegin(), {array}.rend());"],
        [f"{array}.resize({n});", f"{made}({array}.begin() + {n} / 2, {array}.end());"],
    ])


def swap_vector(rng, array, element, n):
    return [f"std::vector<{element.cpp}> built = fuzz::elements<{element.cpp}>({n}, k);", f"{array}.swap(built);"]


def insert_range(rng, array, element, n):
    return [f"const std::vector<{element.cpp}> more = fuzz::elements<{element.cpp}>({n}, k);",
            f"{array}.insert({array}.end(), more.begin(), more.end());"]


def shrinks(rng, array, element, n):
    return [f"{array}.resize({n} + 5);", "int valid = 0;", f"for (int i = 0; i < {n}; ++i) {{",
            f"  if (fuzz::value(i, k) % 2) continue;", f"  {element.put(array + '[valid]')}", "  ++valid;", "}",
            f"{array}.resize(valid);"]


def raw_pointer(rng, array, element, n):
    return [f"{array}.resize({n} + 1);", f"{element.cpp}* cursor = &{array}[0];",
            f"for (int i = 0; i < {n}; ++i, ++cursor) {{ {element.put('(*cursor)')} }}"]


def iterator_loop(rng, array, element, n):
    return [f"{array}.resize({n});", "int i = 0;",
            f"for (auto it = {array}.begin(); it != {array}.end(); ++it, ++i) {{",
            f"  {element.put('(*it)')}", "}"]


def range_loop(rng, array, element, n):
    return [f"{array}.resize({n});", "int i = 0;",
            f"for ({element.cpp}& one : {array}) {{ {element.put('one')} ++i; }}"]


def transform(rng, array, element, n):
    return [f"const std::vector<{element.cpp}> source = fuzz::elements<{element.cpp}>({n}, k);",
            f"{array}.resize({n});",
            f"std::copy(source.begin(), source.end(), {array}.begin());"]


def back_inserter(rng, array, element, n):
    return [f"const std::vector<{element.cpp}> source = fuzz::elements<{element.cpp}>({n}, k);",
            f"std::copy(source.begin(), source.end(), std::back_inserter({array}));"]


def at_and_back(rng, array, element, n):
    return [f"{array}.resize({n} + 2);", f"{element.put(array + '.at(1)', '1')}",
            f"{element.put(array + '.back()', '2')}"]


def loop_over_vector(rng, array, element, n):
    """Nothing of a library is called between resize and the last element."""
    return [f"const std::vector<{element.cpp}> source = fuzz::elements<{element.cpp}>({n}, k);",
            f"{array}.resize({n});", f"for (int i = 0; i < {n}; ++i) {array}[i] = source[i];"]


def loop_of_numbers(rng, array, element, n):
    number = element.cpp if not element.fields else "double"
    target = "one" if not element.fields else f"one.{element.fields[0]}"
    return [f"{array}.resize({n});", f"for (auto& one : {array}) {target} = static_cast<{number}>(k + 3);"]


def computing_loop(rng, array, element, n):
    """Each element is computed in numbers of the loop's own; or it seems so, and some are left as they are."""
    if element.fields:
        return resize_and_index(rng, array, element, n)
    number, at = element.cpp, f"{array}[i]"
    given = f"static_cast<{number}>(source[i])"
    rounds = rng.choice([
        [f"{number} one = {given};", f"if (one > 9) one = {element.value('3')};", f"{at} = one;"],
        [f"{number} one;", f"one = {given};", f"if (i % 3 == 1) {{ {at} = one; }} else {at} = 5;"],
        [f"const {number} one = {given};", f"if (one > 5) {at} = one;"],
        ["if (i % 3) continue;", f"{at} = {given};"],
        [f"{number} one = {given};", f"if ({at} > one) one = {at};", f"{at} = one;"],
        [f"{at} = 2;", "if (i == 4) break;"],
        ["const int low = source[i] > 3 ? 1 : 0;", f"if (low) {at} = 1; else if (i > 2) {at} = 0;"],
        [f"if (i % 2) {{ {at} = 4; }} else {{ const int i = 0; {at} = 6; }}"],
    ])
    return ([f"const std::vector<{number}> source = fuzz::elements<{number}>({n}, k);", f"{array}.resize({n});",
             f"for (int i = 0; i < {n}; ++i) {{"] + ["  " + line for line in rounds] + ["}"])


def reference_to_array(rng, array, element, n):
    return [f"auto& named = {array};", f"named.resize({n});",
            f"for (std::size_t i = 0; i < named.size(); ++i) {{ {element.put('named[i]')} }}"]


def vector_reference(rng, array, element, n):
    return [f"std::vector<{element.cpp}>& named = {array};", f"named.resize({n});",
            f"for (std::size_t i = 0; i < named.size(); ++i) {{ {element.put('named[i]')} }}"]


def library_takes_vector(rng, array, element, n):
    return [f"fuzz::fill({array}, {n}, k);"]


def emplace_back(rng, array, element, n):
    return [f"for (int i = 0; i < {n}; ++i) {array}.emplace_back({element.value()});"]


def read_behind_resize(rng, array, element, n):
    """What a message of the step before has left there, or zero."""
    return [f"{array}.resize({n} + 3);", f"{array}[0] = {array}[1];", f"{array}[{n} + 1] = {array}[{n}];",
            f"{element.put(array + '[1]', '1')}"]


def insert_at_begin(rng, array, element, n):
    return [f"if ({array}.size() > 300) {array}.clear();", f"{array}.insert({array}.begin(), {element.value('2')});",
            f"if ({array}.size() > 3) std::rotate({array}.begin(), {array}.begin() + 2, {array}.end());"]


def erase_some(rng, array, element, n):
    return [f"{array}.resize({n} + 4);", f"{element.put(array + '[2]', '2')}",
            f"{array}.erase({array}.begin(), {array}.begin() + 2);"]


WAYS = {resize_and_index: 6, resize_one_line: 2, resize_and_part: 3, resize_only: 1, resize_and_copy: 3,
        resize_and_copy_part: 2, push_back: 4, clear_reserve_push: 2, assign_value: 2, assign_range: 2, whole_vector: 3,
        made_vector: 3, swap_vector: 1, insert_range: 1, shrinks: 2, raw_pointer: 2, iterator_loop: 1, range_loop: 1,
        transform: 1, loop_over_vector: 2, loop_of_numbers: 1, computing_loop: 3, back_inserter: 1, at_and_back: 1,
        reference_to_array: 1, vector_reference: 1, library_takes_vector: 1, emplace_back: 1, read_behind_resize: 2,
        insert_at_begin: 1, erase_some: 1}


def in_block(lines):
    return ["{"] + ["  " + line for line in lines] + ["}"]


def fill(rng, message, access, size_seed):
    """Statements that fill the arrays of a message, each in a block of its own."""
    lines = [f"const int n{size_seed} = fuzz::size(k, {size_seed});"]
    for field, element in message.arrays:
        if field != message.arrays[0][0] and rng.random() < 0.3:
            continue
        way = rng.choices(list(WAYS), list(WAYS.values()))[0]
        lines += in_block(way(rng, access + field, element, f"n{size_seed}"))
    return lines


def change(rng, message, access):
    """Statements that change a message after it was published."""
    field, element = rng.choice(message.arrays)
    array = access + field
    ways = [
        [f"{array}.push_back({element.value('5')});"],
        [f"if (!{array}.empty()) {{ {element.put(array + '[0]', '9')} }}"],
        [f"{array}.clear();"],
        [f"{array}.resize({array}.size() + 3);"],
        [f"{array}.resize({array}.size() / 2);"],
        [f"{array}.assign(6, {element.value('8')});"],
        [f"for (auto& one : {array}) {{ {element.put('one', '4')} }}"],
        fill(rng, message, access, rng.randrange(100, 200)),
    ]
    if message.header:
        ways.append([f'{access}header.frame_id = "again";'])
    return rng.choice(ways)
