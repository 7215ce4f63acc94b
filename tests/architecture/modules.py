# SPDX-License-Identifier: BSD-3-Clause
"""The modules and what each may use: docs/architecture.md as data. The checks read it; change both together."""

# Module -> the modules whose headers it may include besides its own. A folder that is not here has no module: an error.
USES = {
    "runtime/posix": [],
    "runtime/sync_point": [],
    "runtime/statistics": ["runtime/posix"],
    "runtime/trace": ["runtime/posix"],
    "runtime/segment": ["runtime/posix", "runtime/sync_point"],
    "runtime/channel": ["runtime/segment", "runtime/posix"],
    "runtime/channel/wait": ["runtime/segment", "runtime/posix"],
    "runtime/channel/wire": ["runtime/segment", "runtime/posix", "runtime/sync_point", "runtime/trace", "runtime/channel",
                             "runtime/channel/wait"],
    "runtime/channel/connect": ["runtime/posix", "runtime/sync_point", "runtime/channel/wait", "runtime/channel/wire"],
    "runtime/channel/publish": ["runtime/segment", "runtime/posix", "runtime/sync_point", "runtime/trace", "runtime/channel",
                                "runtime/channel/wait", "runtime/channel/wire", "runtime/channel/connect"],
    "runtime/channel/subscribe": ["runtime/segment", "runtime/posix", "runtime/sync_point", "runtime/trace", "runtime/channel",
                                  "runtime/channel/wait", "runtime/channel/wire", "runtime/channel/connect"],
    "runtime/message": ["runtime/segment"],
    "runtime/roscpp": ["runtime/channel", "runtime/channel/wire", "runtime/message", "runtime/segment", "runtime/sync_point",
                       "runtime/statistics", "runtime/trace"],
    "runtime/adapters": ["runtime/roscpp", "runtime/message", "runtime/segment"],
    "runtime/preload": ["runtime/roscpp"],

    "tools/command_line": [],
    "tools/loopback": [],

    "msggen/model": [],
    "msggen/parse": ["msggen/model"],
    "msggen/emit": ["msggen/model"],
    "msggen/tool": ["msggen/model", "msggen/parse", "msggen/emit", "tools/command_line"],

    "rewriter/interruption": [],
    "rewriter/model": [],
    "rewriter/edits": ["rewriter/model"],
    "rewriter/transaction": ["rewriter/interruption", "rewriter/model", "rewriter/edits"],
    "rewriter/report": ["rewriter/model", "rewriter/edits"],
    "rewriter/cache": ["rewriter/model", "rewriter/edits"],
    "rewriter/buildfiles": ["rewriter/model", "rewriter/edits"],
    "rewriter/proof": ["rewriter/interruption", "rewriter/model", "rewriter/edits", "rewriter/buildfiles"],
    "rewriter/rules": [],
    "rewriter/solve": ["rewriter/model"],
    "rewriter/parse": ["rewriter/model", "rewriter/edits", "rewriter/buildfiles"],
    "rewriter/facts/syntax": ["rewriter/model", "rewriter/rules", "rewriter/parse"],
    "rewriter/facts/flow": ["rewriter/model", "rewriter/rules", "rewriter/parse", "rewriter/facts/syntax"],
    "rewriter/facts/sites": ["rewriter/model", "rewriter/rules", "rewriter/parse", "rewriter/facts/syntax", "rewriter/facts/flow"],
    "rewriter/facts/escape": ["rewriter/model", "rewriter/rules", "rewriter/parse", "rewriter/facts/syntax", "rewriter/facts/flow"],
    "rewriter/facts/content": ["rewriter/model", "rewriter/rules", "rewriter/parse", "rewriter/facts/syntax", "rewriter/facts/flow",
                               "rewriter/facts/escape"],
    "rewriter/facts": ["rewriter/model", "rewriter/rules", "rewriter/parse", "rewriter/facts/syntax", "rewriter/facts/flow",
                       "rewriter/facts/sites", "rewriter/facts/escape", "rewriter/facts/content"],
    "rewriter/verify": ["rewriter/model", "rewriter/edits", "rewriter/parse", "rewriter/rules", "rewriter/solve"],
    "rewriter/engine": ["rewriter/model", "rewriter/edits", "rewriter/buildfiles", "rewriter/report",
                        "rewriter/parse", "rewriter/facts", "rewriter/solve", "rewriter/verify"],
    "rewriter/format": ["rewriter/edits"],
    "rewriter/workspace": ["rewriter/model", "rewriter/edits", "rewriter/buildfiles", "rewriter/proof"],
    "rewriter/other_code": ["rewriter/model", "rewriter/edits", "rewriter/buildfiles", "rewriter/workspace"],
    "rewriter/remarks": ["rewriter/model", "rewriter/edits", "rewriter/report"],
    "rewriter/port": ["rewriter/interruption", "rewriter/model", "rewriter/edits", "rewriter/transaction", "rewriter/report",
                      "rewriter/cache", "rewriter/buildfiles", "rewriter/proof", "rewriter/engine", "rewriter/workspace",
                      "rewriter/other_code", "rewriter/remarks"],
    "rewriter/tool": ["rewriter/interruption", "rewriter/model", "rewriter/edits", "rewriter/transaction", "rewriter/report",
                      "rewriter/buildfiles", "rewriter/proof", "rewriter/engine", "rewriter/format", "rewriter/workspace",
                      "rewriter/other_code", "rewriter/remarks", "rewriter/port", "tools/command_line"],

    # The benchmark measures the runtime, so it alone uses another product.
    "bench": ["tools/command_line"],
    "bench/core": ["bench", "runtime/channel", "runtime/channel/wire"],
    "bench/roscpp": ["bench", "bench/core", "runtime/roscpp", "tools/command_line", "tools/loopback"],
    "bench/paper": ["bench", "bench/core", "bench/roscpp", "runtime/posix", "tools/command_line"],
    # tzc-monitor knows the layout of a statistics page and what owns a descriptor, and nothing else of the runtime.
    "monitor": ["runtime/posix", "runtime/statistics", "tools/command_line"],
    "monitor/diagnostics": ["monitor"],
    # tzc-compare needs no ROS to compare; its recorder is a ROS node.
    "compare/wire": [],
    "compare/pairing": ["compare/wire"],
    "compare/engine": ["compare/wire", "compare/pairing"],
    "compare/run": ["compare/pairing", "compare/engine", "tools/loopback"],
    "compare/report": ["compare/engine", "compare/run"],
    "compare/tool": ["compare/engine", "compare/run", "compare/report", "tools/command_line"],
    "compare/recorder": ["compare/wire", "runtime/preload", "runtime/roscpp"],
}

