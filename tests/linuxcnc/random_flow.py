"""Random programs of O words: loops, branches and subroutines, nested.

Every loop has a counter of its own, so that all programs end; labels are
numbers, names and expressions. The same seed gives the same program.
"""

import random


class Flow:
    MOST_DEPTH = 3

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.lines = []
        self.label = 100
        self.counter = 200
        self.subs = []  # (label, arguments, whether it returns a value)
        self.loops = []  # (label, kind) that are open here
        self.depth = 0
        self.in_sub = None
        self.arguments = 0
        # rs274 2.9 runs a do loop once only after a break has left another.
        self.has_do = self.chance(0.5)

    def chance(self, share):
        return self.random.random() < share

    def add(self, text):
        self.lines.append("  " * self.depth + text)

    def new_label(self):
        """The label, as it is written at each of its lines."""
        self.label += 1
        kind = self.random.randrange(6)
        if kind == 0:
            return f"<name {self.label}>"
        if kind == 1:
            return f"[{self.label - 7} + 7]"
        return f"{self.label}"

    def o(self, label, words):
        letter = self.random.choice("oO")
        words = self.random.choice([words, words, words.upper()])
        self.add(f"{letter}{label} {words}")

    def value(self):
        kind = self.random.randrange(7)
        if kind == 0:
            return str(self.random.randrange(-30, 30))
        if kind == 1:
            return f"#{self.random.randrange(31, 36)}"
        if kind == 2:
            return f"#<_g{self.random.randrange(3)}>"
        if kind == 3 and self.arguments:
            return f"#{self.random.randrange(1, self.arguments + 1)}"
        if kind == 4:
            return "#<_value>"
        if kind == 5:
            return f"[EXISTS[#<l{self.random.randrange(3)}>]]"
        return f"{self.random.randrange(-99, 99) / 8}"

    def expression(self):
        kind = self.random.randrange(6)
        a, b = self.value(), self.value()
        if kind < 2:
            return f"{a} {self.random.choice('+-*')} {b}"
        if kind == 2:
            return f"ABS[{a}] MOD 7"
        if kind == 3:
            return f"ROUND[{a}] + FIX[{b}]"
        return a

    def condition(self):
        kind = self.random.randrange(4)
        if kind == 0:
            return self.expression()
        a, b = self.expression(), self.expression()
        test = self.random.choice(["EQ", "NE", "GT", "GE", "LT", "LE"])
        one = f"[{a}] {test} [{b}]"
        if kind == 1:
            return f"[{one}] {self.random.choice(['AND', 'OR', 'XOR'])} [{b}]"
        return one

    def bounded(self):
        """A value that stays small however often it is assigned."""
        return f"[{self.expression()}] MOD 50"

    def statement(self):
        kinds = [self.motion, self.motion, self.motion, self.assignment]
        if self.depth < self.MOST_DEPTH:
            kinds += [self.branch, self.branch, self.while_loop, self.repeat]
            if self.has_do:
                kinds.append(self.do_loop)
        if self.subs:
            kinds.append(self.call)
        if self.choices_of_jump():
            kinds.append(self.jump)
        self.random.choice(kinds)()

    def block(self, most=4):
        self.depth += 1
        for _ in range(self.random.randrange(1, most + 1)):
            self.statement()
        self.depth -= 1

    def motion(self):
        axis = self.random.choice("XYZ")
        word = self.random.choice(["G0 ", "G1 ", "", "G91 G1 ", "G90 G0 "])
        self.add(f"{word}{axis}[{self.bounded()}]")

    def assignment(self):
        name = self.random.choice(
            [f"#{self.random.randrange(31, 36)}",
             f"#<_g{self.random.randrange(3)}>",
             f"#<l{self.random.randrange(3)}>"])
        if self.arguments and self.chance(0.3):
            name = f"#{self.random.randrange(1, self.arguments + 1)}"
        self.add(f"{name} = [{self.bounded()}]")

    def branch(self):
        label = self.new_label()
        self.o(label, f"if [{self.condition()}]")
        self.block()
        for _ in range(self.random.choice([0, 0, 1, 2])):
            self.o(label, f"elseif [{self.condition()}]")
            self.block()
        if self.chance(0.5):
            self.o(label, "else")
            self.block()
        self.o(label, "endif")

    def new_counter(self):
        self.counter += 1
        self.add(f"#{self.counter} = 0")
        return f"#{self.counter}"

    def while_loop(self):
        label, counter = self.new_label(), self.new_counter()
        most = self.random.randrange(0, 4)
        self.o(label, f"while [{counter} LT {most}]")
        self.add(f"  {counter} = [{counter} + 1]")
        self.loops.append((label, "while"))
        self.block()
        self.loops.pop()
        self.o(label, "endwhile")

    def do_loop(self):
        label, counter = self.new_label(), self.new_counter()
        self.o(label, "do")
        self.add(f"  {counter} = [{counter} + 1]")
        self.loops.append((label, "do"))
        self.block()
        self.loops.pop()
        self.o(label, f"while [{counter} LT {self.random.randrange(0, 4)}]")

    def repeat(self):
        label = self.new_label()
        self.o(label, f"repeat [{self.random.randrange(0, 7) / 2}]")
        self.loops.append((label, "repeat"))
        self.block()
        self.loops.pop()
        self.o(label, "endrepeat")

    def choices_of_jump(self):
        """What both programs do alike.

        rs274 has no break and continue of repeat, and a repeat that is left
        by others goes on with the turns that were left when it is met again;
        unstep does not follow break and continue in do.
        """
        kinds = [kind for _, kind in self.loops]
        choices = []
        for i, (label, kind) in enumerate(self.loops):
            if kind == "while" and "do" not in kinds and \
                    "repeat" not in kinds[i:]:
                choices.append((label, "continue"))
                if not self.has_do:
                    choices.append((label, "break"))
        if self.in_sub and "repeat" not in kinds:
            choices.append((self.in_sub, "return"))
        return choices

    def jump(self):
        """break, continue or return, in a branch."""
        label, words = self.random.choice(self.choices_of_jump())
        if words == "return" and self.chance(0.5):
            words += f" [{self.expression()}]"
        around = self.new_label()
        self.o(around, f"if [{self.condition()}]")
        self.depth += 1
        self.o(label, words)
        self.depth -= 1
        self.o(around, "endif")

    def call(self):
        label, arguments = self.random.choice(self.subs)
        given = self.random.randrange(arguments + 2)
        words = "".join(f" [{self.expression()}]" for _ in range(given))
        self.o(label, "call" + words)

    def sub(self):
        label = self.new_label()
        if label.startswith("["):
            label = str(self.label)
        self.in_sub, self.arguments = label, self.random.randrange(1, 4)
        self.o(label, "sub")
        self.block(6)
        value = f" [{self.expression()}]" if self.chance(0.5) else ""
        self.o(label, "endsub" + value)
        self.subs.append((label, self.arguments))
        self.in_sub, self.arguments = None, 0

    def program(self):
        self.add("G21 G90 G17 F400")
        self.add("G0 X0 Y0 Z0")
        for name in ["#31", "#32", "#33", "#34", "#35", "#<_g0>", "#<_g1>",
                     "#<_g2>"]:
            self.add(f"{name} = {self.random.randrange(-9, 9)}")
        for _ in range(self.random.randrange(3)):
            self.sub()
        for _ in range(6):
            self.statement()
        self.add("M2")
        return "\n".join(self.lines) + "\n"


def random_program(seed):
    return Flow(seed).program()
