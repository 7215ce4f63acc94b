# SPDX-License-Identifier: BSD-3-Clause
"""How adversarial programs publish: directly, and through all that may hide a publish call. Each output is made for a
topic and returns the statements that publish a message."""
from . import libraries, messages, publishers
from .publishers import in_block


class Output:
    """Publishes through `send`, a function of (argument, pointer) that returns statements."""

    def __init__(self, send):
        self.publish = send


def value_of(argument, pointer):
    return f"*{argument}" if pointer else argument


def stored(program, message):
    """A publisher as ordinary programs have it."""
    homes = [publishers.member, publishers.member, publishers.initialized_member, publishers.in_vector,
             publishers.in_map, publishers.in_array, publishers.by_shared_pointer, publishers.in_struct]
    topic = program.topic(message)
    if message is messages.IMAGE and program.rng.random() < 0.3:
        return libraries.transport(program, topic)
    publisher = program.rng.choice(homes)(program, topic)[0]
    if program.rng.random() < 0.4:
        return publisher
    # Nothing of a library stands behind the publish call.
    publish = publisher.publish
    publisher.publish = lambda argument, pointer=False: publish(argument, pointer)[::-1]
    return publisher


def directly(program, message):
    return stored(program, message)


def within(begin, end):
    """An output that puts the publish call between two lines."""
    def output(program, message):
        publisher = stored(program, message)
        return Output(lambda argument, pointer=False:
                      [begin] + ["  " + line for line in publisher.publish(argument, pointer)] + [end])
    return output


in_branch = within("if (fuzz::value(7, k) % 3 != 0) {", "}")
in_closure_called_at_once = within("[&] {", "}();")
in_handler = within("try { throw 1; } catch (int) {", "}")
in_loop_once = within("do {", "} while (false);")
in_thread = within("std::thread([&] {", "}).join();")
in_deleter = within("boost::shared_ptr<void>(static_cast<void*>(nullptr), [&](void*) {", "});")
in_algorithm = within("std::for_each(fuzz::once.begin(), fuzz::once.end(), [&](int) {", "});")
in_foreign_call = within("fuzz::call([&] {", "});")


def in_queued_callback(program, message):
    publisher = stored(program, message)
    return Output(lambda argument, pointer=False: ["fuzz::later([&] {"] + publisher.publish(argument, pointer) +
                  ["});", "ros::spinOnce();"])


def twice(program, message):
    publisher = stored(program, message)
    return Output(lambda argument, pointer=False: publisher.publish(argument, pointer) * 2)


def two_publishers(program, message):
    both = [stored(program, message), stored(program, message)]
    return Output(lambda argument, pointer=False:
                  both[0].publish(argument, pointer) + both[1].publish(argument, pointer))


def either_publisher(program, message):
    both = [stored(program, message), stored(program, message)]
    return Output(lambda argument, pointer=False: ["if (k % 2) {", *both[0].publish(argument, pointer), "} else {",
                                                   *both[1].publish(argument, pointer), "}"])


def beside_one_that_is_not_advertised(program, message):
    """The publisher that is named first never gets a topic."""
    topic = program.topic(message)
    idle = program.variable("ros::Publisher", "idle")
    program.setup.append(f"if (fuzz::value(0, 1) < 0) {idle} = {publishers.advertise(program, topic, 0)};")
    first, second = publishers.Publisher(f"{idle}.", topic), publishers.member(program, topic)[0]
    return Output(lambda argument, pointer=False: [f"if ({idle}) {{", *first.publish(argument, pointer), "} else {",
                                                   *second.publish(argument, pointer), "}"])


def beside_a_null_pointer(program, message):
    """Pointers to two publishers, the first of which stays null."""
    idle = program.variable("boost::shared_ptr<ros::Publisher>", "idle")
    topic = program.topic(message)
    first, second = publishers.Publisher(f"{idle}->", topic), publishers.by_shared_pointer(program, topic)[0]
    return Output(lambda argument, pointer=False: [f"if ({idle}) {{", *first.publish(argument, pointer), "} else {",
                                                   *second.publish(argument, pointer), "}"])


def in_helper(program, message, inner=None):
    publisher = inner or stored(program, message)

    def send(argument, pointer=False):
        kind = f"const {message.cpp}{'Ptr' if pointer else ''}& msg"
        name = program.helper("void", "send", kind, publisher.publish("msg", pointer))
        return [f"{name}({argument});"]

    return Output(send)


