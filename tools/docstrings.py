"""docstrings.py ROOT: writes into the docstrings of the Python package what headers and the case file's reference say.

A docstring begins with what is written by hand. What follows from a line "From ``HEADER``:" or "Keys:" on is written
here: the comment of the declaration in the header, and the keys of a table with their values and defaults as
docs/case-file.md has them. tests/python/docstrings_test.py finds docstrings that are not as they would be written.
"""

import pathlib
import re
import sys
import textwrap

WIDTH = 118
PACKAGE = "bindings/python/bentur"

# Of a class or function: the headers and declarations whose comments belong to it.
LAWS = ("linear Linear", "kelvin_voigt KelvinVoigt", "kelvin_voigt_approach KelvinVoigtApproach", "darmawan Darmawan",
        "hertz Hertz", "hertz_damp HertzDamp", "jankowski Jankowski", "bilinear Bilinear", "restitution Restitution")
HEADERS = {
    "_model.py": {
        "Section": [("structure/plane_frame.h", "Section")],
        "Frame": [("structure/plane_frame.h", "PlaneFrame")],
        "Stick": [("structure/stick.h", "Stick")],
        "Modal": [("structure/known/modal.h", "ModalBuilding"), ("structure/known/modal.h", "ModalModel")],
        "Generic": [("structure/known/generic.h", "GenericBuilding"), ("structure/known/generic.h", "generic_model")],
        "Isolation": [("structure/support.h", "Isolation")],
        "Soil": [("structure/support.h", "Soil"), ("structure/support.h", "soil_of")],
        "Contact": [(f"contact/laws/{law.split()[0]}.h", law.split()[1]) for law in LAWS],
        "Link": [("elements/link_laws.h", "SpringDashpot"), ("elements/link_laws.h", "Cable"),
                 ("elements/kinematic_hardening.h", "KinematicHardening")],
    },
    "_functions.py": {
        "response_spectrum": [("solve/spectrum/response_spectrum.h", "OscillatorPeaks"),
                              ("solve/spectrum/response_spectrum.h", "oscillator_peaks")],
    },
}
# Of a class: the headings of docs/case-file.md whose tables have its keys.
SECTIONS = {
    "Units": ["Units"],
    "Building": ["Buildings"],
    "Frame": ["`[building.frame]`"],
    "Section": ["`[building.frame]`"],
    "Stick": ["`[building.stick]`"],
    "Matrices": ["`[building.matrices]`"],
    "Modal": ["`[building.modal]`"],
    "Generic": ["`[building.generic]`"],
    "Isolation": ["`[building.isolation]`"],
    "Soil": ["`[building.soil]`"],
    "Gap": ["Gaps"],
    "Contact": ["Contact laws"],
    "Link": ["Links"],
    "Excitation": ["Excitation"],
    "Initial": ["Initial state"],
    "Analysis": ["Analysis"],
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


def plain(cell):
    """A cell of Markdown as reStructuredText."""
    cell = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", cell.strip()).replace("\\|", "|")
    return re.sub(r"`([^`]*)`", r"``\1``", cell)


def section(text, heading):
    """What stands below a heading, down to the next one of its rank."""
    found = re.search(rf"^(##+) {re.escape(heading)}.*\n", text, re.MULTILINE)
    if not found:
        raise ValueError(f"no heading {heading}")
    end = re.search(rf"^#{{2,{max(len(found[1]), 3)}}} ", text[found.end():], re.MULTILINE)
    return text[found.end():][: end.start() if end else None]


def keys_of(text, name):
    """Rows of the tables below the headings of a class: keys, value, default, what the table is of, and of a law its
    name and the keys that it takes."""
    found = []
    for heading in SECTIONS[name]:
        below = section(text, heading)
        if name == "Section":
            below = below.split("**section**")[1]
        elif name == "Frame":
            below = below.split("**section**")[0]
        for table in re.finditer(r"(?:^\|.*\|\n)+", below, re.MULTILINE):
            head, _, *rows = [re.split(r"(?<!\\)\|", line.strip().strip("|")) for line in table[0].strip().split("\n")]
            of = re.findall(r"^\*\*`(\w+ = \"[\w-]+\")`\*\*", below[: table.start()], re.MULTILINE)
            if head[0].strip() == "`law`":  # of each law its force and its keys
                for row in rows:
                    value = f"{plain(row[0])}: {plain(row[1])}; {plain(row[2])}"
                    found.append([[], value, "", "", [row[0].strip(' `"'), *re.findall(r"`(\w+)`", " ".join(row[2:]))]])
                continue
            last = None
            for row in rows:
                keys = re.findall(r"`(\w+)`", row[0])
                if not keys and last:  # goes on
                    last[1] += "; " + plain(row[1])
                    continue
                last = [keys, plain(row[1]), plain(row[2]) if len(row) > 2 else "", of[-1] if of else "", []]
                found.append(last)
        # Choices that have a paragraph of their own.
        for choice in re.finditer(r"^\*\*`(\w+)`\*\* ((?:.+\n)+)", below, re.MULTILINE):
            value = re.split(r"(?<=[.)]) (?=[A-Z]|`)|\. ", " ".join(choice[2].split()))[0]
            found.append([[choice[1]], plain(value).rstrip(":."), "", "", []])
    return found


def of_keys(text, name):
    told, last = ["Keys:", ""], ""
    for keys, value, default, of, _ in keys_of(text, name):
        if of != last:
            told += ["", f"Of ``{of}``:", ""]
            last = of
        line = ", ".join(f"``{key}``" for key in keys) + (": " if keys else "") + value
        line += f"; default {default}" if default else ""
        told += textwrap.wrap(line, WIDTH - 6, initial_indent="- ", subsequent_indent="  ")
    return told


def written(root, file):
    """The text of a source of the package with its docstrings written anew."""
    text = (root / PACKAGE / file).read_text()
    reference = (root / "docs/case-file.md").read_text()
    of_file = HEADERS.get(file, {})
    names = [*of_file, *(name for name in SECTIONS if file == "_model.py" and name not in of_file)]
    for name in names:
        found = re.search(rf'^(?:class {name}:|def {name}\((?:.|\n)*?\) -> .*:)\n    """((?:.|\n)*?)"""\n', text, re.MULTILINE)
        if not found:
            raise ValueError(f"{file} has no {name} with a docstring")
        hand = re.split(r"\n+    (?:From ``|Keys:)", found[1])[0].rstrip()
        told = []
        for n, (header, declaration) in enumerate(of_file.get(name, [])):
            if n == 0 or header != of_file[name][n - 1][0]:
                told += ["", f"From ``{header}``:"]
            told += ["", *of_header(root, header, declaration)]
        if file == "_model.py" and name in SECTIONS:
            told += ["", *of_keys(reference, name)]
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
