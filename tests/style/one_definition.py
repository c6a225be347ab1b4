#!/usr/bin/env python3
"""Checks that no two types of a namespace have one name.

usage: one_definition.py FOLDER... | --self-test

Two files that define different types of one name in one namespace break the
one definition rule, which neither compiler nor linker reports: each may then
use the other's constructors. Types in unnamed namespaces are not looked at.
"""

import collections
import pathlib
import re
import sys
import tempfile

NOISE = re.compile(r"//[^\n]*|/\*.*?\*/|\"(\\.|[^\"\\])*\"|'(\\.|[^'\\])'",
                   re.DOTALL)
TOKEN = re.compile(r"namespace\s*(?P<space>[\w:]*)\s*\{|[{}]|"
                   r"\b(?:struct|class)\s+(?P<type>\w+)\s*(?:final\s*)?"
                   r"(?::(?!:)[^;{]*)?(?=\{)")


def types(text):
    """The qualified names of the types that are defined in a namespace."""
    stack = []
    for token in TOKEN.finditer(NOISE.sub(" ", text)):
        if token["space"] is not None:
            stack.append(token["space"])
        elif token[0] == "{":
            stack.append(None)
        elif token[0] == "}":
            if stack:
                stack.pop()
        elif all(stack):  # neither in a block nor in an unnamed namespace
            yield "::".join([*stack, token["type"]])


def violations(folders):
    places = collections.defaultdict(set)
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                for name in types(path.read_text(encoding="ascii")):
                    places[name].add(str(path))
    return {name: found for name, found in places.items() if len(found) > 1}


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "a.h").write_text("namespace a::b { struct X { int y; }; }")
        (root / "b.cpp").write_text(
            "namespace a::b { namespace { struct Y {}; } struct X final {}; }")
        (root / "c.cpp").write_text(
            "namespace a::b { namespace { struct Y {}; struct X {}; }"
            " struct Z::X {}; class W { struct X {}; }; }")
        found = violations([root])
        assert set(found) == {"a::b::X"}, found
        assert len(found["a::b::X"]) == 2, found
    return 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    found = violations(arguments)
    for name, paths in found.items():
        print(f"{name} is defined in {', '.join(sorted(paths))}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
