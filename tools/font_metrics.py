#!/usr/bin/env python3
"""Writes the advance widths of DejaVu Sans that figures are measured with: font_metrics.py FONT.ttf INTO.inc

The widths are in thousandths of the font's size, character after character; a number below zero is the code, with its
sign changed, of the character that comes next.
"""

import sys
import textwrap
from pathlib import Path

from fontTools.ttLib import TTFont

LINE = 118


def metrics(font: TTFont) -> list[int]:
    """The numbers of the table, by ascending code."""
    names, widths, size = font.getBestCmap(), font["hmtx"], font["head"].unitsPerEm
    numbers, expected = [], 0
    for code in sorted(names):
        if code < 0x20:
            continue
        if code != expected:
            numbers.append(-code)
        numbers.append(round(1000 * widths[names[code]][0] / size))
        expected = code + 1
    return numbers


def main() -> None:
    font, into = sys.argv[1:]
    text = ", ".join(map(str, metrics(TTFont(font))))
    Path(into).write_text(f"// Written by tools/font_metrics.py from DejaVu Sans.\n{textwrap.fill(text, LINE)}\n")


if __name__ == "__main__":
    main()
