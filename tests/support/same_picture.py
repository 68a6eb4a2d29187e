"""Whether two pictures say and show the same, for what round-off may move."""

import re

NUMBER = re.compile(r"-?\d+\.\d+")


def same_picture(one, other, within):
    """The same texts, and numbers that differ by at most WITHIN [px]."""
    if NUMBER.sub("", one) != NUMBER.sub("", other):
        return False
    return all(abs(float(a) - float(b)) <= within for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)))
