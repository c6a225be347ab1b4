"""Progress lines and interruption."""

import json
import os
import pty
import random
import select
import signal
import subprocess
import time

import harness
from harness import PROGRAM, noise


def blocks(side, seed):
    """A page of 4 x 4 blocks of ink and paper: many edges, yet no noise."""
    chance = random.Random(seed)
    rows = []
    for _ in range(0, side, 4):
        row = b"".join(chance.choice([b"\x00", b"\x0f", b"\xf0", b"\xff"])
                       for _ in range(side // 8))
        rows.append(row * 4)
    return b"P4\n%d %d\n" % (side, side) + b"".join(rows)


class Terminal(harness.CliTest):
    PAGE = blocks(1000, 1)
    LONG = 4.0  # seconds: a job that shows progress and can be interrupted
    pages = 0

    def setUp(self):
        super().setUp()
        if Terminal.pages == 0:
            Terminal.pages = self.pages_for(self.LONG)

    def pages_for(self, seconds):
        """How many pages keep the program busy so long on this machine."""
        times = []
        for count in [1, 9]:
            self.write("trial.pbm", self.PAGE * count)
            begin = time.monotonic()
            self.run_cli("compress", "trial.pbm", "-qf")
            times.append(time.monotonic() - begin)
        os.remove(self.path("trial.pbm"))
        os.remove(self.path("trial.ustp"))
        page = max((times[1] - times[0]) / 8, 1e-4)
        return max(4, min(1000, round(seconds / page)))

    def start(self, *args, **streams):
        return subprocess.Popen([PROGRAM, *args], cwd=self.folder, **streams)

    def run_on_terminal(self, *args, interrupt_after=None):
        """What the program writes to a terminal as its stderr, and its code."""
        master, slave = pty.openpty()
        process = self.start(*args, stderr=slave, stdout=subprocess.DEVNULL)
        os.close(slave)
        written = b""
        while True:
            ready, _, _ = select.select([master], [], [], 60)
            try:
                more = os.read(master, 4096) if ready else b""
            except OSError:  # how a terminal says that the other end closed
                more = b""
            if not more:
                break
            written += more
            if interrupt_after and interrupt_after in written:
                process.send_signal(signal.SIGINT)
                interrupt_after = None
        os.close(master)
        return process.wait(timeout=60), written.decode()

    def long_file(self, name="big.pbm", share=1.0):
        self.write(name, self.PAGE * max(2, round(self.pages * share)))

    def test_progress_on_a_terminal(self):
        self.long_file()
        code, written = self.run_on_terminal("compress", "big.pbm")
        self.assertEqual(code, 0)
        self.assertRegex(
            written, r"\r\x1b\[Kbig\.pbm  \d+ %  [0-9.]+ Mpx/s  \d+:\d\d left")
        self.assertTrue(written.endswith("\r\x1b[K"))

    def test_quiet_has_no_progress(self):
        self.long_file()
        self.assertEqual(self.run_on_terminal("compress", "big.pbm", "-q"),
                         (0, ""))

    def test_no_progress_in_the_first_second(self):
        self.write("small.pbm", noise(50, 50))
        self.assertEqual(self.run_on_terminal("compress", "small.pbm"), (0, ""))

    def test_no_progress_into_a_pipe(self):
        self.long_file()
        result = self.run_cli("compress", "big.pbm")
        self.assertEqual((result.code, result.err), (0, ""))

    def test_batch_progress(self):
        for number in range(3):
            self.long_file(f"in/{number}.pbm", 0.7)
        code, written = self.run_on_terminal("batch", "in", "-o", "out")
        self.assertEqual(code, 0)
        self.assertRegex(written, r"\d of 3 files  \d+ %  [0-9.]+ Mpx/s  "
                         r"\d+:\d\d left")

    def test_interrupt_leaves_nothing(self):
        self.long_file()
        for number in [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]:
            process = self.start("compress", "big.pbm", stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE)
            time.sleep(0.5)
            process.send_signal(number)
            out, _ = process.communicate(timeout=30)
            self.assertEqual((process.returncode, out), (130, b""), number)
            self.assertEqual(self.names(), ["big.pbm"])

    def test_interrupt_on_a_terminal_is_quick(self):
        self.long_file()
        code, written = self.run_on_terminal("compress", "big.pbm",
                                             interrupt_after=b" left")
        self.assertEqual(code, 130)
        self.assertTrue(written.endswith("unstep: big.pbm: interrupted\r\n"))
        self.assertEqual(self.names(), ["big.pbm"])

    def test_interrupt_while_waiting_for_input(self):
        process = self.start("compress", "-", "-o", "x.ustp",
                             stdin=subprocess.PIPE)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=10), 130)
        process.stdin.close()
        self.assertEqual(self.names(), [])

    def test_interrupted_batch_keeps_what_is_whole_and_resumes(self):
        for number in range(6):
            self.long_file(f"in/{number}.pbm", 0.4)
        process = self.start("batch", "in", "-o", "out", "--jobs", "2",
                             "--report", "log.json", stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE)
        deadline = time.monotonic() + 60
        while not self.names("out") and time.monotonic() < deadline:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        if process.returncode == 0:
            self.skipTest("the machine was faster than the signal")
        self.assertEqual(process.returncode, 130)
        self.assertRegex(err.decode(),
                         r"^unstep: interrupted; \d files? not finished, "
                         r"--resume goes on\n$")
        totals = json.loads(self.read("log.json"))["totals"]
        finished = self.names("out")
        self.assertEqual((totals["done"], totals["failed"]),
                         (len(finished), 0))
        self.assertLess(len(finished), 6)
        self.assertTrue(all(name.endswith(".pbm.ustp") for name in finished))
        self.expect(["verify", "-q",
                     *[os.path.join("out", name) for name in finished]])
        result = self.run_cli("batch", "in", "-o", "out", "--resume")
        self.assertEqual(result.code, 0)
        self.assertIn(f", {len(finished)} finished before; ", result.out)

    def test_closed_pipe_ends_quietly_without_a_crash(self):
        self.write("in.pbm", noise(2000, 2000))
        self.compress("in.pbm")
        process = self.start("decompress", "in.ustp", "-o", "-", "--to", "pbm",
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.close()
        err = process.stderr.read()
        process.stderr.close()
        self.assertEqual(process.wait(timeout=30), 4)
        self.assertEqual(err, b"unstep: standard output: cannot write: "
                         b"Broken pipe\n")


if __name__ == "__main__":
    harness.main()
