# SPDX-License-Identifier: BSD-3-Clause
"""Adversarial programs: who points into a message's data, how that is stored, and when it is used, composed with
publishing. What is written through an old pointer after a publish shows in the next message, which must be the same
before and after the port; messages that subscribers keep must not change. Others attack what is inserted for the port, by messages that are not there in every step, that are
named by expressions which do something, or that other threads fill or read."""
from . import absent, added, changes, copied, effects, keepers, later, messages, names, outputs, owners, pointers, readers, subscribers, times
from . import waits
from .publishers import in_block
from .uses import Use

HIDDEN = outputs.HIDDEN + copied.WAYS
PLAIN = [message for message in messages.ALL if not message.arrays[0][1].fields and "." not in message.arrays[0][0]]


class Attack:
    """One message that is pointed into, with what publishes it."""

    def __init__(self, program, owner, store, transfer, output):
        self.program, self.message = program, program.rng.choice(PLAIN)
        field, element = self.message.arrays[0]
        self.element = element.cpp
        written = "unsigned char" if store is pointers.as_bytes else element.cpp
        self.value = f"static_cast<{written}>(fuzz::value(3, k))"
        self._published = len(program.topics)
        self._output = output(program, self.message)
        owned = owner(program, self.message)
        self.declare, self.fill = owned.lines, self._contents(owned, field, element)
        if program.rng.random() < 0.6:  # so that no library is called while the handle lives
            self.declare = self.declare + [f"const {written} known = {self.value};"]
            self.value = "known"
        self._taken, self._owned = transfer(self.message, owned)
        self.array = f"{self._owned.access}{field}"
        points = pointers.plain_reference if program.rng.random() < 0.5 else pointers.reference
        source = points(program, self.message, owned.access, element.cpp)
        self._handle = store(program, element.cpp, source, f"{owned.access}{field}")

    def _contents(self, owned, field, element):
        array = f"{owned.access}{field}"
        return self.message.set_meta(owned.access) + [
            f"{array}.reserve(64);", f"{array}.resize({pointers.COUNT});", f"for (int i = 0; i < {pointers.COUNT}; ++i) {{",
            f"  {element.put(array + '[i]')}", "}"]

    def make(self):
        return self._handle.lines + self._taken

    def write(self, index, value=None):
        return self._handle.write(index, value or self.value)

    def read(self, index):
        """An expression; none where the handle can only be written through."""
        return self._handle.read(index)

    def send(self):
        return self._output.publish(self._owned.argument, self._owned.pointer)

    def topics(self):
        return self.program.topics[self._published:]


# They refer to the array, which is empty after its elements were taken.
TO_ARRAY = [pointers.array_reference, pointers.pointer_to_array, keepers.closure_over_message]


def choose(program):
    """Owner, store, what takes the elements over, output and time. Half of them are what an honest program might do, so
    that they are ported, and the analysis has to be right about them."""
    rng = program.rng
    if rng.random() < 0.5:
        stores = pointers.LOCAL + [keepers.by_function, keepers.closure_over_message]
        return (rng.choice(owners.FRESH if rng.random() < 0.7 else owners.OWNERS), rng.choice(stores), owners.unchanged,
                rng.choice(outputs.PLAIN if rng.random() < 0.8 else HIDDEN), rng.choice(times.HARMLESS))
    store = rng.choice(pointers.STORES if rng.random() < 0.6 else keepers.STORES)
    owner = rng.choice(owners.OWNERS)
    output = rng.choice(outputs.PLAIN if rng.random() < 0.5 else HIDDEN)
    if rng.random() < 0.25 and store not in TO_ARRAY + keepers.WRITE_AT_END:
        return owner, store, rng.choice(owners.TRANSFERS), output, rng.choice(times.ONCE)
    return owner, store, owners.unchanged, output, rng.choice(times.ONCE + times.ANEW)


def somewhere(program, lines):
    """In the step, in a function of its own, or in a closure."""
    where = program.rng.random()
    if where < 0.25:
        return [f"{program.helper('void', 'attack', 'int k', lines)}(k);"]
    if where < 0.35:
        return ["[&] {"] + ["  " + line for line in lines] + ["}();"]
    return in_block(lines)


