# SPDX-License-Identifier: BSD-3-Clause
"""Messages that several threads read at once, at least one of them by publishing: nobody writes, so that nobody has to
wait. Each way is given the use and returns statements. What a reader saw that was not there is in the last message."""
from . import outputs, owners
from .uses import within

COUNT = 3000  # more than a page of every element type, and long enough for a publish to fall into a pass


def sum_up(element):
    return f"sum = sum * 31 + static_cast<std::uint64_t>({element}) + 1;"


# A pass over the array: statements that change `sum`
# ----------------------------------------------------------------------------------------------------------------------


def by_index(use, array):
    return [f"for (std::size_t i = 0; i < {array}.size(); ++i) {sum_up(array + '[i]')}"]


def by_at(use, array):
    return [f"for (std::size_t i = 0; i != {array}.size(); ++i) {sum_up(array + '.at(i)')}"]


def by_value(use, array):
    return [f"for (const {use.message.arrays[0][1].cpp} one : {array}) {sum_up('one')}"]


def by_reference(use, array):
    return [f"for (auto& one : {array}) {sum_up('one')}"]


def by_iterators(use, array):
    return [f"for (auto at = {array}.begin(); at != {array}.end(); ++at) {sum_up('*at')}"]


def by_const_iterators(use, array):
    return [f"for (auto at = {array}.cbegin(); at != {array}.cend(); ++at) {sum_up('*at')}"]


def by_pointers(use, array):
    return [f"const auto* at = {array}.data();", f"const auto* const last = at + {array}.size();",
            f"while (at != last) {{ {sum_up('*at++')} }}"]


def by_address(use, array):
    return [f"for (std::size_t i = 0; i < {array}.size(); ++i) {sum_up(f'*(&{array}[0] + i)')}"]


def by_algorithm(use, array):
    return [f"sum = std::accumulate({array}.begin(), {array}.end(), sum, [](std::uint64_t sum, auto one) {{",
            "  return sum * 31 + static_cast<std::uint64_t>(one) + 1;", "});"]


def by_message_parameter(use, array):
    access, field = array[:-len(use.message.arrays[0][0])], use.message.arrays[0][0]
    name = use.program.helper("std::uint64_t", "total", f"const {use.message.cpp}& whole",
                              ["std::uint64_t sum = 0;", f"for (const auto one : whole.{field}) {sum_up('one')}",
                               "return sum;"], pure=True)
    return [f"sum = {name}({'*' if access.endswith('->') else ''}{access.rstrip('.->')});"]


def by_copy(use, array):
    return [f"const std::vector<{use.message.arrays[0][1].cpp}> all = {array};", f"for (auto one : all) {sum_up('one')}"]


def by_ends(use, array):
    return [f"sum = static_cast<std::uint64_t>({array}.front()) * 7 + static_cast<std::uint64_t>({array}.back());",
            f"sum += {array}.end() - {array}.begin();"]


PASSES = [by_index, by_at, by_value, by_reference, by_iterators, by_const_iterators, by_pointers, by_address,
          by_algorithm, by_message_parameter, by_copy, by_ends]


# The readers
# ----------------------------------------------------------------------------------------------------------------------


def filled(use):
    """A message with its content; most of them are there in the next step, too."""
    lasting = use.rng.random() < 0.7
    owned = use.rng.choice(owners.LASTING if lasting else [owners.local, owners.shared])(use.program, use.message)
    array = f"{owned.access}{use.message.arrays[0][0]}"
    return owned, array, owned.lines + fill(use, owned.access)


def fill(use, access):
    field, element = use.message.arrays[0]
    array, loop = f"{access}{field}", f"for (int i = 0; i < {COUNT}; ++i)"
    return use.message.set_meta(access) + use.rng.choice([
        [f"{array}.resize({COUNT});", f"{loop} {{ {element.put(array + '[i]')} }}"],
        [f"{array} = fuzz::elements<{element.cpp}>({COUNT}, k);"],
        [f"{array}.clear();", f"{loop} {array}.push_back({element.value()});"]])


def read_once(use, array):
    return ["std::uint64_t sum = 0;"] + use.rng.choice(PASSES)(use, array)


def told(use, owned, array):
    """What the readers saw becomes part of the message."""
    number = "wrong.load() == 0 ? seen.load() % 50 : 99"
    return ([f"{array}[0] = static_cast<{use.message.arrays[0][1].cpp}>({number});"] +
            use.send(owned.argument, owned.pointer))


WATCH = ["std::atomic<bool> done(false);", "std::atomic<int> wrong(0);", "std::atomic<std::uint64_t> seen(0);"]


def again_and_again(look):
    """A reader's body: the same until the publisher's thread has had enough. `look` are statements that make `sum`.
    Each reader compares with what it saw itself: two readers' sums may well differ, and adding them has no order."""
    compared = look + ["if (!first && sum != before) ++wrong;", "before = sum;", "first = false;"]
    return (["bool first = true;", "std::uint64_t before = 0;"] +
            within("do {", within("{", compared) + ["std::this_thread::yield();"], "} while (!done);") +
            ["seen += before;"])


def passes(use, array, guard=()):
    return again_and_again(list(guard) + read_once(use, array))


def publish_meanwhile(use, owned, guard=()):
    once = within("{", list(guard) + use.send(owned.argument, owned.pointer)) if guard else use.send(
        owned.argument, owned.pointer)
    return once + ["fuzz::pause();"] + once


