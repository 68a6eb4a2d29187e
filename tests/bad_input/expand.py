"""expand.py SOURCE OUT: writes the refused cases of SOURCE/*.cases as files into OUT, with the other files beside them.

A refused case is a base, SOURCE/base/NAME.toml, with some of its lines changed, and what the user must read of it:

    == NAME (BASE)          begins the case; without a base its lines follow, each after "| "
    17 width = -0.02        line 17 of the base is this one
    17+ points = 3          and after it comes this one, 0+ before the first; several in order
    17-                     it is not there; 17-20- nor the lines up to 20
    > :17:9: error: gap[0].width¦ = -0.02, must be >= 0

A line of what is to be read begins with the place behind the file's name, or with the name of another file; the key stands before the "¦". "..." at its end: what
follows comes from a library and is not compared. Out of that OUT/NAME.toml and OUT/NAME.expected are made, and OUT/keys.txt,
of every message its key. A file whose text is as before is left as it is.
"""

import pathlib
import re
import shutil
import sys

EDIT = re.compile(r"(\d+)(?:-(\d+)-|([+-]?))(?: (.*))?")


def changed(base, edits, name):
    """The lines of a base with edits."""
    lines = {0: []} | {number: [line] for number, line in enumerate(base, 1)}
    for edit in edits:
        found = EDIT.fullmatch(edit)
        if not found or int(found[2] or found[1]) not in lines:
            sys.exit(f"{name}: {edit!r} is no edit of {len(base)} lines")
        first, last, kind, text = int(found[1]), found[2], found[3], found[4] or ""
        if last:
            lines.update({number: [] for number in range(first, int(last) + 1)})
        elif kind == "+":
            lines[first].append(text)
        else:
            lines[first][:1] = [] if kind == "-" else [text]
    return [line for number in sorted(lines) for line in lines[number]]


def cases(source):
    """Of every case its name, its text and what is to be read, each with its key."""
    for file in sorted(source.glob("*.cases")):
        for block in re.split(r"^== ", file.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
            head, *lines = block.rstrip("\n").split("\n")
            name, base = re.fullmatch(r"(\S+)(?: \((\S+)\))?", head).groups()
            said = [line[2:] for line in lines if line.startswith("> ")]
            rest = [line for line in lines if not line.startswith("> ")]
            if base:
                text = changed((source / "base" / f"{base}.toml").read_text(encoding="utf-8").split("\n")[:-1], rest, name)
            else:
                text = [line[2:] for line in rest]
            yield name, "\n".join(text) + "\n", [(line.split("error: ", 1)[1].partition("¦")[0] if "¦" in line else "",
                                                  (f"{name}.toml" if line.startswith(":") else "") + line.replace("¦", "", 1))
                                                 for line in said]


def put(file, text):
    if not file.exists() or file.read_bytes() != text.encode():
        file.write_bytes(text.encode())
    return file.name


def main():
    source, out = map(pathlib.Path, sys.argv[1:])
    out.mkdir(parents=True, exist_ok=True)
    made, keys = set(), []
    for name, text, said in cases(source):
        made |= {put(out / f"{name}.toml", text), put(out / f"{name}.expected", "".join(line + "\n" for _, line in said))}
        keys += [(f"{name}.toml", f"{name}.toml: {key}".rstrip()) for key, _ in said]
    for file in source.iterdir():
        if file.is_file() and file.suffix not in (".cases", ".py", ".md"):
            made.add(file.name)
            if not (out / file.name).exists() or (out / file.name).read_bytes() != file.read_bytes():
                shutil.copyfile(file, out / file.name)
            if file.suffix == ".toml":
                keys += [(file.name, line) for line in (source / "whole.keys").read_text(encoding="utf-8").splitlines()
                         if line.startswith(f"{file.name}:")]
    made.add(put(out / "keys.txt", "".join(line + "\n" for _, line in sorted(keys, key=lambda one: one[0]))))
    for file in out.iterdir():
        if file.name not in made:
            file.unlink()


if __name__ == "__main__":
    main()
