#!/usr/bin/env python3
"""Checks that no decoder reaches an encoder's header through its includes.

usage: decoder_includes.py SOURCE_DIR | --self-test

A decoder is a file whose name holds "decoder" or "reader", an encoder's
header one whose name holds "encoder" or "writer".
"""

import pathlib
import re
import sys
import tempfile

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def includes(path, root):
    for name in INCLUDE.findall(path.read_text(encoding="ascii")):
        for folder in (root, root / "include", path.parent):
            if (folder / name).is_file():
                yield folder / name
                break


def forbidden_chain(path, root, seen):
    """The way from `path` to an encoder's header, or None."""
    for header in includes(path, root):
        if re.search("encoder|writer", header.name):
            return [header]
        if header not in seen:
            seen.add(header)
            rest = forbidden_chain(header, root, seen)
            if rest:
                return [header] + rest
    return None


def check(root):
    """Returns how many decoders there are, and the forbidden ways."""
    decoders = [path for path in sorted(root.rglob("*"))
                if path.suffix in (".h", ".cpp")
                and re.search("decoder|reader", path.name)]
    chains = [[path] + chain for path in decoders
              if (chain := forbidden_chain(path, root, set()))]
    return len(decoders), chains


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "x_encoder.h").write_text("")
        (root / "shared.h").write_text('#include "x_encoder.h"\n')
        (root / "good_decoder.cpp").write_text("#include <vector>\n")
        (root / "x_encoder.cpp").write_text('#include "x_encoder.h"\n')
        assert check(root) == (1, [])
        (root / "bad_decoder.cpp").write_text('#include "shared.h"\n')
        count, chains = check(root)
        assert count == 2
        assert [[path.name for path in chain] for chain in chains] == [
            ["bad_decoder.cpp", "shared.h", "x_encoder.h"]]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if sys.argv[1] == "--self-test":
        self_test()
        return
    count, chains = check(pathlib.Path(sys.argv[1]))
    for chain in chains:
        print(" includes ".join(str(path) for path in chain))
    if count == 0:
        sys.exit("no decoders found")
    if chains:
        sys.exit(1)


main()