def while_it_is_published(use):
    owned, array, lines = filled(use)
    thread = use.rng.choice(["std::thread", "boost::thread"])
    return (lines + WATCH + within(f"{thread} reader([&] {{", passes(use, array), "});") + ["fuzz::pause();"] +
            publish_meanwhile(use, owned) + ["done = true;", "reader.join();"] + told(use, owned, array))


def by_two_at_once(use):
    owned, array, lines = filled(use)
    readers = [line for name in ("one", "two")
               for line in within(f"std::thread reader_{name}([&] {{", passes(use, array), "});")]
    return (lines + WATCH + readers + publish_meanwhile(use, owned) +
            ["done = true;", "reader_one.join();", "reader_two.join();"] + told(use, owned, array))


def under_a_shared_lock(use):
    owned, array, lines = filled(use)
    kind, shared = use.rng.choice([("boost::shared_mutex", "boost::shared_lock<boost::shared_mutex>"),
                                   ("std::shared_mutex", "std::shared_lock<std::shared_mutex>")])
    mutex = use.program.variable(kind, "mutex")
    guard = [f"{shared} lock({mutex});"]
    return (lines + WATCH + within("std::thread reader([&] {", passes(use, array, guard), "});") +
            publish_meanwhile(use, owned, guard) + ["done = true;", "reader.join();"] + told(use, owned, array))


def under_a_lock(use):
    owned, array, lines = filled(use)
    mutex = use.program.variable("std::mutex", "mutex")
    guard = [f"std::lock_guard<std::mutex> lock({mutex});"]
    return (lines + WATCH + within("std::thread reader([&] {", passes(use, array, guard), "});") +
            publish_meanwhile(use, owned, guard) + ["done = true;", "reader.join();"] + told(use, owned, array))


def under_locks_that_do_not_meet(use):
    """Each takes a lock, but not the same one, or not as long as it matters. Nobody writes, so nobody has to."""
    owned, array, lines = filled(use)
    mutex = use.program.variable("std::mutex", "mutex")
    other = use.program.variable("std::mutex", "other")
    lock = f"std::unique_lock<std::mutex> lock({mutex});"
    once, again = (use.send(owned.argument, owned.pointer) for _ in range(2))
    published = use.rng.choice([
        within("{", [f"std::lock_guard<std::mutex> lock({other});"] + once),
        ["{", "  " + lock, "  fuzz::pause();", "}"] + once,
        within("{", [lock, "lock.unlock();"] + once),
        within("{", [f"std::unique_lock<std::mutex> lock({mutex}, std::defer_lock);"] + once),
        within("{", [f"{mutex}.lock();", "fuzz::pause();", f"{mutex}.unlock();"] + once)])
    return (lines + WATCH + within("std::thread reader([&] {", passes(use, array, [lock]), "});") + ["fuzz::pause();"] +
            published + ["fuzz::pause();"] + again + ["done = true;", "reader.join();"] + told(use, owned, array))


def after_writing_and_telling(use):
    """The other thread fills the message, says that it is there, and goes on reading."""
    owned = use.rng.choice(owners.LASTING)(use.program, use.message)
    array = f"{owned.access}{use.message.arrays[0][0]}"
    body = fill(use, owned.access) + ["ready = true;"] + passes(use, array)
    return (owned.lines + WATCH + ["std::atomic<bool> ready(false);"] +
            within("std::thread reader([&] {", body, "});") + ["while (!ready) std::this_thread::yield();"] +
            publish_meanwhile(use, owned) + ["done = true;", "reader.join();"] + told(use, owned, array))


def after_the_publish(use):
    """Two threads read what was published before; nobody publishes meanwhile."""
    owned, array, lines = filled(use)
    readers = []
    for name in ("one", "two"):
        body = ["for (int turn = 0; turn < 3; ++turn) {"] + read_once(use, array)[1:]
        body = ["std::uint64_t sum = 0, before = 0;", "while (!done) std::this_thread::yield();"] + body + [
            "  if (turn != 0 && sum != before) ++wrong;", "  before = sum;", "  sum = 0;", "}"]
        readers += within(f"std::thread reader_{name}([&] {{", body, "});")
    return (lines + WATCH + use.send(owned.argument, owned.pointer) + readers +
            ["done = true;", "reader_one.join();", "reader_two.join();"] + told(use, owned, array))


def by_a_function(use):
    """Of the program, which can name the message."""
    owned = use.rng.choice([owners.kept, owners.kept_pointer_made_once, owners.in_struct, owners.behind_accessor])(
        use.program, use.message)
    array = f"{owned.access}{use.message.arrays[0][0]}"
    name = use.program.helper("std::uint64_t", "look", "", read_once(use, array) + ["return sum;"])
    body = again_and_again([f"const std::uint64_t sum = {name}();"])
    return (fill(use, owned.access) + WATCH + within("std::thread reader([&] {", body, "});") +
            publish_meanwhile(use, owned) + ["done = true;", "reader.join();"] + told(use, owned, array))


def by_publishing(use):
    """Two threads publish one message."""
    owned, array, lines = filled(use)
    other = outputs.directly(use.program, use.message)
    worker = within("for (int turn = 0; turn < 3; ++turn) {", other.publish(owned.argument, owned.pointer))
    return (lines + within("std::thread worker([&] {", worker, "});") + use.send(owned.argument, owned.pointer) +
            use.send(owned.argument, owned.pointer) + ["worker.join();"])


WAYS = [while_it_is_published, by_two_at_once, under_a_shared_lock, under_a_lock, under_locks_that_do_not_meet,
        after_writing_and_telling, after_the_publish, by_a_function, by_publishing]
