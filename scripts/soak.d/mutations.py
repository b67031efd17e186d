"""Damages files at random, and makes files that fail smaller."""
import time


def split(data):
    """Lines of text, pieces of 16 bytes of anything else."""
    if b"\0" in data[:4000]:
        return [data[i:i + 16] for i in range(0, len(data), 16)]
    return data.splitlines(keepends=True)


def flip_bits(rng, data, _):
    data = bytearray(data)
    for _ in range(rng.choice([1, 1, 3, 20])):
        data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
    return bytes(data)


def set_bytes(rng, data, _):
    i = rng.randrange(len(data))
    value = rng.choice([b"\0\0\0\0", b"\xff\xff\xff\xff", b"\xff\xff\xff\x7f", b"\0\0\0\x80", b"-1", b" 1e308 ", b"9" * 12])
    return data[:i] + value + data[i + len(value):]


def cut_off(rng, data, _):
    return data[:rng.randrange(len(data))]


def change_pieces(rng, data, _):
    """Deletes, doubles or swaps a block of lines."""
    pieces = split(data)
    i = rng.randrange(len(pieces))
    k = min(len(pieces), i + rng.choice([1, 1, 3, 30]))
    return b"".join(rng.choice([pieces[:i] + pieces[k:], pieces[:k] + pieces[i:],
                                pieces[:i] + rng.choice([1, 50]) * pieces[i:k] + pieces[k:],
                                pieces[k:] + pieces[i:k] + pieces[:i]]))


def splice(rng, data, other):
    pieces, others = split(data), split(other)
    i, k = rng.randrange(len(pieces)), rng.randrange(len(others))
    return b"".join(pieces[:i] + others[k:k + rng.choice([1, 20, len(others)])] + pieces[i:])


MUTATIONS = [flip_bits, set_bytes, cut_off, change_pieces, splice]


def mutated(rng, data, other):
    """\\param other a second file of the same format"""
    for _ in range(rng.choice([1, 1, 2, 4])):
        if data and other:
            data = rng.choice(MUTATIONS)(rng, data, other)
    return data


def minimised(data, fails, seconds):
    """The smallest data found in that time for which fails(data) holds, by leaving out ever smaller parts."""
    end = time.monotonic() + seconds
    for cut in (split, lambda d: [d[i:i + 1] for i in range(len(d))] if len(d) < 400 else [d]):
        pieces, count = cut(data), 2
        while len(pieces) > 1 and time.monotonic() < end:
            size = max(1, len(pieces) // count)
            for at in range(0, len(pieces), size):
                rest = pieces[:at] + pieces[at + size:]
                if time.monotonic() > end:
                    break
                if fails(b"".join(rest)):
                    pieces, count = rest, max(2, count - 1)
                    break
            else:
                if size == 1:
                    break
                count *= 2
        data = b"".join(pieces)
    return data
