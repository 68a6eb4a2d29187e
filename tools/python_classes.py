"""python_classes.py FILE: writes bentur/_model.py, the tables of a case as classes, from the schema of a case.

The build does it. A class has the keys of its table with their types and defaults; its docstring says of each what the
schema says, after the comments of the C++ headers that belong to it. The schema comes from the
compiled module `_core`, which must be on the path.
"""

import json
import pathlib
import re
import sys
import textwrap

import docstrings
from docstrings import WIDTH

HEAD = '''"""The tables of a case file as classes, under the file's own names. Written by tools/python_classes.py.

What is left out is left to the case's defaults. Nothing is checked here: making the case checks all of it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike
from typing import Literal

from numpy.typing import ArrayLike

from ._own_laws import Branch, BranchLaw, ForceLaw, Guard, Numbers, Table
from ._shown import Shown

'''
LAWS = ("linear Linear", "kelvin_voigt KelvinVoigt", "kelvin_voigt_approach KelvinVoigtApproach", "darmawan Darmawan",
        "hertz Hertz", "hertz_damp HertzDamp", "jankowski Jankowski", "bilinear Bilinear", "filler Filler",
        "restitution Restitution")
# Of a class: the way to its table in the schema, what of Python alone is to be said, and headers with declarations.
CLASSES = {
    "Units": (("units",), "", []),
    "Section": (("building", "frame", "columns"), "", [("structure/frame/plane_frame.h", "Section")]),
    "Frame": (("building", "frame"), "", [("structure/frame/plane_frame.h", "PlaneFrame")]),
    "Stick": (("building", "stick"), "", [("structure/stick.h", "Stick")]),
    "Matrices": (("building", "matrices"), "", []),
    "Modal": (("building", "modal"), "", [("structure/known/modal.h", "ModalBuilding"), ("structure/known/modal.h", "KnownModes")]),
    "Generic": (("building", "generic"), "", [("structure/known/generic.h", "GenericBuilding"), ("structure/known/generic.h", "generic_model")]),
    "Displacements": (("building", "displacements"), "", [("structure/known/displacements.h", "known_by_displacements")]),
    "Isolation": (("building", "isolation"), "", [("elements/bearing_laws.h", "bilinear_bearings")]),
    "Soil": (("building", "soil"), "", [("structure/support.h", "Soil"), ("structure/support.h", "soil_of")]),
    "Plan": (("plan",), "", []),
    "BuildingPlan": (("building", "plan"), "", []),
    "Plane": (("building", "plane"), "", []),
    "Rigidity": (("building", "rigidity"), "", []),
    "Building": (("building",), "Exactly one of frame, stick, matrices, modal, generic, displacements, plan, or ``rigid=True``.", []),
    "Contact": (("gap", "contact"), "", [(f"contact/laws/{law.split()[0]}.h", law.split()[1]) for law in LAWS]),
    "Gap": (("gap",), "`contact` is one of the laws of a case, or one of your own.", []),
    "Link": (("link",), "", [("elements/link_laws.h", "SpringDashpot"), ("elements/link_laws.h", "Cable"),
                             ("elements/kinematic_hardening.h", "KinematicHardening")]),
    "Excitation": (("excitation",), "``kind=\"spectrum\"`` and ``kind=\"displacements\"`` are for :func:`bentur.minimum_gap` alone, ``kind=\"suite\"`` for that, "
                   ":func:`bentur.run_suite` and, record by record, :func:`bentur.run`.", []),
    "Initial": (("initial",), "", []),
    "Analysis": (("analysis",), "", []),
    "Project": (("project",), "", []),
}
# What is of Python alone: a law of one's own.
ALSO = {("Gap", "contact"): "ForceLaw | BranchLaw", ("Link", "law"): "BranchLaw", ("Stick", "hysteresis"): "BranchLaw"}
LONG = {("Excitation", "values")}  # arrays that nobody wants to see printed
PLAIN = {"number": "float", "quantity": "float | str", "whole": "int", "flag": "bool", "text": "str", "line": "str",
         "file": "str | PathLike[str]"}


def table_at(schema, way):
    """The schema of a table: of a list of tables that of one, of what may be a number too the table. And what it is."""
    for step in way:
        schema = schema["properties"][step]
        title = schema["x-bentur"][0].get("table", "")
        schema = schema.get("items", schema)
        schema = next((one for one in schema.get("anyOf", []) if "properties" in one), schema)
    return schema, plain(title)


def words_of(told):
    found = []
    for one in told:
        found += [word for word in one.get("words", []) if word not in found]
    return "Literal[" + ", ".join(json.dumps(word) for word in found) + "]" if found else ""