# Folders in which `#include "folder/file.h"` is looked up; a runtime module's include/ is one, too.
INCLUDE_ROOTS = ["runtime", "msggen", "rewriter", "bench", "compare", "monitor", "tools"]

ROS = r"(ros|rosconsole|xmlrpcpp|cv_bridge|image_transport|message_filters|pcl_conversions|[a-z0-9_]+_msgs)/"
SERIALIZATION = (r"ros/(serialization|serialized_message|message_traits|message_operations|builtin_message_traits|types|"
                 r"time|duration)\.h|[a-z0-9_]+_msgs/")

# Headers of other projects: name -> (pattern, the modules that may include them).
FOREIGN = {
    "ROS's nodes and topics": (rf"(?!{SERIALIZATION}){ROS}",
                               ["runtime/roscpp", "runtime/adapters", "runtime/preload", "bench/roscpp",
                                "compare/recorder", "monitor/diagnostics"]),
    "ROS's messages": (SERIALIZATION, ["runtime/message", "runtime/roscpp", "runtime/adapters", "runtime/preload",
                                       "bench/roscpp", "compare/recorder", "monitor/diagnostics"]),
    "Boost": (r"boost/", ["runtime/message", "runtime/roscpp", "runtime/adapters", "bench/roscpp"]),
    "Clang": (r"(clang|clang-c|llvm)/", ["rewriter/parse", "rewriter/facts/syntax", "rewriter/facts/flow",
                                       "rewriter/facts/sites", "rewriter/facts/escape", "rewriter/facts/content",
                                       "rewriter/facts", "rewriter/verify", "rewriter/engine", "rewriter/format"]),
}

# Modules that must not reach Clang through any chain of includes.
CLANG_FREE = [module for module in USES if module not in FOREIGN["Clang"][1]]


def module_of(path):
    """The module of a source file, by its folder; None when the folder belongs to no module."""
    folders = path.split("/")[:-1]
    for length in range(len(folders), 0, -1):  # a module may lie in another one's folder
        if "/".join(folders[:length]) in USES:
            return "/".join(folders[:length])
    return None
