"""wrap.py FILE...: wraps the prose of Markdown files at 100 characters; tables, code and headings stay as they are.

Only paragraphs and list items with a longer line are touched.
"""

import pathlib
import re
import sys
import textwrap

WIDTH = 100
ITEM = re.compile(r"^\s*([-*+]|\d+\.)\s+")
KEPT = re.compile(r"\s*$|\s*(\||```)|#|<|!\[")  # blank, table, code, heading, markup, picture
NO_BREAK = "\x01"


def wrapped_paragraph(lines):
    mark = ITEM.match(lines[0])
    lead = mark[0] if mark else re.match(r"\s*", lines[0])[0]
    words = " ".join([lines[0][len(lead):].strip(), *(line.strip() for line in lines[1:])])
    words = re.sub(r"`[^`]*`", lambda code: code[0].replace(" ", NO_BREAK), words)
    rest = " " * len(lead)
    out = []
    for line in textwrap.wrap(words, WIDTH, initial_indent=lead, subsequent_indent=rest, break_long_words=False,
                              break_on_hyphens=False):
        if out and re.match(r"\s*([-*+#>]|\d+\.)(\s|$)", line):  # would become a list or a heading
            out[-1], word = out[-1].rsplit(" ", 1)
            line = f"{rest}{word} {line.strip()}"
        out.append(line.replace(NO_BREAK, " "))
    return out


def wrapped(text):
    """The text with its prose wrapped."""
    lines, out, in_code, i = text.split("\n"), [], False, 0
    while i < len(lines):
        line = lines[i]
        i += 1
        if line.lstrip().startswith("```"):
            in_code = not in_code
        if in_code or KEPT.match(line) or (line.startswith("    ") and not ITEM.match(line)):
            out.append(line)
            continue
        paragraph = [line]
        while i < len(lines) and not KEPT.match(lines[i]) and not ITEM.match(lines[i]):
            paragraph.append(lines[i])
            i += 1
        out += wrapped_paragraph(paragraph) if max(map(len, paragraph)) > WIDTH else paragraph
    return "\n".join(out)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        path = pathlib.Path(name)
        old = path.read_text()
        if wrapped(old) != old:
            path.write_text(wrapped(old))
