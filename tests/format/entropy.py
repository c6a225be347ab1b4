"""Section "Arithmetic coder" of docs/format.md."""

M64 = (1 << 64) - 1
K = 0x9E3779B97F4A7C15


class Damaged(Exception):
    pass


def top(bits, product):
    """The upper bits of a product modulo 2^64."""
    return (product & M64) >> (64 - bits)


def clamp(x, low, high):
    return min(max(x, low), high)


def signed32(x):
    return ((x + (1 << 31)) & 0xFFFFFFFF) - (1 << 31)


class Interval:
    """Decisions."""

    def __init__(self, payload, trace):
        self.payload, self.trace = payload, trace
        self.low, self.high, self.value = 0, 0xFFFFFFFF, 0
        self.read = 0
        for _ in range(4):
            self.value = self.value << 8 | self.next_byte()

    def next_byte(self):
        at = self.read
        self.read += 1
        return self.payload[at] if at < len(self.payload) else 0

    def decode(self, p, what):
        if self.read > len(self.payload) + 12:
            raise Damaged("too short")
        middle = self.low + ((self.high - self.low) * p >> 16)
        bit = int(self.value <= middle)
        if self.trace:
            print(f"{what:14} {p:5}  {bit}  {self.low:08x} {self.high:08x}")
        if bit:
            self.high = middle
        else:
            self.low = middle + 1
        while self.low >> 24 == self.high >> 24:
            self.low = self.low << 8 & 0xFFFFFFFF
            self.high = self.high << 8 & 0xFFFFFFFF | 255
            self.value = self.value << 8 & 0xFFFFFFFF | self.next_byte()
        return bit

    def check_end(self):
        for keep in range(5):
            unit = 256 ** (4 - keep)
            tail = -(-self.low // unit) * unit
            if tail <= self.high:
                break
        coded = self.payload[:self.read - 4].ljust(self.read - 4, b"\0")
        coded += tail.to_bytes(5, "big")[1:1 + keep]
        for _ in range(8):
            coded = coded[:-1] if coded[-1:] == b"\0" else coded
        if self.value != tail or coded != self.payload:
            raise Damaged("wrong end")


def make_squash():
    e, table = 1 << 31, []
    for _ in range(3072):
        table.append(min(65535, ((1 << 48) // ((1 << 31) + e) + 1) // 2))
        e = (e * 2139111403 + (1 << 30)) >> 31
    return table


def make_stretch():
    table, x = [0] * 4096, 0
    for i in range(2048, 4096):
        while x < 3071 and SQUASH[x] < 16 * i + 8:
            x += 1
        table[i], table[4095 - i] = x, -x
    return table


SQUASH = make_squash()
STRETCH = make_stretch()
RATE = [655360 // (10 * n + 16) for n in range(256)]


def squash(x):
    x = clamp(x, -3071, 3071)
    return SQUASH[x] if x >= 0 else 65536 - SQUASH[-x]


def move(p, n, bit):
    m = 65535 - p if bit else p
    m -= m * RATE[n] >> 16
    m = max(0, m - 1)
    return 65535 - m if bit else m


def update(counter, bit):
    p, n = counter
    counter[:] = move(p, n, bit), min(255, n + 1)


class Mixer:
    """Mixer."""

    def __init__(self, sizes, first_vectors, spared=0):
        self.spared = spared
        first = [[clamp(4 * w, -32768, 32767) for w in vector]
                 for vector in first_vectors]
        self.sets = [[[first[v % len(first)], 0] for v in range(size)]
                     for size in sizes]

    def predict(self, x, chosen):
        return squash(self.mean(x, chosen))

    def mean(self, x, chosen):
        self.x = x
        self.vectors = [s[c] for s, c in zip(self.sets, chosen)]
        self.outputs = []
        for w, _ in self.vectors:
            total = sum(a * b for a, b in zip(x, w) if a)
            self.outputs.append(clamp(signed32(total) >> 14, -3071, 3071))
        total = sum(self.outputs)
        mean = abs(total) // len(self.outputs)
        return mean if total >= 0 else -mean

    def learn(self, bit):
        for vector, o in zip(self.vectors, self.outputs):
            if abs(65536 * bit - squash(o)) < self.spared:
                continue
            w, age = vector
            rate = 350 + 1050 * 16 // (16 + age // 64)
            step = (65536 * bit - squash(o)) * rate >> 12
            vector[:] = ([clamp(b + ((8 * a * step >> 16) + 1 >> 1),
                                -32768, 32767)
                          for a, b in zip(self.x, w)], min(60000, age + 1))


class Refiner:
    """Refiner."""

    def __init__(self):
        self.contexts = {}

    def refine(self, x, context):
        if context not in self.contexts:
            self.contexts[context] = [[squash(256 * k - 2048), 20]
                                      for k in range(17)]
        a = clamp(x, -2048, 2047) + 2048
        k, f = a // 256, a % 256
        self.counters = self.contexts[context][k:k + 2]
        return ((256 - f) * self.counters[0][0]
                + f * self.counters[1][0]) // 256

    def learn(self, bit):
        for counter in self.counters:
            update(counter, bit)
