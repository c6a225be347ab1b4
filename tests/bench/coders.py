"""The coders that compare.py sets side by side, as whole processes.

Each reads a PBM file, or the same page as PGM, and writes its own, and turns
that back into PNM.
"""

import os
import shutil
import subprocess
import time


class Coder:
    """`encode` and `decode` are command templates with {pbm} or {pgm}, {file},
    {out}, {rows}; one without {file} or {out} writes to its standard output.
    `size`, if given, makes the file whose bytes count instead of encode's.
    `after` shrinks the file further and is not timed. `once`: so slow that one
    round must do. Pages with a longer side than `side` are left out."""

    def __init__(self, name, suffix, encode, decode, size=None, after=None,
                 once=False, side=None):
        self.name = name
        self.suffix = suffix
        self.encode = encode
        self.decode = decode
        self.size = size
        self.after = after
        self.once = once
        self.side = side

    def missing(self):
        """Programs that are not there."""
        wanted = [self.encode[0]] + ([self.decode[0]] if self.decode else [])
        return [w for w in wanted if not shutil.which(w)]

    def takes(self, page):
        return not self.side or max(page.width, page.height) <= self.side

    @property
    def reads_grey(self):
        return "{pgm}" in self.encode


def unstep_coder(name, unstep, *options, once=False):
    return Coder(name, ".ustp",
                 [unstep, "compress", "--no-verify", "--jobs", "1", "--force",
                  *options, "{pbm}", "-o", "{file}"],
                 [unstep, "decompress", "--jobs", "1", "--force", "--to",
                  "pbm", "{file}", "-o", "{out}"], once=once)


def all_coders(unstep):
    coders = [
        unstep_coder("unstep", unstep),
        unstep_coder("fast", unstep, "--effort", "fast"),
        unstep_coder("max", unstep, "--effort", "max", once=True),
        Coder("jbig1", ".jbg", ["pbmtojbg", "-q", "{pbm}", "{file}"],
              ["jbgtopbm", "{file}", "{out}"],
              size=["pbmtojbg", "-q", "-s", "1000000", "{pbm}", "{file}"]),
        Coder("djvu", ".djvu", ["cjb2", "{pbm}", "{file}"],
              ["ddjvu", "-format=pbm", "{file}", "{out}"]),
        Coder("g4", ".tif",
              ["pamtotiff", "-g4", "-rowsperstrip={rows}", "{pbm}"],
              ["tifftopnm", "{file}"]),
        Coder("png", ".png", ["pnmtopng", "-compression", "9", "{pbm}"],
              ["pngtopnm", "{file}"],
              after=["optipng", "-quiet", "-o1", "{file}"]),
        Coder("webp", ".webp",
              ["cwebp", "-quiet", "-lossless", "-z", "6", "{pgm}", "-o",
               "{file}"],
              ["dwebp", "-quiet", "{file}", "-ppm", "-o", "{out}"],
              side=16383),
        Coder("jxl", ".jxl",
              ["cjxl", "--quiet", "-d", "0", "--num_threads=0", "{pgm}",
               "{file}"],
              ["djxl", "--quiet", "--num_threads=0", "{file}", "{out}"],
              once=True),
    ]
    if shutil.which("jbig2"):
        decode = None
        if shutil.which("jbig2dec"):
            decode = ["jbig2dec", "-t", "pbm", "-o", "{out}", "{file}"]
        coders.append(Coder("jbig2", ".jb2", ["jbig2", "{pbm}"], decode))
    return coders


def run(template, **names):
    """Runs a command; its processor seconds (user + system, all of it)."""
    command = [part.format(**names) for part in template]
    # A program that is not told where to write writes to stdout.
    encodes = "{pbm}" in template or "{pgm}" in template
    target = names["file"] if encodes else names["out"]
    to_file = "{file}" if encodes else "{out}"
    stdout = subprocess.DEVNULL
    if to_file not in template:
        stdout = open(target, "wb")
    errors = names["file"] + ".err"
    try:
        with open(errors, "wb") as stderr:
            start = time.monotonic()
            process = subprocess.Popen(command, stdout=stdout, stderr=stderr,
                                       stdin=subprocess.DEVNULL)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            wall = time.monotonic() - start
        if process.returncode != 0:
            with open(errors, "rb") as text:
                said = text.read().decode(errors="replace").strip()
            raise RuntimeError("%s ended with %d: %s" % (
                " ".join(command), process.returncode, said))
    finally:
        if stdout != subprocess.DEVNULL:
            stdout.close()
    return usage.ru_utime + usage.ru_stime, wall


def version_of(program):
    """The Debian package version of a program, or what it says itself."""
    path = shutil.which(program)
    if not path:
        return None
    real = os.path.realpath(path)
    for command in (["dpkg-query", "-S", path], ["dpkg-query", "-S", real]):
        try:
            found = subprocess.run(command, stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL, check=False)
        except FileNotFoundError:
            break
        if found.returncode == 0:
            package = found.stdout.decode().split(":")[0]
            shown = subprocess.run(["dpkg-query", "-W", package],
                                   stdout=subprocess.PIPE, check=False)
            return shown.stdout.decode().split("\n")[0].replace("\t", " ")
    return program
