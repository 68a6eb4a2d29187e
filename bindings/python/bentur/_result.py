"""What a run gives."""

from __future__ import annotations

import json
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _core
from ._dataset import Variable, by_name, dataset, is_histories, netcdf
from ._errors import imported

if TYPE_CHECKING:
    import pandas
    import xarray

    from ._case import Case

Floats = NDArray[np.float64]

# Of the report a notebook shows verdict and motion.
_FIRST_SCREEN = "<style>section:not(#verdict):not(#motion), footer, nav { display: none } body { zoom: 0.72; padding-top: 1rem }</style>"


class Picture:
    """A figure as SVG. Notebooks show it; PDF and PNG are made of it by ``rsvg-convert`` or a browser."""

    def __init__(self, svg: str) -> None:
        #: The whole file, as text.
        self.svg = svg

    def save(self, file: str | Path) -> Path:
        """Writes the SVG; one that is there is replaced.

        :raises ValueError: where the name does not end in ``.svg``.
        """
        path = Path(_arguments.path("file", file))
        if path.suffix != ".svg":
            raise ValueError(f'file = "{file}", must end in .svg')
        path.write_text(self.svg, encoding="utf-8")
        return path

    def _repr_svg_(self) -> str:
        return self.svg


class Result:
    """A run: summary, impacts, histories.

    The numbers are those of ``bentur run``, to the bit. Arrays look into the run's own memory and cannot be
    written to; they keep it alive.

    Histories are made when they are first asked for, unless ``run`` was told otherwise: the case is then solved once
    more, with samples. A result can be copied and pickled, with its case, its summary, its impacts, and what else has
    been made of it; what is asked for later is solved anew, with the same numbers.
    """

    def __init__(
        self,
        run: _core.Run,
        case: Case,
        *,
        record: int | None = None,
        output_step: float | None = None,
        histories: bool | None = True,
    ) -> None:
        self._run = run
        self.case = case
        self._record = record
        self._step = output_step or case._made.output_step
        self._histories = histories
        if histories:
            self._full = run

    def _solved(self, step: float | None) -> _core.Run:
        """The same run with samples every so many seconds; 0: without; None: as a report needs them."""
        made = self.case._made if self._record is None else self.case._made.with_record(self._record)
        return _core.solve(made, step, None)

    # What is set at the beginning, or made where it is first asked for.

    @cached_property
    def _run(self) -> _core.Run:
        return self._solved(self._step if self._histories else 0.0)

    @cached_property
    def _full(self) -> _core.Run:
        """With samples, unless none are wanted."""
        return self._solved(self._step) if self._histories is None else self._run

    @cached_property
    def _at_report_step(self) -> _core.Run:
        """The run with histories close enough for the motion of its page."""
        return self._solved(None)

    @cached_property
    def _json(self) -> str:
        return self._run.summary_json()

    @cached_property
    def _numbers_of_impacts(self) -> list[tuple[str, str, Floats, bool]]:
        return self._run.impacts()

    @cached_property
    def _said(self) -> list[str]:
        """The verdict in English."""
        return self._run.lines("en")

    @cached_property
    def _quantities(self) -> tuple[dict[str, Any], list[Variable]]:
        """What ``histories.nc`` holds but for samples."""
        return self._run.variables()

    def __getstate__(self) -> dict[str, Any]:
        for name in ("_json", "_numbers_of_impacts", "_said", "_quantities", "remarks"):
            getattr(self, name)
        solved = ("_run", "_full", "_at_report_step")
        return {name: value for name, value in self.__dict__.items() if name not in solved}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        for _, variables in filter(None, (state.get("_quantities"), state.get("_file"))):
            for _, _, values, _ in variables:
                values.flags.writeable = False

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The summary as ``summary.json`` has it (docs/result-files.md)."""
        found: dict[str, Any] = json.loads(self._json)
        return found

    def to_json(self) -> str:
        """The summary as ``bentur run CASE --json`` prints it."""
        return self._json

    @cached_property
    def remarks(self) -> list[str]:
        """Numbers of case and response that are unusual, in words: :func:`bentur.run` warns of them once a case."""
        return self._run.remarks("en")

    @property
    def units(self) -> dict[str, str]:
        """``length`` and ``force``; time is in s."""
        return {"length": self.case.length, "force": self.case.force}

    @cached_property
    def _file(self) -> tuple[dict[str, Any], list[Variable]]:
        """What ``histories.nc`` holds: its attributes and variables."""
        return self._quantities if self._histories is False else self._full.variables()

    def _values(self, name: str) -> Any:
        """Of a variable that is no sample; none where there is no such variable."""
        return next((values for found, _, values, _ in self._quantities[1] if found == name), np.empty(0))

    @property
    def _in_plan(self) -> bool:
        return any(name == "footprint_1" for name, *_ in self._quantities[1])

    @property
    def impact_count(self) -> int:
        return len(self._numbers_of_impacts[0][2])

    @property
    def impact_arrays(self) -> dict[str, Floats]:
        """Each number of the impacts as an array, one entry per impact, by start; NaN where there is none."""
        return {key: values for key, _, values, _ in self._numbers_of_impacts}

    @property
    def impacts(self) -> pandas.DataFrame:
        """One row per impact, by start; the columns of ``impacts.csv``. ``attrs["units"]`` has their units.

        :raises ImportError: without pandas.
        """
        at = self._values("impact_point").astype(int)
        places = ("elevation", "x", "y") if self._in_plan else ("elevation",)
        columns: dict[str, Any] = {name: self._values("point_" + name)[at] for name in ("left", "right", *places)}
        if not self._in_plan:
            struck = self._values("point_struck")
            columns["struck"] = struck[at] if len(struck) else [""] * len(at)
        units = dict.fromkeys(places, self.case.length)
        for key, unit, values, whole in self._numbers_of_impacts:
            columns[key] = values.astype(bool) if whole else values
            units[key] = unit
        table: Any = imported("pandas", "the table of impacts").DataFrame(columns)
        table.attrs["units"] = units
        return table

    @property
    def histories(self) -> dict[str, Any]:
        """Samples every ``analysis.output_step``, by their names in ``histories.nc``.

        ``time`` [s], ``ground_acceleration``: samples. ``opening``, ``force``: samples × contact points.
        ``displacement``, ``velocity``, ``acceleration``, ``drift_ratio``, ``storey_shear``: a list with samples ×
        floors for each building; ``base_shear``: with samples. ``node_displacement``, and ``node_shear_below`` to
        ``node_moment_top``: a list with samples × places where floors strike columns for each building, None where
        there are none, and left out where no building has any; likewise ``foundation_sway`` to ``soil_moment`` of
        buildings on soil. ``link_deformation``, ``link_force``: samples × links, left out without any. With
        ``energy_audit`` also ``energy_input`` and so on.

        Of buildings in plan ``ground_acceleration`` is samples × components; ``displacement_x``, ``displacement_y``,
        ``rotation``, ``acceleration_x``, ``acceleration_y``: a list with samples × floors for each building;
        ``opening``, ``force`` and, with friction, ``slip`` and ``force_along``: samples × contact points.

        :raises ValueError: for a run with ``histories=False``.
        """
        found = by_name(self._file[1], len(self.case.buildings))
        if not found:
            raise ValueError("this run has no histories: run it with histories=True")
        return found

    @property
    def exact(self) -> dict[str, Any]:
        """The exact course: between its instants straight lines follow the solution, impacts and peaks included.

        ``time`` [s]: instants, close together where much happens; two at one time where a force jumps. ``opening``,
        ``force``: instants × contact points. ``displacement``: a list with instants × floors for each building.
        ``drift_ratio``, ``storey_shear`` (of buildings that can yield) and ``node_displacement`` (of columns that are
        struck): likewise, None for the others, and left out where no building has any; of links and foundations as
        ``histories``. How close the lines follow: docs/result-files.md. In plan ``displacement_x``, ``displacement_y``
        and ``rotation``, of at most six buildings.

        :raises ValueError: for a run with ``histories=False``, and where the motion is so fast that to follow it would
            take too many steps.
        """
        found = by_name(self._file[1], len(self.case.buildings), "exact")
        if not found:
            self.histories  # noqa: B018  # says so where there are none at all
            if self._in_plan:
                raise ValueError("more than six buildings in plan have no exact course; histories has samples")
            raise ValueError("this run has no exact course: the motion is too fast to be followed; histories has samples")
        return found

    @property
    def _course(self) -> dict[str, Any]:
        """The exact course; where the motion is too fast for one, the samples."""
        return by_name(self._file[1], len(self.case.buildings), "exact") or self.histories

    @property
    def exact_dataset(self) -> xarray.Dataset:
        """The exact course with units, under the names of group ``exact`` of ``histories.nc``.

        :raises ImportError: without xarray.
        :raises ValueError: as :attr:`exact`.
        """
        self.exact  # noqa: B018  # says so where there is none
        data: xarray.Dataset = dataset("the Dataset of a run", *self._file, "exact")
        return data

    @property
    def dataset(self) -> xarray.Dataset:
        """Histories and quantities, with units, under the names of ``histories.nc``.

        :raises ImportError: without xarray.
        """
        self.histories  # noqa: B018  # says so where there are none
        data: xarray.Dataset = dataset("the Dataset of a run", *self._file)
        return data

    @property
    def gaps(self) -> dict[str, Any]:
        """The gap that each contact point needs, as ``bentur gap CASE --json`` prints it."""
        found: dict[str, Any] = json.loads(self._run.gap_json())
        return found

    @cached_property
    def sensitivity(self) -> dict[str, Any]:
        """The derivatives of gap needed, peak force and displacements by every number of the case, through the events,
        as ``bentur sensitivity CASE --json`` prints them (docs/sensitivity.md). Found when first asked for. Of a record of
        a suite they are those of the suite, with each record's own, as of :func:`bentur.sensitivity`.

        :raises CaseError: for buildings that yield, friction, or a contact law with a curved force.
        """
        found: dict[str, Any] = json.loads(_core.sensitivity_json(self.case._made, [], None))
        return found

    @property
    def gradient(self) -> pandas.DataFrame:
        """:attr:`sensitivity` as a table: a row for each number of the case, a column for each peak, by its quantity,
        its gap or building, and its level; in plan also by x and y of a contact point.

        :raises CaseError: as :attr:`sensitivity`.
        :raises ImportError: without pandas.
        """
        pandas: Any = imported("pandas", "the table of derivatives")
        found = self.sensitivity
        peaks = found["peaks"]
        names = ("quantity", "of", "level", "x", "y") if self._in_plan else ("quantity", "of", "level")
        columns = [
            (peak["quantity"], peak.get("gap", peak.get("building")), peak["level"], *peak.get("at", (None, None)))[: len(names)]
            for peak in peaks
        ]
        table: Any = pandas.DataFrame(
            np.array([peak["gradient"] for peak in peaks]).reshape(len(peaks), len(found["numbers"])).T,
            index=[number["path"] for number in found["numbers"]],
            columns=pandas.MultiIndex.from_tuples(columns, names=names),
        )
        return table

    def save(self, folder: str | Path, *, force: bool = False) -> list[Path]:
        """Writes what ``bentur run -o`` writes: ``summary.json``, ``impacts.csv``, the copy of a case that was a file
        and, where there are histories and netCDF4 is installed, ``histories.nc``. Makes the folder. All of them appear
        together or not at all. No file that the run has read is ever overwritten, nor one that is there and is no
        result of the same kind.

        :param force: files that are no results may be replaced.
        :returns: the files written.
        :raises RefusedOutput: naming the file that would be harmed; nothing was written.
        """
        into = Path(_arguments.path("folder", folder))
        histories = None if self._histories is False else netcdf(*self._file)
        return [into / name for name in self._run.save(self.case._made, into, histories, is_histories, force)]

    @property
    def figures(self) -> dict[str, str]:
        """The kinds of figure that the run can give (docs/figures.md), each with what it shows."""
        return dict(self._drawn_from.figure_kinds())

    def plot(
        self,
        kind: str = "overview",
        *,
        language: str = "en",
        width: float | None = None,
        start: float | None = None,
        end: float | None = None,
        gap: int | None = None,
        elevation: float | None = None,
    ) -> Picture:
        """A figure of the run, as ``bentur plot`` draws it; notebooks show it.

        :param kind: one of :attr:`figures`.
        :param language: ``"en"`` or ``"id"``.
        :param width: of the figure [cm]; else 8.8, a journal's column, or 17, a page, for panels beside one another.
        :param start: of histories: first time [s].
        :param end: of histories: last time [s].
        :param gap: counted from 0; else the one that is hit hardest.
        :param elevation: of the contact point [length]; else the one that is hit hardest.
        :raises ValueError: where the run cannot give it, naming what it can.
        """
        number = _arguments.number
        return Picture(
            self._drawn_from.figure_svg(
                _arguments.text("kind", kind),
                _arguments.text("language", language),
                None if width is None else _arguments.positive("width", width),
                None if start is None else number("start", start),
                None if end is None else number("end", end),
                None if gap is None else _arguments.whole("gap", gap, 0),
                None if elevation is None else number("elevation", elevation),
            )
        )

    @property
    def _drawn_from(self) -> _core.Run:
        return self._at_report_step if self._histories is False else self._full

    def report(self, language: str = "en") -> str:
        """The report of the run as one HTML page, as ``bentur report`` writes it; with ``project`` in the case it is
        one to hand in.

        :param language: ``"en"`` or ``"id"``.
        """
        return self._drawn_from.report_html(_arguments.text("language", language), self.case._made)

    def _repr_html_(self) -> str:
        """The first screen of the report, with the buildings in motion: what a notebook shows."""
        page = self._at_report_step.report_html("en").replace("</head>", _FIRST_SCREEN + "</head>", 1)
        page = page.replace("&", "&amp;").replace('"', "&quot;")
        # A frame of its own: neither the notebook's style nor its scripts reach the page, nor the other way round.
        return (
            f'<iframe srcdoc="{page}" sandbox="allow-scripts allow-downloads" loading="lazy" '
            'style="width:100%;height:760px;border:0"></iframe>'
        )

    def verdict(self, language: str = "en") -> list[str]:
        """What is to be said of the run, the gravest first, as ``bentur run`` prints it and the report begins, and after
        the sentences a line for each row of what else is known; without remarks. The same without words, as numbers with their units, is ``summary["statements"]``.

        :param language: ``"en"`` or ``"id"``.
        """
        return self._said if language == "en" else self._run.lines(_arguments.text("language", language))

    def __str__(self) -> str:
        title = [self.summary["title"]] if self.summary["title"] else []
        return "\n".join([*title, *self.verdict(), *(f"remark: {one}" for one in self.remarks)])

    def __repr__(self) -> str:
        return f"<bentur.Result of {self.case!r}>\n{self}"
