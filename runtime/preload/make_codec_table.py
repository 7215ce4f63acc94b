# SPDX-License-Identifier: BSD-3-Clause
"""Writes the codec table's sources, shard_0.cpp to shard_<N-1>.cpp: the packages are spread over them.

usage: make_codec_table.py CENSUS.json OUTPUT_DIR SHARDS

CENSUS.json is what `tzc-msggen classify --json` prints. A file is only written when its content changes.
"""
import json
import os
import sys

SHARD = """// Made by make_codec_table.py. Do not edit.
{includes}
#include "preload/codec_table.h"

namespace tzc {{
template <>
void add_shard<{index}>(CodecTable& table) {{
  (void)table;
{entries}
}}
}}  // namespace tzc
"""


def write_if_changed(path, text):
    if os.path.exists(path):
        with open(path) as old:
            if old.read() == text:
                return
    with open(path, "w") as new:
        new.write(text)


def main():
    with open(sys.argv[1]) as census:
        types = json.load(census)["types"]
    shards = int(sys.argv[3])
    with_data_part = sorted(name.split("/") for name, facts in types.items() if facts["has_data_part"])
    if not with_data_part:
        sys.exit(f"{sys.argv[1]} has no data-carrying type: are ROS's message packages installed?")
    packages = sorted({package for package, _ in with_data_part})
    for index in range(shards):
        mine = [(package, name) for package, name in with_data_part if packages.index(package) % shards == index]
        # A package may install definitions that it makes no headers of.
        has = "#if __has_include(<{0}/{1}.h>)\n{2}\n#endif"
        includes = "\n".join(has.format(*one, f"#include <{one[0]}/{one[1]}.h>") for one in mine)
        entries = "\n".join(has.format(*one, f'  table.emplace("{one[0]}/{one[1]}", detail::make_codec<::{one[0]}::{one[1]}>());')
                            for one in mine)
        write_if_changed(os.path.join(sys.argv[2], f"shard_{index}.cpp"),
                         SHARD.format(includes=includes, index=index, entries=entries))


if __name__ == "__main__":
    main()
