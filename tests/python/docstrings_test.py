"""Classes have the keys of the schema, and the reader knows them; docstrings are what headers say."""

import dataclasses
import json
import pathlib
import re
import types
import typing

import docstrings
import pytest
import python_classes
from doors import ROOT

import bentur

CLASSES = list(python_classes.CLASSES)


@pytest.fixture(scope="module")
def schema():
    return json.loads(bentur._core.schema(False))


@pytest.mark.parametrize("file", docstrings.HEADERS)
def test_docstrings_are_what_headers_say(file):
    assert (ROOT / docstrings.PACKAGE / file).read_text() == docstrings.written(ROOT, file), "./dev docstrings writes them"


def test_classes_are_what_schema_and_headers_say(schema):
    assert pathlib.Path(bentur._model.__file__).read_text() == python_classes.written(ROOT, schema)


def test_every_table_has_its_class(schema):
    tables = [n for n in bentur.__all__ if dataclasses.is_dataclass(getattr(bentur, n)) and getattr(bentur, n).__module__ == "bentur._model"]
    assert sorted(CLASSES) == sorted(tables)
    parameters = bentur.Case.__init__.__annotations__.keys() - {"return", "folder"}
    assert set(schema["properties"]) == parameters
    top = re.search(r"At the top level: (.*?)\.\n\n", (ROOT / "docs" / "case-file.md").read_text(), re.DOTALL)[1]
    assert set(re.findall(r"`\[*(\w+)\]*`", top)) == parameters


def choices(hint):
    """The texts of a Literal somewhere in a type."""
    if typing.get_origin(hint) is typing.Literal:
        return {one for one in typing.get_args(hint) if isinstance(one, str)}
    return set().union(*(choices(one) for one in typing.get_args(hint) if isinstance(one, typing._GenericAlias | types.UnionType)))


@pytest.mark.parametrize("name", CLASSES)
def test_keys_and_choices_are_those_of_the_schema(name, schema):
    table = python_classes.table_at(schema, python_classes.CLASSES[name][0])[0]["properties"]
    hints = typing.get_type_hints(getattr(bentur, name))
    assert hints.keys() == table.keys()
    for key, said in table.items():
        assert choices(hints[key]) == {word for told in said["x-bentur"] for word in told.get("words", [])}, key
        assert f"``{key}``" in getattr(bentur, name).__doc__


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
    "Displacements": ("building", 0, "displacements"),
    "Plan": ("plan",), "BuildingPlan": ("building", 0, "plan"), "Plane": ("building", 0, "plane", 0),
    "Rigidity": ("building", 0, "rigidity"), "Isolation": ("building", 0, "isolation"), "Soil": ("building", 0, "soil"), "Gap": ("gap", 0),
    "Contact": ("gap", 0, "contact"), "Link": ("link", 0), "Excitation": ("excitation",), "Initial": ("initial",),
    "Analysis": ("analysis",), "Project": ("project",),
}
# Where what is known depends on a choice.
KINDS = {"Excitation": [{"kind": kind} for kind in ("record", "harmonic", "none", "spectrum", "suite", "displacements")]}


@pytest.mark.parametrize("name", CLASSES)
def test_keys_are_those_of_the_reader(name, schema):
    """Of an invented key it says which ones it knows, but those that are for another choice."""
    tables = bentur.Case.from_text(BASE).to_dict()
    place = tables
    for step, then in zip(PLACES[name], (*PLACES[name][1:], None)):
        if isinstance(step, int):
            place.extend([{}] * (step + 1 - len(place)))
        else:
            place.setdefault(step, [] if isinstance(then, int) else {})
        place = place[step]
    if name in ("Plane", "Rigidity"):  # of buildings in plan alone
        tables["building"][0]["plan"] = {}
    known = set()
    for kind in KINDS.get(name, [{}]):
        with pytest.raises(bentur.CaseError) as caught:
            place.update(kind | {"zzzzzzzzzz": 1})
            bentur.Case.from_dict(tables)
        told = [m[1] for one in caught.value.errors if (m := re.search(r"zzz is not a known key, the known ones are (.*)", one.message))]
        assert len(told) == 1, str(caught.value)
        known |= set(told[0].split(", "))
    fields = {field.name for field in dataclasses.fields(getattr(bentur, name))}
    table = python_classes.table_at(schema, python_classes.CLASSES[name][0])[0]["properties"]
    assert known <= fields
    assert fields - known <= {key for key, said in table.items() if all(told.get("when") for told in said["x-bentur"])}
