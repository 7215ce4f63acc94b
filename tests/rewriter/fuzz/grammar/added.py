# SPDX-License-Identifier: BSD-3-Clause
"""Messages that get elements of an array of messages (the channels of a PointCloud) after they were made, in every way that a vector
has. The arrays of some lie in shared memory, others are copied by publish, which the report's level has to say."""
from . import messages, outputs
from .program import indented
from .uses import Use, within

CLOUD = messages.Message("sensor_msgs/PointCloud", [("points", messages.POINT32)])
CHANNEL = "sensor_msgs::ChannelFloat32"
SIZE = 300

# Whose channels they are. Each returns (statements before, "msg." or "msg->", what publish is given, whether that is a pointer).
# ----------------------------------------------------------------------------------------------------------------------


def local_message(program):
    return [f"{CLOUD.cpp} msg;"], "msg.", "msg", False


def owned_message(program):
    return [f"{CLOUD.cpp}Ptr msg(new {CLOUD.cpp});"], "msg->", "msg", True


def lasting(begin):
    """A member or a global, which begins each step so."""
    def owner(program):
        name = program.variable(CLOUD.cpp, "cloud")
        return [begin.format(name)], f"{name}.", name, False
    return owner


def named(name, way):
    way.__name__ = name
    return way


OWNERS = [
    local_message, owned_message,
    named("emptied_message", lasting("{}.channels.clear();")),
    named("replaced_message", lasting(f"{{}} = {CLOUD.cpp}();")),
    named("grown_message", lasting("if ({0}.channels.size() > 5) {0}.channels.resize(1);")),
]

# How they are added. `channels` is an expression; each returns statements, which may need a channel that is filled: `made`.
# ----------------------------------------------------------------------------------------------------------------------


def simply(*statements):
    return lambda program, channels: [line.format(channels) for line in statements]


def filled(statement):
    """By what is done to each channel that is there."""
    def way(program, channels):
        index = [f"for (std::size_t c = 0; c < {channels}.size(); ++c) {channels}[c].values.assign({SIZE}, k + 0.5f);"]
        name = [f"for (auto& channel : {channels}) channel.values.assign({SIZE}, k + 0.5f);"]
        last = [f"{channels}.back().values.resize({SIZE}, 1.5f);"]
        return [statement.format(channels)] + program.rng.choice([index, name, last])
    return way


def by_function(program, channels):
    message = channels[:-len("->channels")] if "->" in channels else channels[:-len(".channels")]
    given = {"all": channels, "cloud.channels": f"*{message}" if "->" in channels else message}
    of = program.rng.choice(list(given))
    kind = {"all": f"std::vector<{CHANNEL}>& all", "cloud.channels": f"{CLOUD.cpp}& cloud"}[of]
    body = [f"{of}.resize(2);", f"{of}[1].values.assign({SIZE}, k + 0.5f);"]
    name = program.helper("void", "add", f"{kind}, int k", body, pure=True)
    return [f"{name}({given[of]}, k);"]


def by_name(kind):
    def way(program, channels):
        return [f"{kind} all = {channels};", "all.resize(2);", f"all[0].values.assign({SIZE}, k + 0.5f);"]
    return way


WAYS = [
    named("resized", filled("{}.resize(2);")),
    named("resized_by_variable", filled("{}.resize(1 + k % 2);")),
    named("resized_to_copies", simply("{0}.resize(2, made);")),
    named("emplaced", filled("{}.emplace_back();")),
    named("emplaced_copy", simply("{}.emplace_back(made);")),
    named("pushed", simply("{}.push_back(made);")),
    named("pushed_twice", simply("{0}.push_back(made);", "{0}.push_back({0}.front());")),
    named("pushed_by_move", simply("{}.push_back(std::move(made));")),
    named("pushed_in_loop", simply("for (int c = 0; c < 3; ++c) {}.push_back(made);")),
    named("inserted", simply("{0}.insert({0}.begin(), made);")),
    named("inserted_range", simply("{0}.insert({0}.end(), 2, made);")),
    named("assigned", simply("{}.assign(2, made);")),
    named("assigned_list", simply("{} = {{made, made}};")),
    named("assigned_vector", simply(f"const std::vector<{CHANNEL}> all(2, made);", "{} = all;")),
    named("moved_vector", simply(f"std::vector<{CHANNEL}> all(2, made);", "{} = std::move(all);")),
    named("swapped", simply(f"std::vector<{CHANNEL}> all(2, made);", "{}.swap(all);")),
    named("element_assigned", simply("{0}.resize(1);", "{0}[0] = made;")),
    named("element_moved", simply("{0}.resize(1);", "{0}[0] = std::move(made);")),
    named("element_swapped", simply("{0}.resize(1);", "std::swap({0}[0], made);")),
    named("values_moved", simply("{0}.resize(1);", "{0}[0].values = std::move(made.values);")),
    named("by_auto_name", by_name("auto&")),
    named("by_vector_name", by_name(f"std::vector<{CHANNEL}>&")),
    by_function,
]


def lines(program, send):
    """(statements, what was chosen)"""
    owner, way = program.rng.choice(OWNERS), program.rng.choice(WAYS)
    before, access, argument, pointer = owner(program)
    channels = f"{access}channels"
    added = way(program, channels)
    made = [f"{CHANNEL} made;", f"made.values.assign({SIZE}, 2.5f + k);", 'made.name = "made";'] if "made" in "".join(added) else []
    body = before + CLOUD.set_meta(access) + within("{", made + added)
    publish = send(argument, pointer)
    if program.rng.random() < 0.3:  # again, with one that is written to
        publish = publish + [f"if (!{channels}.empty() && !{channels}[0].values.empty()) {channels}[0].values[0] = 7.5f;"] + publish
    if program.rng.random() < 0.2:
        return within("for (int turn = 0; turn < 2; ++turn) {", body + publish), [("owner", owner), ("added", way)]
    return ["{"] + indented(body + publish) + ["}"], [("owner", owner), ("added", way)]


def use(program):
    return Use(program, CLOUD, outputs.directly)
