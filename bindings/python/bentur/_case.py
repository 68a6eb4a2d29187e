"""A case: what is asked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _core, _model
from ._own_laws import Table, table_of
from ._shown import html_of


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
        self._made = Case.from_dict(given, folder=folder)._made

    _made: _core.Case

    @classmethod
    def _of(cls, core: _core.Case) -> Case:
        case = cls.__new__(cls)
        case._made = core
        return case

    def _is_first_run(self, record: int | None) -> bool:
        """Whether nobody has asked that of this record yet; None: of the case."""
        asked: set[int | None] = self.__dict__.setdefault("_asked", set())
        is_first = record not in asked
        asked.add(record)
        return is_first

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
        return cls._of(_core.Case.from_values(tables, "", folder))

    def replace(self, values: Mapping[str, Any]) -> Case:
        """The same case with other values, by their keys: ``case.replace({"gap[0].width": 0.03})``.

        Keys are those of a study's ``parameter``; entries of a list count from 0, and those with a name can be named:
        ``building["A"].stick.masses[0]``.

        :raises CaseError: where that makes no case.
        """
        tables = table_of(_arguments.mapping("values", values, "values by their keys"))
        return Case._of(self._made.with_values(tables))

    def to_dict(self) -> dict[str, Any]:
        """The tables of the case as they were given; a record given as an array is one."""
        return self._made.values()

    def to_toml(self) -> str:
        """The case as the text of a case file: :meth:`from_text` with the same `folder` reads the same case of it. Of a
        case that was read from a file it is that file's text; a law of Python's own stands in it by its name alone.
        """
        return self._made.text_in(self.folder)

    def save(self, file: str | PathLike[str]) -> Path:
        """Writes the case file, for ``bentur run``, a report, or a colleague; one that is there is replaced. Files that
        the case names are found from there.

        :returns: the file.
        :raises ValueError: where a law of Python's own stands in the case, since no file can say it.
        """
        path = Path(_arguments.path("file", file))
        if self._made.has_own_law:
            raise ValueError("the case has a law of Python's own, which no file can say: pickle it, or give another law")
        path.write_text(self._made.text_in(path.parent), encoding="utf-8")
        return path

    def _read_back(self, key: str) -> Any:
        return _typed((key,), self.to_dict().get(key))

    @property
    def building(self) -> list[_model.Building]:
        """``case.building[0].stick.masses``: the tables of the case as classes again. They are copies: to change a case
        is to make another one by :meth:`replace`. So are `gap`, `excitation` and the others; what was not given is None,
        or an empty list."""
        found: list[_model.Building] = self._read_back("building")
        return found

    @property
    def gap(self) -> list[_model.Gap]:
        """As `building`."""
        return self._read_back("gap") or []

    @property
    def link(self) -> list[_model.Link]:
        """As `building`."""
        return self._read_back("link") or []

    @property
    def excitation(self) -> _model.Excitation:
        """As `building`."""
        found: _model.Excitation = self._read_back("excitation")
        return found

    @property
    def units(self) -> _model.Units:
        """As `building`; the defaults where none were given."""
        return self._read_back("units") or _model.Units()

    @property
    def plan(self) -> _model.Plan | None:
        """As `building`."""
        found: _model.Plan | None = self._read_back("plan")
        return found

    @property
    def initial(self) -> _model.Initial | None:
        """As `building`."""
        found: _model.Initial | None = self._read_back("initial")
        return found

    @property
    def analysis(self) -> _model.Analysis | None:
        """As `building`."""
        found: _model.Analysis | None = self._read_back("analysis")
        return found

    @property
    def code(self) -> dict[str, Any] | None:
        """As `building`, as a dictionary."""
        found: dict[str, Any] | None = self._read_back("code")
        return found

    @property
    def screening(self) -> dict[str, Any] | None:
        """As `building`, as a dictionary."""
        found: dict[str, Any] | None = self._read_back("screening")
        return found

    @property
    def project(self) -> _model.Project | None:
        """As `building`."""
        found: _model.Project | None = self._read_back("project")
        return found

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

    def _repr_html_(self) -> str:
        """What a notebook shows: title and tables."""
        return f"<h4>{escape(self.title or ' | '.join(self.buildings))}</h4>{html_of(self.to_dict())}"

    def __eq__(self, other: object) -> bool:
        """Whether both say the same, of files in the same folder; 1 and 1.0 are the same, and so are keys in another
        order."""
        return self._made.is_same(other._made) if isinstance(other, Case) else NotImplemented

    def __hash__(self) -> int:
        return hash((self.title, *self.buildings))

    def __reduce__(self) -> tuple[Any, ...]:
        if self.text is not None:
            return _unpickled, (self.text, self._made.name, str(self.folder))
        return _unpickled, (self.to_dict(), "", str(self.folder))


def _unpickled(content: str | dict[str, Any], name: str, folder: str) -> Case:
    if isinstance(content, str):
        return Case.from_text(content, name=name, folder=folder)
    return Case.from_dict(content, folder=folder)


def _typed(way: tuple[str, ...], value: Any) -> Any:
    """What stands in a case at a key, tables as their classes."""
    if isinstance(value, list):
        return [_typed(way, one) for one in value]
    if not isinstance(value, dict):
        return value
    inner = {key: _typed((*way, key), one) for key, one in value.items()}
    table = _model.TABLES.get(way)
    return inner if table is None else table(**inner)


def as_case(case: Case | str | PathLike[str]) -> Case:
    return case if isinstance(case, Case) else Case.from_file(_arguments.path("case", case))
