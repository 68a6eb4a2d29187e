"""addresses.py ROOT: writes where the repository is, the one line of packaging/address, wherever it is named.

Without a line there nothing names it: README has a word in its place. ./dev release calls this.
"""

import pathlib
import re
import sys

WORD = "REPOSITORY"


def with_line(text, line, after):
    """`text` with the key and value of `line` below the line that begins with `after`; without a value, without it."""
    key, value = line
    text = re.sub(rf"^{re.escape(key)}.*\n", "", text, flags=re.MULTILINE)
    if not value:
        return text
    return re.sub(rf"^{re.escape(after)}.*\n", lambda found: f"{found[0]}{key}{value}\n", text, count=1, flags=re.MULTILINE)


def of_readme(text, address):
    clone = re.compile(r"^git clone \S+ bentur && cd bentur.*$", re.MULTILINE)
    told = f"git clone {address} bentur && cd bentur" if address else f"git clone {WORD} bentur && cd bentur    # {WORD}: where you found this page"
    return clone.sub(told, text)


def of_pyproject(text, address):
    text = re.sub(r"^\[project\.urls\]\n(.+\n)*\n", "", text, flags=re.MULTILINE)
    table = f'[project.urls]\nSource = "{address}"\n\n' if address else ""
    return text.replace("[project.optional-dependencies]\n", table + "[project.optional-dependencies]\n")


FILES = {
    "README.md": of_readme,
    "pyproject.toml": of_pyproject,
    "CITATION.cff": lambda text, to: with_line(text, ("repository-code: ", to and f'"{to}"'), "license: "),
    "packaging/vcpkg/vcpkg.json": lambda text, to: with_line(text, ('  "homepage": ', to and f'"{to}",'), '  "description"'),
    "packaging/conda/meta.yaml": lambda text, to: with_line(text, ("  home: ", to), "about:"),
    "packaging/debian/control": lambda text, to: with_line(text, ("Homepage: ", to), "Maintainer: "),
}


def main(root):
    address = (root / "packaging/address").read_text().strip()
    for name, written in FILES.items():
        file = root / name
        text = file.read_text()
        if (new := written(text, address)) != text:
            file.write_text(new)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
