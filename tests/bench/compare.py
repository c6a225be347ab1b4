#!/usr/bin/env python3
"""Bytes and speed of unstep and its peers on the same images in one run.

usage: compare.py [options] FOLDER...

Sub-folders are sets. Every page becomes a PBM; every coder encodes it to its
file and decodes it to PBM again, and the result is compared with the page.
Bytes are whole files. Speeds are the processor time of whole processes (one
thread, PBM on both sides, no check after encoding), medians of --runs rounds
in which the coders take turns, on pages of at least 1 Mpx. The slowest coders
take part in one round only. "fast" and "max" are unstep's other efforts.

  compare.py samples
  compare.py --unstep build/release/cli/unstep --json out.json drawings/
"""

import argparse
import csv
import datetime
import json
import math
import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile

import coders as coders_module
import images

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
TIMED_PIXELS = 1000000
OWN = ("unstep", "fast", "max")  # the default and the other efforts


def find_unstep():
    for build in ("release", "demo", "dev"):
        path = os.path.join(ROOT, "build", build, "cli", "unstep")
        if os.access(path, os.X_OK):
            return path
    return "unstep"


def measure_page(page, coders, runs, folder):
    """{coder: {bytes, encode_s, decode_s, verified}} of one page."""
    pbm = os.path.join(folder, "page.pbm")
    with open(pbm, "wb") as out:
        out.write(page.file())
    pgm = os.path.join(folder, "page.pgm")
    coders = [c for c in coders if c.takes(page)]
    if any(c.reads_grey for c in coders):
        with open(pgm, "wb") as out:
            out.write(page.grey_file())
    timed = page.pixels >= TIMED_PIXELS
    times = {c.name: ([], []) for c in coders}
    result = {}
    for turn in range(runs if timed else 1):
        for coder in coders:
            if coder.once and turn > 0:
                continue
            out = coder.name + (".out.pgm" if coder.reads_grey else ".out.pbm")
            names = {"pbm": pbm, "pgm": pgm, "rows": page.height,
                     "file": os.path.join(folder, "page" + coder.suffix),
                     "out": os.path.join(folder, out)}
            encode = coders_module.run(coder.encode, **names)[0]
            times[coder.name][0].append(encode)
            if coder.decode:
                decode = coders_module.run(coder.decode, **names)[0]
                times[coder.name][1].append(decode)
            if turn == 0:
                result[coder.name] = check_and_size(coder, page, names)
    for coder in coders:
        entry = result[coder.name]
        if timed:
            entry["encode_s"] = statistics.median(times[coder.name][0])
            if coder.decode:
                entry["decode_s"] = statistics.median(times[coder.name][1])
    return result


def check_and_size(coder, page, names):
    """Compares what was decoded, then takes the bytes of the best file."""
    verified = None
    if coder.decode:
        if coder.size:
            coders_module.run(coder.size, **names)
            coders_module.run(coder.decode, **names)
        elif coder.after and shutil.which(coder.after[0]):
            coders_module.run(coder.after, **names)
            coders_module.run(coder.decode, **names)
        with open(names["out"], "rb") as out:
            decoded = images.parse_pnm(out.read())
        verified = len(decoded) == 1 and decoded[0].same_ink(page)
        if not verified:
            raise RuntimeError("%s gave back other pixels" % coder.name)
    return {"bytes": os.path.getsize(names["file"]), "verified": verified}


def load_known(path):
    """{file stem: {coder: bytes}} of peers measured elsewhere."""
    with open(path, newline="", encoding="utf-8") as table:
        return {os.path.splitext(row["file"])[0]:
                {k: int(v) for k, v in row.items() if k != "file" and v}
                for row in csv.DictReader(table)}


def measure(sets, coders, args):
    known = load_known(args.known) if args.known else {}
    pages = []
    for name, paths in sets.items():
        for path in paths:
            try:
                found = images.read_pages(path)
            except ValueError as error:
                print("passed over: %s: %s" % (path, error), file=sys.stderr)
                continue
            for number, page in enumerate(found):
                with tempfile.TemporaryDirectory(dir=args.tmp) as folder:
                    try:
                        result = measure_page(page, coders, args.runs, folder)
                    except RuntimeError as error:
                        sys.exit("compare.py: %s: %s" % (path, error))
                stem = name + "/" + os.path.splitext(
                    os.path.basename(path))[0]
                for coder, size in known.get(stem, {}).items():
                    if coder not in result and len(found) == 1:
                        result[coder] = {"bytes": size, "known": True}
                pages.append({"set": name, "file": os.path.basename(path),
                              "page": number + 1, "pixels": page.pixels,
                              "coders": result})
        print("done: %s" % name, file=sys.stderr)
    return pages


