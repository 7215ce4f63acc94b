# SPDX-License-Identifier: BSD-3-Clause
"""Messages that another thread fills: nothing may be inserted in front of what the publisher's thread waits for. Each way
is given the use and returns statements. The other thread takes its time, so that what comes too early shows."""
from . import owners
from .uses import within


def message_of(use):
    """Statements and an owner: half of them members."""
    lasting = use.rng.random() < 0.6
    return use.rng.choice(owners.LASTING if lasting else [owners.local, owners.shared])(use.program, use.message)


def slowly(use, owned):
    """Fills the message with a pause at its begin and in its midst."""
    array = f"{owned.access}{use.message.arrays[0][0]}"
    element = use.message.arrays[0][1]
    return (["fuzz::pause();"] + use.fill(owned.access) + [f"{array}.resize(40);"] +
            within("for (int i = 0; i < 40; ++i) {", ["if (i == 20) fuzz::pause();", element.put(f"{array}[i]")]))


def by_join(use):
    owned = message_of(use)
    thread = use.rng.choice(["std::thread", "boost::thread"])
    return (owned.lines + within(f"{thread} worker([&] {{", slowly(use, owned), "});") + ["worker.join();"] +
            use.send(owned.argument, owned.pointer))


def by_join_of_temporary(use):
    owned = message_of(use)
    return (owned.lines + within("std::thread([&] {", slowly(use, owned), "}).join();") +
            use.send(owned.argument, owned.pointer))


def by_end_of_scope(use):
    """The last owner of the thread joins it."""
    owned = message_of(use)
    inner = within("const auto filled = std::async(std::launch::async, [&] {", slowly(use, owned), "});")
    return owned.lines + within("{", inner) + use.send(owned.argument, owned.pointer)


def by_future(use):
    owned = message_of(use)
    wait = use.rng.choice(["filled.get();", "filled.wait();"])
    return (owned.lines + within("auto filled = std::async(std::launch::async, [&] {", slowly(use, owned), "});") +
            [wait] + use.send(owned.argument, owned.pointer))


def by_promise(use):
    owned = message_of(use)
    return (owned.lines + ["std::promise<int> filled;"] +
            within("std::thread worker([&] {", slowly(use, owned) + ["filled.set_value(1);"], "});") +
            ["filled.get_future().get();"] + use.send(owned.argument, owned.pointer) + ["worker.join();"])


def by_condition(use):
    owned = message_of(use)
    kind = use.rng.choice(["std", "boost"])
    body = slowly(use, owned) + [f"{kind}::unique_lock<{kind}::mutex> lock(mutex);", "ready = true;",
                                 "condition.notify_one();"]
    wait = use.rng.choice([["condition.wait(lock, [&] { return ready; });"],
                           ["while (!ready) condition.wait(lock);"]])
    inner = [f"{kind}::unique_lock<{kind}::mutex> lock(mutex);"] + wait + use.send(owned.argument, owned.pointer)
    return (owned.lines + [f"{kind}::mutex mutex;", f"{kind}::condition_variable condition;", "bool ready = false;"] +
            within("std::thread worker([&] {", body, "});") + within("{", inner) + ["worker.join();"])


def by_flag(use):
    owned = message_of(use)
    wait = use.rng.choice([["while (!ready) std::this_thread::yield();"],
                           ["while (!ready.load(std::memory_order_acquire)) {", "  fuzz::pause();", "}"]])
    return (owned.lines + ["std::atomic<bool> ready(false);"] +
            within("std::thread worker([&] {", slowly(use, owned) + ["ready = true;"], "});") + wait +
            use.send(owned.argument, owned.pointer) + ["worker.join();"])


def by_mutex(use):
    """The other thread has the lock first."""
    owned = message_of(use)
    guard = use.rng.choice(["std::lock_guard<std::mutex> lock(mutex);", "std::unique_lock<std::mutex> lock(mutex);",
                            "std::scoped_lock lock(mutex);"])
    body = ["std::lock_guard<std::mutex> lock(mutex);", "locked.set_value();"] + slowly(use, owned)
    return (owned.lines + ["std::mutex mutex;", "std::promise<void> locked;"] +
            within("std::thread worker([&] {", body, "});") + ["locked.get_future().wait();"] +
            within("{", [guard] + use.send(owned.argument, owned.pointer)) + ["worker.join();"])


def by_member_mutex(use):
    """Locked by functions of the program."""
    owned = message_of(use)
    mutex = use.program.variable("boost::mutex", "mutex")
    lock = use.program.helper("void", "lock", "", [f"{mutex}.lock();"])
    unlock = use.program.helper("void", "unlock", "", [f"{mutex}.unlock();"])
    body = [f"boost::mutex::scoped_lock lock({mutex});", "locked = true;"] + slowly(use, owned)
    return (owned.lines + ["std::atomic<bool> locked(false);"] + within("std::thread worker([&] {", body, "});") +
            ["while (!locked) std::this_thread::yield();", f"{lock}();"] + use.send(owned.argument, owned.pointer) +
            [f"{unlock}();", "worker.join();"])


def by_helper(use):
    """Whose body waits."""
    owned = message_of(use)
    name = use.program.helper("void", "finish", "std::thread& worker", ["worker.join();"], pure=True)
    return (owned.lines + within("std::thread worker([&] {", slowly(use, owned), "});") + [f"{name}(worker);"] +
            use.send(owned.argument, owned.pointer))


def in_parallel(use):
    """Several threads write elements of one array, which the message may have published before."""
    owned = message_of(use)
    array, element = f"{owned.access}{use.message.arrays[0][0]}", use.message.arrays[0][1]
    loop = "for (int i = part; i < 600; i += 3) { " + element.put(f"{array}[i]") + " }"
    starts = within("for (int part = 0; part < 3; ++part) {",
                    [f"workers.emplace_back([&, part] {{ {loop} }});"])
    return (owned.lines + use.message.set_meta(owned.access) + [f"{array}.resize(600);"] +
            ["std::vector<std::thread> workers;"] + starts + ["for (std::thread& one : workers) one.join();"] +
            use.send(owned.argument, owned.pointer))


def handed_over(use):
    """A thread fills one buffer, the publisher's takes it under a lock."""
    mutex = use.program.variable("std::mutex", "mutex")
    made = use.program.variable(use.pointer, "made")
    filler = [f"{use.pointer} msg = {use.make()};"] + slowly(use, owners.Owned([], "msg->", "msg", True))
    hand = [f"std::lock_guard<std::mutex> lock({mutex});", f"{made} = msg;"]
    take = [f"std::lock_guard<std::mutex> lock({mutex});", f"msg.swap({made});"]
    return (within("std::thread worker([&] {", filler + hand, "});") + [f"{use.pointer} msg;"] +
            within("while (!msg) {", take) + ["worker.join();"] + use.whole_pointer("msg"))


WAYS = [by_join, by_join_of_temporary, by_end_of_scope, by_future, by_promise, by_condition, by_flag, by_mutex,
        by_member_mutex, by_helper, in_parallel, handed_over]
