"""docstrings.py ROOT: writes into the docstrings of the Python package's functions what headers say.

A docstring begins with what is written by hand. What follows from a line "From ``HEADER``:" on is written here: the
comment of the declaration in the header. tests/python/docstrings_test.py finds docstrings that are not as they would be
written; tools/python_classes.py writes those of the classes of a case.
"""

import pathlib
import re
import sys
import textwrap

WIDTH = 118
PACKAGE = "bindings/python/bentur"

# Of a function: the headers and declarations whose comments belong to it.
HEADERS = {
    "_functions.py": {
        "response_spectrum": [("solve/spectrum/response_spectrum.h", "OscillatorPeaks"),
                              ("solve/spectrum/response_spectrum.h", "oscillator_peaks")],
    },
}


def comment_of(root, header, name):
    """The `///` lines that stand before the declaration of `name`, without the slashes."""
    lines = (root / "src/bentur" / header).read_text().split("\n")
    declared = re.compile(rf"^\s*(?:\[\[nodiscard\]\] )?(?:struct|class|[\w:<>]+)[\w:<>, ]* {name}\b *[({{f:]|"
                          rf"^\s*(?:\[\[nodiscard\]\] )?[\w:<>]+ {name}\(")
    at = next((i for i, line in enumerate(lines) if declared.match(line)), None)
    if at is None:
        raise ValueError(f"{header} declares no {name}")
    first = at
    while lines[first - 1].strip().startswith("///"):
        first -= 1
    if first == at:
        raise ValueError(f"{header} says nothing of {name}")
    comment = "\n".join(line.strip()[4:].rstrip() for line in lines[first:at])
    return re.split(r"\s*@(?:throws|param|return)\b", comment)[0].split("\n")  # these are of C++, and stand last


def of_header(root, header, name):
    """The same as reStructuredText: paragraphs, and formulas as they stand."""
    blocks, block = [], []
    for line in [*comment_of(root, header, name), ""]:
        if block and (not line or line.startswith("  ") != block[0].startswith("  ")):
            blocks.append(block)
            block = []
        if line:
            block.append(line)
    told = []
    for block in blocks:
        if block[0].startswith("  "):
            told += ["::", "", *("  " + re.sub(r"(?<=\S) {4,}(?=\()", "   ", line) for line in block), ""]
        else:
            told += [*textwrap.wrap(" ".join(" ".join(block).split()), WIDTH - 4), ""]
    return told[:-1]


def written(root, file):
    """The text of a source of the package with its docstrings written anew."""
    text = (root / PACKAGE / file).read_text()
    of_file = HEADERS[file]
    for name, headers in of_file.items():
        found = re.search(rf'^(?:class {name}:|def {name}\((?:.|\n)*?\) -> .*:)\n    """((?:.|\n)*?)"""\n', text, re.MULTILINE)
        if not found:
            raise ValueError(f"{file} has no {name} with a docstring")
        hand = re.split(r"\n+    From ``", found[1])[0].rstrip()
        told = []
        for n, (header, declaration) in enumerate(headers):
            if n == 0 or header != headers[n - 1][0]:
                told += ["", f"From ``{header}``:"]
            told += ["", *of_header(root, header, declaration)]
        body = "\n".join("    " + line if line else "" for line in told)
        text = text[: found.start(1)] + hand + "\n" + body + "\n    " + text[found.end(1):]
    return text


def main(root):
    root = pathlib.Path(root)
    for file in HEADERS:
        new = written(root, file)
        if new != (root / PACKAGE / file).read_text():
            (root / PACKAGE / file).write_text(new)
            print(f"{file} written anew")


if __name__ == "__main__":
    main(*sys.argv[1:])