def in_helper_of_helper(program, message):
    return in_helper(program, message, in_helper(program, message))


def in_bound_helper(program, message):
    publisher = stored(program, message)

    def send(argument, pointer=False):
        name = program.helper("void", "send", f"const {message.cpp}& msg", publisher.publish("msg"))
        what = f"&Node::{name}, this" if program.is_class else f"&{name}"
        return [f"boost::bind({what}, boost::cref({value_of(argument, pointer)}))();"]

    return Output(send)


def in_member_pointer(program, message):
    publisher = stored(program, message)

    def send(argument, pointer=False):
        name = program.helper("void", "send", f"const {message.cpp}& msg", publisher.publish("msg"))
        call, owner, this = ("(this->*call)", "Node::*", "&Node::") if program.is_class else ("call", "*", "&")
        return in_block([f"void ({owner}call)(const {message.cpp}&) = {this}{name};",
                         f"{call}({value_of(argument, pointer)});"])

    return Output(send)


def in_template_argument(program, message):
    """By a pointer that the compiler knows: its call has a callee, and no name."""
    publisher = stored(program, message)
    call = program.unique("call")
    owner = "Object::*" if program.is_class else "*"
    program.prelude += ["template <class Object, class Argument, void (OWNERfunction)(Argument)>".replace("OWNER", owner),
                        f"void {call}(Object& object, Argument argument) {{",
                        f"  {'(object.*function)' if program.is_class else '(void)object, function'}(argument);", "}"]

    def send(argument, pointer=False):
        name = program.helper("void", "send", f"const {message.cpp}& msg", publisher.publish("msg"))
        kind, this = ("Node", "*this") if program.is_class else ("const int", "0")
        function = f"&Node::{name}" if program.is_class else f"&{name}"
        return [f"{call}<{kind}, const {message.cpp}&, {function}>({this}, {value_of(argument, pointer)});"]

    return Output(send)


def in_function_member(program, message):
    publisher = stored(program, message)
    kept = program.variable(f"std::function<void(const {message.cpp}&)>", "send")
    program.setup += [f"{kept} = [&](const {message.cpp}& msg) {{", *publisher.publish("msg"), "};"]
    return Output(lambda argument, pointer=False: [f"{kept}({value_of(argument, pointer)});"])


def in_template(program, message):
    publisher = stored(program, message)
    name = program.unique("send")
    program.prelude += ["template <class P, class M>", f"void {name}(P& out, const M& msg) {{", "  out.publish(msg);", "}"]
    sent = f'fuzz::sent("{publisher.topic.name}");'
    out = publisher.call[:-1] if publisher.call.endswith(".") else f"*{publisher.call[:-2]}"
    return Output(lambda argument, pointer=False: [f"{name}({out}, {value_of(argument, pointer)});", sent])


def class_output(program, message, head, body):
    """An object of a class of the program that has the publisher; its name and its class."""
    topic = program.topic(message)
    kind = program.unique("Sender")
    program.prelude += [line.replace("KIND", kind).replace("MESSAGE", message.cpp) for line in head]
    program.prelude += [line.replace("KIND", kind).replace("MESSAGE", message.cpp).replace(
        "PUBLISH", f'out.publish(msg); fuzz::sent("{topic.name}");') for line in body]
    name = program.variable(kind, "sender")
    program.setup.append(f"{name}.out = {publishers.advertise(program, topic)};")
    return name, kind


def in_virtual_call(program, message):
    name, kind = class_output(program, message, [
        "struct KINDBase {", "  virtual ~KINDBase() {}", "  virtual void send(const MESSAGE& msg) = 0;", "};"], [
        "struct KIND : KINDBase {", "  void send(const MESSAGE& msg) override { PUBLISH }", "  ros::Publisher out;", "};"])
    return Output(lambda argument, pointer=False:
                  [f"static_cast<{kind}Base&>({name}).send({value_of(argument, pointer)});"])


def in_operator(program, message):
    name, _ = class_output(program, message, [], [
        "struct KIND {", "  ros::Publisher out;", "  KIND& operator<<(const MESSAGE& msg) {", "    PUBLISH",
        "    return *this;", "  }", "};"])
    return Output(lambda argument, pointer=False: [f"{name} << {value_of(argument, pointer)};"])


