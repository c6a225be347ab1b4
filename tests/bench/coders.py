"""The coders that compare.py sets side by side, as whole processes.

Each reads a PBM file and writes its own, and turns that back into PBM.
"""

import os
import shutil
import subprocess
import time


class Coder:
    """`encode` and `decode` are command templates with {pbm}, {file}, {out},
    {rows}; a decoder without {out} writes to its standard output. `size`,
    if given, makes the file whose bytes count instead of encode's."""

    def __init__(self, name, suffix, encode, decode, size=None, after=None):
        self.name = name
        self.suffix = suffix
        self.encode = encode
        self.decode = decode
        self.size = size
        self.after = after  # shrinks the file further; not timed

    def missing(self):
        """Programs that are not there."""
        wanted = [self.encode[0]] + ([self.decode[0]] if self.decode else [])
        return [w for w in wanted if not shutil.which(w)]


def all_coders(unstep):
    coders = [
        Coder("unstep", ".ustp",
              [unstep, "compress", "--no-verify", "--jobs", "1", "--force",
               "{pbm}", "-o", "{file}"],
              [unstep, "decompress", "--jobs", "1", "--force", "--to", "pbm",
               "{file}", "-o", "{out}"]),
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
    target = names["file"] if "{pbm}" in template else names["out"]
    to_file = "{file}" if "{pbm}" in template else "{out}"
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
