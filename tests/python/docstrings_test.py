"""Classes and docstrings have the keys of docs/case-file.md, and the reader knows them."""

import dataclasses
import re
import types
import typing

import docstrings
import pytest
from doors import ROOT

import bentur

REFERENCE = (ROOT / "docs" / "case-file.md").read_text()
# What is of Python alone: a record given as an array.
OWN = {"Excitation": {"values"}}
CLASSES = list(docstrings.SECTIONS)


@pytest.mark.parametrize("file", docstrings.HEADERS)
def test_docstrings_are_what_headers_and_reference_say(file):
    assert (ROOT / docstrings.PACKAGE / file).read_text() == docstrings.written(ROOT, file), "./dev docstrings writes them"


def test_every_table_has_its_class():
    tables = [n for n in bentur.__all__ if dataclasses.is_dataclass(getattr(bentur, n)) and getattr(bentur, n).__module__ == "bentur._model"]
    assert sorted(CLASSES) == sorted(set(tables) - {"ForceLaw", "BranchLaw", "Branch", "Guard"})
    top = re.search(r"At the top level: (.*?)\.\n\n", REFERENCE, re.DOTALL)[1]
    parameters = bentur.Case.__init__.__annotations__.keys() - {"return", "folder"}
    assert set(re.findall(r"`\[*(\w+)\]*`", top)) == parameters


@pytest.mark.parametrize("name", CLASSES)
def test_keys_are_those_of_the_reference(name):
    rows = docstrings.keys_of(REFERENCE, name)
    told = {key for keys, *_, law in rows for key in (*keys, *law[1:])}
    if any(law for *_, law in rows):
        told.add("law")
    assert {field.name for field in dataclasses.fields(getattr(bentur, name))} - OWN.get(name, set()) == told


def choices(hint):
    """The texts of a Literal somewhere in a type."""
    if typing.get_origin(hint) is typing.Literal:
        return {one for one in typing.get_args(hint) if isinstance(one, str)}
    return set().union(*(choices(one) for one in typing.get_args(hint) if isinstance(one, typing._GenericAlias | types.UnionType)))


@pytest.mark.parametrize("name", CLASSES)
def test_choices_are_those_of_the_reference(name):
    rows = docstrings.keys_of(REFERENCE, name)
    for key, hint in typing.get_type_hints(getattr(bentur, name)).items():
        if not (known := choices(hint)):
            continue
        values = " ".join(value for keys, value, *_ in rows if key in keys)
        told = set(re.findall(r'``"([^"]+)"``', values)) or {law[0] for *_, law in rows if law}
        if span := re.match(r'.*``"(.)"`` to ``"(.)"``', values):
            told = {chr(one) for one in range(ord(span[1]), ord(span[2]) + 1)}
        elif key == "law":
            told = {law[0] for *_, law in rows if law}
        elif key == "stiffness":
            told &= {"axial"}
        assert known == told, key


BASE = """
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [3.0], masses = [1e5], stiffnesses = [4e6] }
[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [3.0], masses = [1e5], stiffnesses = [9e6] }
[[gap]]
between = ["A", "B"]
width = 0.02
contact = { law = "linear", stiffness = 1e8 }
[excitation]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.02
[analysis]
duration = 1.0
"""
PLACES = {
    "Units": ("units",), "Building": ("building", 0), "Frame": ("building", 0, "frame"),
    "Section": ("building", 0, "frame", "columns", 0), "Stick": ("building", 0, "stick"),
    "Matrices": ("building", 0, "matrices"), "Modal": ("building", 0, "modal"), "Generic": ("building", 0, "generic"),
    "Isolation": ("building", 0, "isolation"), "Soil": ("building", 0, "soil"), "Gap": ("gap", 0),
    "Contact": ("gap", 0, "contact"), "Link": ("link", 0), "Excitation": ("excitation",), "Initial": ("initial",),
    "Analysis": ("analysis",),
}
# Where what is known depends on a choice.
KINDS = {"Excitation": [{"kind": kind} for kind in ("record", "harmonic", "none", "spectrum")]}


@pytest.mark.parametrize("name", CLASSES)
def test_keys_are_those_of_the_reader(name):
    """Of an invented key it says which ones it knows."""
    tables = bentur.Case.from_text(BASE).to_dict()
    place = tables
    for step, then in zip(PLACES[name], (*PLACES[name][1:], None)):
        if isinstance(step, int):
            place.extend([{}] * (step + 1 - len(place)))
        else:
            place.setdefault(step, [] if isinstance(then, int) else {})
        place = place[step]
    known = set()
    for kind in KINDS.get(name, [{}]):
        with pytest.raises(bentur.CaseError) as caught:
            place.update(kind | {"zzzzzzzzzz": 1})
            bentur.Case.from_dict(tables)
        told = [m[1] for one in caught.value.errors if (m := re.search(r"zzz is not a known key, the known ones are (.*)", one.message))]
        assert len(told) == 1, str(caught.value)
        known |= set(told[0].split(", "))
    assert {field.name for field in dataclasses.fields(getattr(bentur, name))} - OWN.get(name, set()) == known