def in_base_template(program, message):
    name, _ = class_output(program, message, [
        "template <class D>", "struct KINDBase {",
        "  void emit(const MESSAGE& msg) { static_cast<D*>(this)->send(msg); }", "};"], [
        "struct KIND : KINDBase<KIND> {", "  ros::Publisher out;", "  void send(const MESSAGE& msg) { PUBLISH }", "};"])
    return Output(lambda argument, pointer=False: [f"{name}.emit({value_of(argument, pointer)});"])


def ended(program, message, base, lines):
    """An output in the destructor of a class, whose objects end in lines that are made of the class's name and what makes one."""
    name, kind = class_output(program, message, [], [
        "struct KIND {", "  ros::Publisher out;", "};", "struct KINDBase {", "  virtual ~KINDBase() {}", "};",
        f"struct KINDEnd{base} {{", "  KINDEnd(KIND& s, const MESSAGE& m) : sender(s), msg(m) {}",
        "  KINDEnd(const KINDEnd&) = delete;", "  KINDEnd& operator=(const KINDEnd&) = delete;",
        "  KIND& sender;", "  const MESSAGE& msg;", "  ~KINDEnd() { sender.PUBLISH }", "};"])
    return Output(lambda argument, pointer=False: in_block(lines(kind, f"{name}, {value_of(argument, pointer)}")))


def in_destructor(program, message):
    return ended(program, message, "", lambda kind, made: [f"{kind}End end{{{made}}};", "(void)end;"])


def in_end_of_element(program, message):
    """What ends is held by an object of a library."""
    return ended(program, message, "", program.rng.choice([
        lambda kind, made: [f"std::optional<{kind}End> end;", f"end.emplace({made});"],
        lambda kind, made: [f"std::list<{kind}End> ends;", f"ends.emplace_back({made});"],
        lambda kind, made: [f"const auto end = std::make_unique<{kind}End>({made});"]]))


def in_end_of_derived(program, message):
    """A pointer to its base class ends it."""
    return ended(program, message, " : KINDBase", program.rng.choice([
        lambda kind, made: [f"{kind}Base* end = new {kind}End({made});", "delete end;"],
        lambda kind, made: [f"const std::unique_ptr<{kind}Base> end(new {kind}End({made}));"]]))


def in_cleanup(program, message):
    """GCC's own: a function that is called where the scope of a variable ends."""
    name, kind = class_output(program, message, [], [
        "struct KIND {", "  ros::Publisher out;", "  const MESSAGE* kept = nullptr;", "};",
        "inline void closeKIND(KIND** sender) {", "  const MESSAGE& msg = *(*sender)->kept;", "  (*sender)->PUBLISH", "}"])
    return Output(lambda argument, pointer=False: [f"{name}.kept = &{value_of(argument, pointer)};"] + in_block(
        [f"__attribute__((cleanup(close{kind}))) {kind}* sender = &{name};", "(void)sender;"]))


def in_caught_copy(program, message):
    """A handler copies what it catches by value."""
    name, kind = class_output(program, message, [], [
        "struct KIND {", "  ros::Publisher out;", "};", "struct KINDError {", "  KIND* sender;", "  const MESSAGE* sent;",
        "  KINDError(KIND* s, const MESSAGE* m) : sender(s), sent(m) {}",
        "  KINDError(const KINDError& other) : sender(other.sender), sent(other.sent) {",
        "    const MESSAGE& msg = *sent;", "    sender->PUBLISH", "  }", "};"])
    return Output(lambda argument, pointer=False: [
        f"try {{ throw {kind}Error(&{name}, &{value_of(argument, pointer)}); }} catch ({kind}Error error) {{ (void)error; }}"])


PLAIN = [directly, in_branch, in_loop_once, twice, two_publishers, either_publisher,
         beside_one_that_is_not_advertised, beside_a_null_pointer]
HIDDEN = [in_closure_called_at_once, in_handler, in_thread, in_deleter, in_algorithm, in_foreign_call,
          in_queued_callback, in_helper, in_helper_of_helper, in_bound_helper, in_member_pointer, in_template_argument,
          in_function_member, in_template, in_virtual_call, in_operator, in_base_template, in_destructor, in_end_of_element,
          in_end_of_derived, in_cleanup, in_caught_copy]
for name in ("in_branch", "in_closure_called_at_once", "in_handler", "in_loop_once", "in_thread", "in_deleter",
             "in_algorithm", "in_foreign_call"):
    globals()[name].__name__ = name