def sums(pages, names):
    """One row of the tables: bytes, and seconds of the timed pages."""
    row = {"pages": len(pages), "pixels": sum(p["pixels"] for p in pages),
           "bytes": {}, "encode_mpx_s": {}, "decode_mpx_s": {}}
    for name in names:
        entries = [p["coders"].get(name) for p in pages]
        if all(entries):
            row["bytes"][name] = sum(e["bytes"] for e in entries)
        for key, speed in (("encode_s", "encode_mpx_s"),
                           ("decode_s", "decode_mpx_s")):
            timed = [(p["pixels"], p["coders"][name][key]) for p in pages
                     if key in p["coders"].get(name, {})]
            if timed:
                spent = sum(t for _, t in timed)
                row[speed][name] = sum(n for n, _ in timed) / spent / 1e6
    peers = {k: v for k, v in row["bytes"].items() if k not in OWN}
    if peers:
        row["best"] = min(peers, key=peers.get)
        row["ratio"] = row["bytes"]["unstep"] / peers[row["best"]]
    return row


def tables(rows, names, known):
    out = ["### Bytes", ""]
    shown = [n + (" *" if n in known else "") for n in names]
    out.append("| set | pages | Mpx | " + " | ".join(shown) +
               " | best peer | unstep / best |")
    out.append("|---|" + "--:|" * (len(names) + 2) + "---|--:|")
    for label, row in rows.items():
        cells = [str(row["bytes"].get(n, "-")) for n in names]
        out.append("| %s | %d | %.1f | %s | %s | %.3f |" % (
            label, row["pages"], row["pixels"] / 1e6, " | ".join(cells),
            row["best"], row["ratio"]))
    per_set = [r["ratio"] for k, r in rows.items() if k != "total"]
    mean = math.exp(sum(map(math.log, per_set)) / len(per_set))
    out.append("| geometric mean of the sets | | |" + " |" * len(names) +
               " | %.3f |" % mean)
    if known:
        out += ["", "\\* not on this machine: bytes measured elsewhere on the "
                "same files, not verified here."]
    for verb in ("encode", "decode"):
        out += ["", "### Speed, %s, Mpx/s" % verb, ""]
        timed = [n for n in names
                 if any(n in r[verb + "_mpx_s"] for r in rows.values())]
        out.append("| set | " + " | ".join(timed) + " | unstep / jbig1 |")
        out.append("|---|" + "--:|" * (len(timed) + 1))
        for label, row in rows.items():
            speeds = row[verb + "_mpx_s"]
            if "unstep" in speeds:
                cells = ["%.0f" % speeds[n] if n in speeds else "-"
                         for n in timed]
                ratio = ("%.2f" % (speeds["unstep"] / speeds["jbig1"])
                         if "jbig1" in speeds else "-")
                out.append("| %s | %s | %s |" % (label, " | ".join(cells),
                                                 ratio))
    return "\n".join(out)


def said(command):
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, cwd=ROOT,
                              stderr=subprocess.DEVNULL, check=False)
        return done.stdout.decode(errors="replace").strip()
    except FileNotFoundError:
        return ""


def circumstances(coders, unstep):
    cpu = [line.split(":", 1)[1].strip() for line in said(["lscpu"]).split("\n")
           if line.startswith("Model name")]
    return {
        "date": datetime.date.today().isoformat(),
        "commit": said(["git", "describe", "--always", "--dirty"]),
        "unstep": said([unstep, "--version"]).split("\n")[0],
        "cpu": cpu[0] if cpu else platform.machine(),
        "cores": os.cpu_count(),
        "system": platform.platform(),
        "compiler": said(["c++", "--version"]).split("\n")[0],
        "peers": sorted({v for v in (
            coders_module.version_of(c.encode[0])
            for c in coders if c.name not in OWN) if v}),
    }


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", nargs="+")
    parser.add_argument("--unstep", default=find_unstep())
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--only", metavar="NAMES", help=(
        "these coders beside unstep, with commas between"))
    parser.add_argument("--tmp", metavar="DIR", help="for temporary files")
    parser.add_argument("--known", metavar="CSV", help=(
        "file,coder,... with bytes of coders that are not on this machine"))
    args = parser.parse_args()

    coders = []
    for coder in coders_module.all_coders(args.unstep):
        if args.only is not None and coder.name not in [
                "unstep", *args.only.split(",")]:
            continue
        if coder.missing():
            print("left out: %s needs %s" % (
                coder.name, ", ".join(coder.missing())), file=sys.stderr)
        else:
            coders.append(coder)
    if not coders or coders[0].name != "unstep":
        sys.exit("compare.py: no unstep program; build one or give --unstep")

    sets = images.find_sets(args.folder)
    pages = measure(sets, coders, args)
    if not pages:
        sys.exit("compare.py: no two-valued images found")
    here = [c.name for c in coders]
    known = sorted({n for p in pages for n in p["coders"]} - set(here))
    names = here + known
    rows = {name: sums([p for p in pages if p["set"] == name], names)
            for name in sets if any(p["set"] == name for p in pages)}
    rows["total"] = sums(pages, names)

    about = circumstances(coders, args.unstep)
    print("%s, commit %s, %s, %d cores, %s, %s. Peers: %s. Medians of %d." % (
        about["date"], about["commit"], about["cpu"], about["cores"],
        about["system"], about["compiler"], ", ".join(about["peers"]),
        args.runs))
    print()
    print(tables(rows, names, known))
    if args.json:
        with open(args.json, "w", encoding="utf-8") as out:
            json.dump({"about": about, "sets": rows, "pages": pages}, out,
                      indent=1)


if __name__ == "__main__":
    main()
