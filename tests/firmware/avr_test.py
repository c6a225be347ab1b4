#!/usr/bin/env python3
"""avr_test.py PROFILE_TOOL SOURCE WORK: compiles src/firmware/unstep_steps.h
for an ATmega328P, runs it in simavr and compares every step with the library's.
"""

import filecmp
import os
import re
import shutil
import subprocess
import sys

LINE_CYCLES = 600
ARC_CYCLES = 1000
STATE_BYTES = 256
SKIPPED = 77


def skip(what):
    print("SKIPPED: %s; install gcc-avr avr-libc libsimavr-dev libelf-dev"
          % what)
    sys.exit(SKIPPED)


def run(*command):
    result = subprocess.run(command, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, check=False)
    if result.returncode != 0:
        sys.exit("%s\n%s" % (" ".join(command), result.stdout[:2000]))
    return result.stdout


def main():
    tool, source, work = sys.argv[1:]
    here = os.path.dirname(os.path.abspath(__file__))
    if shutil.which("avr-gcc") is None:
        skip("there is no avr-gcc")
    compiler = shutil.which("cc") or shutil.which("gcc") or \
        shutil.which("clang")
    if compiler is None or not os.path.exists("/usr/include/simavr/sim_avr.h"):
        skip("there is no simavr to link to")
    os.makedirs(work, exist_ok=True)

    run(tool, work)
    firmware = os.path.join(work, "firmware.elf")
    run("avr-gcc", "-mmcu=atmega328p", "-DF_CPU=16000000UL", "-std=c99", "-Os",
        "-Wall", "-Wextra", "-Werror", "-I", source, "-I", work,
        os.path.join(here, "avr_main.c"), "-o", firmware)
    # The header is C and C++ of every warning level.
    for language in ("c", "c++"):
        run(compiler, "-x", language, "-Wall", "-Wextra", "-Wpedantic",
            "-Werror", "-fsyntax-only",
            os.path.join(source, "src/firmware/unstep_steps.h"))
    runner = os.path.join(work, "avr_run")
    run(compiler, "-O2", os.path.join(here, "avr_run.c"), "-o", runner,
        "-lsimavr", "-lelf")
    words = os.path.join(work, "words")
    out = run(runner, firmware, words)
    found = re.search(r"state (\d+) line (\d+) mean (\d+) arc (\d+) mean (\d+) "
                      r"end (\d+)", out)
    if found is None:
        sys.exit("no figures:\n" + out)
    state, line, line_mean, arc, arc_mean, end = map(int, found.groups())
    size = os.path.getsize(words)
    print("%d steps; state %d bytes; cycles of a step: line at most %d, mean "
          "%d; arc at most %d, mean %d" %
          (size, state, line, line_mean, arc, arc_mean))
    if end != 0xff:
        sys.exit("the firmware ended with %d" % end)
    if not filecmp.cmp(words, os.path.join(work, "expected"), shallow=False):
        sys.exit("the firmware's steps differ from the library's")
    if size < 10000 or state > STATE_BYTES or line > LINE_CYCLES or \
            arc > ARC_CYCLES:
        sys.exit("a bound is broken")


if __name__ == "__main__":
    main()