def attack(program):
    owner, store, transfer, output, time = choose(program)
    one = Attack(program, owner, store, transfer, output)
    program.steps += somewhere(program, one.declare + one.fill + time(one))
    label(program, one.topics(), {"owner": owner, "store": store, "transfer": transfer, "output": output, "time": time}.items())


def in_next_step(program):
    """What was pointed into in one step is written in the next one, before the message is published again."""
    owner, output = program.rng.choice(owners.LASTING), program.rng.choice(outputs.PLAIN + HIDDEN)
    one = Attack(program, owner, pointers.in_variable, owners.unchanged, output)
    known = program.variable("bool", "known", " = false")
    use = [f"if ({known}) {{"] + ["  " + line for line in one.write(1)] + ["}"]
    if program.rng.random() < 0.5:
        fill = one.fill + use
    else:
        fill = use + [f"if (!{known}) {{"] + ["  " + line for line in one.fill] + ["}"]
    program.steps += somewhere(program, one.declare + fill + one.send() + one.make() + [f"{known} = true;"])
    label(program, one.topics(), {"owner": owner, "output": output, "time": in_next_step}.items())


REACHES = {"made": absent.MADE, "held": absent.HELD, "effect": effects.WAYS, "wait": waits.WAYS,
           "reader": readers.WAYS}


def reach(program):
    """A message that is made, held, named, waited for or read by others as the port must respect it."""
    kind = program.rng.choice(list(REACHES))
    way = program.rng.choice(REACHES[kind])
    output = outputs.directly
    if program.rng.random() < 0.6:
        output = program.rng.choice(outputs.PLAIN if program.rng.random() < 0.6 else HIDDEN)
    published = len(program.topics)
    use = Use(program, program.rng.choice(PLAIN), output)
    program.steps += somewhere(program, way(use))
    label(program, program.topics[published:], {kind: way, "output": output}.items())


def named(program):
    """A lasting message that is filled under one name and published under another, twice in each step."""
    published = len(program.topics)
    one = Use(program, program.rng.choice(PLAIN), outputs.directly)
    known = names.Names(program, program.rng.choice(names.HOMES), one.message.cpp)
    for body in [lambda name: one.fill(f"{name}."), one.send] * 2:
        program.steps += in_block(known.use(body))
    label(program, program.topics[published:], known.chosen)


def lasting(program, kind):
    """A lasting message is let go and filled as the class says: changes.Change, later.Later."""
    published = len(program.topics)
    one = Use(program, program.rng.choice(PLAIN), outputs.directly)
    use = kind(program, one.message)
    program.steps += in_block(use.lines(one.send))
    label(program, program.topics[published:], use.chosen)


def adds(program):
    """Elements of an array of messages are added."""
    published = len(program.topics)
    program.includes.add("sensor_msgs/ChannelFloat32.h")
    body, chosen = added.lines(program, added.use(program).send)
    program.steps += somewhere(program, body)
    label(program, program.topics[published:], chosen)


def label(program, topics, chosen):
    traits = [f"{what}: {which.__name__}" for what, which in chosen]
    program.traits += traits
    for topic in topics:
        topic.traits = traits


STANDARD = {"any", "array", "atomic", "boost/thread.hpp", "boost/weak_ptr.hpp", "condition_variable", "deque", "functional",
            "future", "list", "memory", "mutex", "numeric", "optional", "shared_mutex", "sstream", "thread", "tuple", "utility", "variant"}


def make(program):
    program.includes |= STANDARD
    for _ in range(program.rng.choice([2, 3])):
        chance = program.rng.random()
        if chance < 0.08:
            in_next_step(program)
        elif chance < 0.18:
            named(program)
        elif chance < 0.24:
            lasting(program, changes.Change)
        elif chance < 0.3:
            lasting(program, later.Later)
        elif chance < 0.36:
            adds(program)
        elif chance < 0.58:
            reach(program)
        else:
            attack(program)
    for topic in program.topics:
        subscribers.keep(program, topic)
    return program