def type_of(schema, name, way, key, told):
    first = told[0]
    if first["kind"] == "choice":
        words = " | ".join(filter(None, [words_of(told), ALSO.get((name, key))]))
        return words if first["form"] == "one" else f"{words} | Sequence[{words}]"
    if first["kind"] == "by_building":
        return "Mapping[str, Numbers]"
    if first["kind"] == "table":
        other = next((f"{other} | Table" for other, (place, *_) in CLASSES.items()
                      if place == (*way, key) or other == "Section" and key == "beams"), "Table")
        other = " | ".join([one for one in (other.removesuffix(" | Table"), ALSO.get((name, key)), "Table") if one and one != "Table"] + ["Table"])
        return f"Sequence[{other}]" if first["form"] == "list" else other
    if first["form"] == "matrix":
        return "ArrayLike"
    one = PLAIN[first["kind"]]
    if first["kind"] == "number" and first["form"] in ("list", "one_or_list"):
        one = "Numbers"
    elif first["form"] == "list":
        one = f"Sequence[{one} | Table]" if "table" in first else f"Sequence[{one}]"
    takes_table = any("properties" in way for way in schema.get("anyOf", []))
    also = [words_of(told), "Table" if takes_table else ""]
    return " | ".join([one, *filter(None, also)])


def plain(markdown):
    markdown = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", markdown)
    return re.sub(r"`([^`]*)`", r"``\1``", markdown)


def lines_of_key(key, told):
    """What is said of a key, once for all laws or kinds that say the same."""
    said = {}
    for one in told:
        text = one["value"] + (": " if one["value"] and one["doc"] else "") + one["doc"]
        without = one.get("default", "")
        text += ("; " if without.startswith("needed") else "; default " if without else "") + without
        owners = said.setdefault(text, {})
        for by, words in one.get("when", {}).items():
            owners.setdefault(by, []).extend(words)
    for text, owners in said.items():
        of = "".join(f", of {by} {', '.join(dict.fromkeys(words))}" for by, words in owners.items() if by != "rigid")
        of = f" ({of[2:]})" if of else ""
        yield from textwrap.wrap(plain(f"`{key}`{of}: {text}"), WIDTH - 6, initial_indent="- ", subsequent_indent="  ",
                                 break_long_words=False, break_on_hyphens=False)
    for word, doc in zip(told[0].get("words", []), told[0].get("word_docs", [])):
        yield from textwrap.wrap(f'- ``"{word}"``: {plain(doc)}', WIDTH - 6, subsequent_indent="  ", break_on_hyphens=False)


def class_of(root, schema, name):
    way, hand, headers = CLASSES[name]
    table, title = table_at(schema, way)
    heading = f"``[[{way[0]}]]``" if way in (("building",), ("gap",), ("link",)) else f"``[{'.'.join(way)}]``"
    told = [*textwrap.wrap(f'"""{heading}: {title}.', WIDTH - 4)]
    for paragraph in filter(None, hand.split("\n\n")):
        told += ["", *textwrap.wrap(paragraph, WIDTH - 4)]
    for n, (header, declaration) in enumerate(headers):
        if n == 0 or header != headers[n - 1][0]:
            told += ["", f"From ``{header}``:"]
        told += ["", *docstrings.of_header(root, header, declaration)]
    told += ["", "Keys:", ""]
    fields = []
    for key, said in table["properties"].items():
        told += lines_of_key(key, said["x-bentur"])
        kind = type_of(said, name, way, key, said["x-bentur"])
        if (name, key) in LONG:
            fields.append(f"{key}: ArrayLike | None = field(default=None, repr=False)")
        elif key in table.get("required", []) and not any("when" in one for one in said["x-bentur"]):
            fields.append(f"{key}: {kind}")
        elif name == "Units" and "default" in said:
            fields.append(f"{key}: {kind} = {json.dumps(said['default'])}")
        else:
            fields.append(f"{key}: {kind} | None = None")
    lines = ["@dataclass(kw_only=True, slots=True)", f"class {name}(Shown):"]
    lines += ["    " + line if line else "" for line in [*told, '"""', "", *fields]]
    return "\n".join(lines) + "\n\n\n"


def written(root, schema):
    exported = sorted([*CLASSES, "Branch", "BranchLaw", "ForceLaw", "Guard"])
    names = "__all__ = [\n" + "".join(f'    "{name}",\n' for name in exported) + "]\n\n\n"
    classes = "".join(class_of(root, schema, name) for name in CLASSES)
    ways = [*((way, name) for name, (way, *_) in CLASSES.items()), (("building", "frame", "beams"), "Section"),
            (("excitation", "y"), "Excitation")]
    tables = "".join(f"    {json.dumps(list(way))[1:-1].join(['(', ',)' if len(way) == 1 else ')'])}: {name},\n" for way, name in ways)
    return HEAD + names + classes + f"#: The class of each table, by the way to it.\nTABLES: dict[tuple[str, ...], type[Shown]] = {{\n{tables}}}\n"


def main(file):
    import _core  # of the build

    root = pathlib.Path(__file__).resolve().parents[1]
    text = written(root, json.loads(_core.schema(False)))
    out = pathlib.Path(file)
    if out.is_symlink():  # into the sources, of a build by an older version
        out.unlink()
    if not out.exists() or out.read_text() != text:
        out.write_text(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
