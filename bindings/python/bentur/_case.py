"""A case: what is asked."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import astuple
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _core, _model
from ._errors import CaseError
from ._own_laws import Table, table_of


class Case:
    """A case, read and checked. It does not change: :meth:`replace` makes another one.

    Made from the tables of a case file, as classes (:class:`bentur.Building` and so on) or as dictionaries, under the
    file's names, which docs/case-file.md explains::

        case = bentur.Case(
            units=bentur.Units(length="m", force="kN"),
            building=[
                bentur.Building(name="A", damping=0.05, stick=bentur.Stick(
                    storey_heights=[3.0], masses=[30.0], stiffnesses=[4.0e4])),
                bentur.Building(name="B", damping=0.05, stick=bentur.Stick(
                    storey_heights=[3.0], masses=[30.0], stiffnesses=[9.0e4])),
            ],
            gap=[bentur.Gap(between=["A", "B"], width=0.02,
                            contact=bentur.Contact(law="kelvin-voigt", stiffness=1.0e5, restitution=0.65))],
            excitation=bentur.Excitation(kind="harmonic", period=0.5, displacement_amplitude=0.02),
            analysis=bentur.Analysis(duration=10.0),
        )

    Buildings in plan have a `plan` each (:class:`bentur.BuildingPlan`), and need no `gap` where the case's `plan` says
    from which clearance on they may touch.

    :param folder: the folder that record files are relative to.
    :raises CaseError: with all that is wrong. Values made in Python have no line; the key says where.
    """

    def __init__(
        self,
        *,
        building: Sequence[_model.Building | Table],
        excitation: _model.Excitation | Table,
        gap: Sequence[_model.Gap | Table] | None = None,
        title: str | None = None,
        units: _model.Units | Table | None = None,
        plan: _model.Plan | Table | None = None,
        link: Sequence[_model.Link | Table] | None = None,
        initial: _model.Initial | Table | None = None,
        analysis: _model.Analysis | Table | None = None,
        code: Table | None = None,
        screening: Table | None = None,
        project: _model.Project | Table | None = None,
        folder: str | PathLike[str] = ".",
    ) -> None:
        given = {key: value for key, value in locals().items() if key not in ("self", "folder")}
        made = Case.from_dict(given, folder=folder)
        self._made, self._files = made._made, made._files

    _made: _core.Case
    _files: Sequence[tempfile.TemporaryDirectory[str]]  # of records given as arrays; they live as long as the case

    @classmethod
    def _of(cls, core: _core.Case, files: Sequence[tempfile.TemporaryDirectory[str]] = ()) -> Case:
        case = cls.__new__(cls)
        case._made, case._files = core, files
        return case

    @classmethod
    def from_file(cls, file: str | PathLike[str]) -> Case:
        """Reads a case file (TOML) and the record it names.

        :raises CaseError: with every error, each with file, line and column.
        """
        return cls._of(_core.Case.from_file(_arguments.path("file", file)))

    @classmethod
    def from_text(cls, text: str, *, name: str = "case.toml", folder: str | PathLike[str] = ".") -> Case:
        """The same of a text; `name` is what messages call it, `folder` the one that record files are relative to."""
        told = _arguments.text("text", text), _arguments.text("name", name)
        return cls._of(_core.Case.from_text(*told, _arguments.path("folder", folder)))

    @classmethod
    def from_dict(cls, values: Mapping[str, Any], *, folder: str | PathLike[str] = ".") -> Case:
        """A case from the tables of a case file, as dictionaries or classes or both."""
        folder = _arguments.path("folder", folder)
        tables = table_of(_arguments.mapping("values", values, "the tables of a case"))
        files: list[tempfile.TemporaryDirectory[str]] = []
        _write_values(tables, files)
        with _naming_no_file(files):
            return cls._of(_core.Case.from_values(tables, "", folder), files)

    def replace(self, values: Mapping[str, Any]) -> Case:
        """The same case with other values, by their keys: ``case.replace({"gap[0].width": 0.03})``.

        Keys are those of a study's ``parameter``; entries of a list count from 0, and those with a name can be named:
        ``building["A"].stick.masses[0]``.

        :raises CaseError: where that makes no case.
        """
        tables = table_of(_arguments.mapping("values", values, "values by their keys"))
        with _naming_no_file(self._files):
            return Case._of(self._made.with_values(tables), self._files)

    def to_dict(self) -> dict[str, Any]:
        """The tables of the case as they were given."""
        return self._made.values()

    @property
    def title(self) -> str:
        return self._made.title

    @property
    def text(self) -> str | None:
        """The case file, where there is one."""
        return self._made.text

    @property
    def folder(self) -> Path:
        return Path(self._made.folder)

    @property
    def length(self) -> str:
        """The case's unit of length."""
        return self._made.length

    @property
    def force(self) -> str:
        """The case's unit of force."""
        return self._made.force

    @property
    def gravity(self) -> float:
        """[length/s²]"""
        return self._made.gravity

    @property
    def duration(self) -> float:
        """[s]"""
        return self._made.duration

    @property
    def buildings(self) -> list[str]:
        """Names, from left to right; of buildings in plan as the case has them."""
        return self._made.buildings

    def matrices(self, building: str | int) -> dict[str, NDArray[np.float64]]:
        """``mass`` [mass] and ``stiffness`` [force/length] of a building as the solver has them, condensed and
        calibrated, and ``elevations`` [length] of its floors."""
        if isinstance(building, str):
            number = self.buildings.index(_arguments.one_of("building", building, self.buildings))
        else:
            number = _arguments.whole("building", building, 0, len(self.buildings) - 1)
        return self._made.matrices(number)

    @property
    def acceleration(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Times [s] and accelerations [length/s²] of the record as applied, scaled; empty without a record. Of buildings
        in plan that of ``excitation``, without ``excitation.y``."""
        found = self._made.excitation
        if "acceleration" not in found:
            return np.empty(0), np.empty(0)
        values: NDArray[np.float64] = found["acceleration"]
        return float(found["time_step"]) * np.arange(len(values), dtype=np.float64), values

    def __repr__(self) -> str:
        return f"<bentur.Case {self.title or ' | '.join(self.buildings)!r}>"

    def __reduce__(self) -> tuple[Any, ...]:
        if self.text is not None:
            return _unpickled, (self.text, self._made.name, str(self.folder))
        return _unpickled, (_with_record(self), "", str(self.folder))


def _unpickled(content: str | dict[str, Any], name: str, folder: str) -> Case:
    if isinstance(content, str):
        return Case.from_text(content, name=name, folder=folder)
    return Case.from_dict(content, folder=folder)


def _with_record(case: Case) -> dict[str, Any]:
    """The tables, with a record that was given as an array put back."""
    tables = case.to_dict()
    excitation = tables["excitation"]
    if case._files and Path(excitation.get("file", "")).parent == Path(case._files[0].name).resolve():
        excitation["values"] = np.loadtxt(excitation.pop("file"))
        del excitation["format"]
    return tables


def _write_values(tables: dict[str, Any], files: list[tempfile.TemporaryDirectory[str]]) -> None:
    """A record that is given as an array becomes a file, to the last digit: one reader, one set of checks."""
    excitation = tables.get("excitation")
    if not isinstance(excitation, dict) or "values" not in excitation:
        return
    values = np.asarray(excitation.pop("values"), dtype=float).ravel()
    folder = tempfile.TemporaryDirectory(prefix="bentur-")
    files.append(folder)
    text = "\n".join(map(repr, values.tolist())) + "\n"
    file = Path(folder.name).resolve() / "values.txt"
    file.write_text(text, encoding="ascii")
    excitation["file"] = str(file)
    excitation.setdefault("format", "one-column")


@contextmanager
def _naming_no_file(files: Sequence[tempfile.TemporaryDirectory[str]]) -> Iterator[None]:
    """Errors of a record that was given as an array name its key, and the value by its line."""
    try:
        yield
    except CaseError as error:
        found = [astuple(one) for one in error.errors]
        for name in [str(Path(one.name).resolve() / "values.txt") for one in files]:
            found = [tuple(x.replace(name, "excitation.values") if isinstance(x, str) else x for x in one) for one in found]
        raise CaseError(found) from None


def as_case(case: Case | str | PathLike[str]) -> Case:
    return case if isinstance(case, Case) else Case.from_file(_arguments.path("case", case))
