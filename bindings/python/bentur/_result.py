"""What a run gives."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._errors import missing

if TYPE_CHECKING:
    import pandas
    import xarray

    from ._case import Case

Floats = NDArray[np.float64]

# Of the report a notebook shows verdict and motion.
_FIRST_SCREEN = "<style>section:not(#verdict):not(#motion), footer, nav { display: none } body { zoom: 0.72; padding-top: 1rem }</style>"


class Result:
    """A run: summary, impacts, histories.

    The numbers are those of ``bentur run``, to the bit. Arrays look into the run's own memory and cannot be
    written to; they keep it alive.
    """

    def __init__(self, run: _core.Run, case: Case, laws: list[tuple[int, _core.ContactLaw]]) -> None:
        self._run = run
        self._laws = laws
        self.case = case
        self._summary: dict[str, Any] | None = None
        self._histories: dict[str, Any] | None = None
        self._exact: dict[str, Any] | None = None
        self._shown: _core.Run | None = None

    @property
    def summary(self) -> dict[str, Any]:
        """The summary as ``summary.json`` has it (docs/result-files.md)."""
        if self._summary is None:
            self._summary = json.loads(self.to_json())
        assert self._summary is not None
        return self._summary

    def to_json(self) -> str:
        """The summary as ``bentur run CASE --json`` prints it."""
        return self._run.summary_json()

    @property
    def remarks(self) -> list[str]:
        """Numbers of case and response that are unusual, in words."""
        return self._run.remarks()

    @property
    def units(self) -> dict[str, str]:
        """``length`` and ``force``; time is in s."""
        return {"length": self.case.length, "force": self.case.force}

    @property
    def impact_count(self) -> int:
        return len(self._run.places()["impact_points"])

    @property
    def impact_arrays(self) -> dict[str, Floats]:
        """Each number of the impacts as an array, one entry per impact, by start; NaN where there is none."""
        return {key: values for _, _, _, _, values, key, _ in self._run.impact_quantities()}

    @property
    def impacts(self) -> pandas.DataFrame:
        """One row per impact, by start; the columns of ``impacts.csv``. ``attrs["units"]`` has their units.

        :raises ImportError: without pandas.
        """
        try:
            import pandas
        except ImportError:
            raise missing("pandas", "the table of impacts") from None
        places = self._run.places()
        at = [places["points"][i] for i in places["impact_points"]]
        columns: dict[str, Any] = {
            "left": [p[0] for p in at],
            "right": [p[1] for p in at],
            "elevation": np.array([p[2] for p in at], dtype=float),
            "struck": [p[4] for p in at],
        }
        units = {"elevation": self.case.length}
        for _, unit, _, _, values, key, whole in self._run.impact_quantities():
            columns[key] = values.astype(bool) if whole else values
            units[key] = unit
        table = pandas.DataFrame(columns)
        table.attrs["units"] = units
        return table

    @property
    def histories(self) -> dict[str, Any]:
        """Samples every ``analysis.output_step``, by name. Nothing is copied.

        ``time`` [s], ``ground_acceleration``: samples. ``opening``, ``force``: samples × contact points.
        ``displacement``, ``velocity``, ``acceleration``, ``drift_ratio``, ``storey_shear``: a list with samples ×
        floors for each building. ``node_displacement``: a list with samples × places where floors strike columns for
        each building, None where there are none; ``column_forces``: with the forces at the ends of both pieces, six a
        place, as ``histories.nc`` has them from ``node_shear_below`` to ``node_moment_top``. With ``energy_audit`` also ``energy_input`` and so on.

        :raises ValueError: for a run with ``histories=False``.
        """
        if self._histories is None:
            self._histories = self._run.histories()
        if not self._histories:
            raise ValueError("this run has no histories: run it with histories=True")
        return self._histories

    @property
    def exact(self) -> dict[str, Any]:
        """The exact course: between its instants straight lines follow the solution, impacts and peaks included.

        ``time`` [s]: instants, close together where much happens; two at one time where a force jumps. ``opening``,
        ``force``: instants × contact points. ``displacement``: a list with instants × floors for each building.
        ``drift_ratio``, ``storey_shear`` (of buildings that can yield) and ``node_displacement`` (of columns that are
        struck): likewise, None for the others. Nothing is copied. How close the lines follow: docs/result-files.md.

        :raises ValueError: for a run with ``histories=False``, and where the motion is so fast that to follow it would
            take too many steps.
        """
        if self._exact is None:
            self._exact = self._run.course()
        if not self._exact:
            self.histories  # noqa: B018  # says so where there are none at all
            raise ValueError("this run has no exact course: the motion is too fast to be followed; histories has samples")
        return self._exact

    @property
    def exact_dataset(self) -> xarray.Dataset:
        """The exact course with units, under the names of group ``exact`` of ``histories.nc``.

        :raises ImportError: without xarray.
        :raises ValueError: as :attr:`exact`.
        """
        try:
            import xarray
        except ImportError:
            raise missing("xarray", "the Dataset of a run") from None
        data: xarray.Dataset = _exact_dataset(self, xarray)
        return data

    @property
    def dataset(self) -> xarray.Dataset:
        """Histories and quantities, with units, under the names of ``histories.nc``.

        :raises ImportError: without xarray.
        """
        try:
            import xarray
        except ImportError:
            raise missing("xarray", "the Dataset of a run") from None
        data: xarray.Dataset = _dataset(self, xarray)
        return data

    @property
    def gaps(self) -> dict[str, Any]:
        """The gap that each contact point needs, as ``bentur gap CASE --json`` prints it."""
        found: dict[str, Any] = json.loads(self._run.gap_json())
        return found

    def save(self, folder: str | Path) -> list[Path]:
        """Writes ``summary.json``, ``impacts.csv`` and, where there are histories and xarray and netCDF4 are installed,
        ``histories.nc``; makes the folder.

        :returns: the files written.
        """
        into = Path(folder)
        into.mkdir(parents=True, exist_ok=True)
        texts = {"summary.json": self.to_json(), "impacts.csv": self._run.impacts_csv()}
        if self.case.text is not None:
            texts["case.toml"] = self.case.text
        written = []
        for name, text in texts.items():
            temporary = into / (name + ".new")
            temporary.write_text(text, encoding="utf-8", newline="")
            temporary.replace(into / name)
            written.append(into / name)
        if not self._run.histories():
            return written
        try:
            import netCDF4  # noqa: F401

            data = self.dataset
        except ImportError:
            return written
        temporary = into / "histories.nc.new"
        data.to_netcdf(temporary)
        if self._run.course():
            self.exact_dataset.to_netcdf(temporary, mode="a", group="exact")
        temporary.replace(into / "histories.nc")
        return [*written, into / "histories.nc"]

    def report(self, language: str = "en") -> str:
        """The report of the run as one HTML page, without figures: ``bentur report`` has these.

        :param language: ``"en"`` or ``"id"``.
        """
        run = self._run if self._run.histories() else self._at_report_step()
        return run.report_html(language)

    def _at_report_step(self) -> _core.Run:
        """The run with histories close enough for the motion of its page; solved once."""
        if self._shown is None:
            step = _core.report_output_step(self.case._made)
            self._shown = _core.solve(self.case._made, step, self._laws, None)
        return self._shown

    def _repr_html_(self) -> str:
        """The first screen of the report, with the buildings in motion: what a notebook shows."""
        page = self._at_report_step().report_html("en").replace("</head>", _FIRST_SCREEN + "</head>", 1)
        page = page.replace("&", "&amp;").replace('"', "&quot;")
        # A frame of its own: neither the notebook's style nor its scripts reach the page, nor the other way round.
        return (
            f'<iframe srcdoc="{page}" sandbox="allow-scripts allow-downloads" loading="lazy" '
            'style="width:100%;height:760px;border:1px solid #ccc"></iframe>'
        )

    def __str__(self) -> str:
        lines = [self.summary["title"]] if self.summary["title"] else []
        length, force = self.case.length, self.case.force
        for gap in self.summary["gaps"]:
            points = gap["points"]
            impacts = sum(point["impacts"] for point in points)
            name = " | ".join(gap["between"])
            if impacts == 0:
                lines.append(f"{name}: no pounding")
            else:
                hit = sum(point["impacts"] > 0 for point in points)
                hardest = max(points, key=lambda point: float(point["peak_force"]))
                lines.append(f"{name}: pounding, {impacts} impacts at {hit} of {len(points)} contact points")
                if hardest["peak_force_time"] is not None:
                    lines.append(
                        f"  hardest {hardest['peak_force']:.4g} {force} at level {hardest['elevation']:g} {length}, "
                        f"t = {hardest['peak_force_time']:.4g} s"
                    )
            lines.append(f"  {gap['gap_needed']:.4g} {length} are needed to stay apart")
            lines += [f"  not modelled: {one['to_model']}" for one in gap["unmodelled_contact"]]
        if self.summary["status"] == "collapsed":
            lines.append(f"collapsed: {self.summary['collapse']}")
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<bentur.Result of {self.case!r}>\n{self}"


#: Of the forces at the ends of a struck column, in the order of ``column_forces``: names in ``histories.nc``.
_COLUMN_ENDS = {
    "node_shear_below": "shear of struck columns below the node",
    "node_shear_above": "shear of struck columns above the node",
    "node_moment_bottom": "moment at the bottom of struck columns",
    "node_moment_below": "moment of struck columns at the node, of the piece below it",
    "node_moment_above": "moment of struck columns at the node, of the piece above it",
    "node_moment_top": "moment at the top of struck columns",
}


def _dataset(result: Result, xarray: Any) -> Any:
    run = result._run
    case = result.case
    places = run.places()
    histories = result.histories
    length, force = case.length, _core.udunit(case.force)
    variables: dict[str, Any] = {}
    put = _putter(variables)

    def quantities(found: list[Any], dims: tuple[str, ...], suffix: str = "", of: str = "") -> None:
        for name, units, what, symbol, values, _, _ in found:
            more = {"symbol": symbol} if symbol else {}
            put(name + suffix, dims, values if dims else values[0], units, what + of, **more)

    put("time", ("time",), histories["time"], "s", "time")
    put("ground_acceleration", ("time",), histories["ground_acceleration"], f"{length} s-2", "ground acceleration")
    for b, building in enumerate(places["buildings"]):
        number, floors = f"_{b + 1}", f"elevation_{b + 1}"
        owner = f'building "{building["name"]}"'
        put("base_elevation" + number, (), building["base_elevation"], length, "elevation of the base of " + owner)
        of_floors = {
            "displacement": (length, "displacement relative to the own base of the floors of "),
            "velocity": (f"{length} s-1", "velocity relative to the own base of the floors of "),
            "acceleration": (f"{length} s-2", "absolute acceleration of the floors of "),
            "drift_ratio": ("1", "relative floor displacement over the height of the storeys of "),
            "storey_shear": (force, "sum of the elastic forces of all floors above the foot of the storeys of "),
        }
        for name, (units, what) in of_floors.items():
            put(name + number, ("time", floors), histories[name][b], units, what + owner)
        base_shear = histories["storey_shear"][b][:, 0]
        put("base_shear" + number, ("time",), base_shear, force, "shear of the lowest storey of " + owner)
        if len(building["node_elevation"]) > 0:
            nodes = f"node{number}"
            put("node_displacement" + number, ("time", nodes), histories["node_displacement"][b], length, "displacement")
            for end, (name, what) in enumerate(_COLUMN_ENDS.items()):
                units = f"{force} {length}" if "moment" in name else force
                put(name + number, ("time", nodes), histories["column_forces"][b][:, end::6], units, what)
        quantities(run.floor_quantities(b), (floors,), number, " of the floors of " + owner)
        quantities(run.building_quantities(b), (), number, " of " + owner)
    put("building_name", ("building",), [b["name"] for b in places["buildings"]], "", "names, from left to right")
    points = places["points"]
    if points:
        put("opening", ("time", "point"), histories["opening"], length, _OPENING)
        put("force", ("time", "point"), histories["force"], force, "contact force")
        if any(p[4] for p in points):
            put("point_struck", ("point",), [p[4] for p in points], "", "building whose column is struck, or nothing")
            put("point_node", ("point",), np.array([p[5] for p in points], dtype=np.int32), "", "number of its node")
            put("column_shear_capacity", ("point",), [p[6] for p in points], force, "shear that the column bears")
            put("column_moment_capacity", ("point",), [p[7] for p in points], f"{force} {length}", "moment that it bears")
        quantities(run.point_quantities(), ("point",))
    put("gap_name", ("gap",), places["gaps"], "", "buildings on both sides of the gaps")
    quantities(run.gap_quantities(), ("gap",))
    if places["links"]:
        put("link_elevation", ("link",), [k[2] for k in places["links"]], length, "elevation of the links")
        put("link_left", ("link",), [k[0] for k in places["links"]], "", "building to the left of the links")
        put("link_right", ("link",), [k[1] for k in places["links"]], "", "building to the right of the links")
        quantities(run.link_quantities(), ("link",))
    if places["impact_points"]:
        put("impact_point", ("impact",), places["impact_points"], "", "number of the contact point, counted from 0")
        quantities(run.impact_quantities(), ("impact",), "", " of each impact")
    quantities(run.run_quantities(), ())
    for name, values in histories.items():
        if name.startswith("energy_"):
            put(name, ("time",), values, f"{force} {length}", name.replace("_", " "))
    return _with_places(xarray, result, variables, {"gap_name", "building_name", "link_elevation", "link_left", "link_right"})


def _exact_dataset(result: Result, xarray: Any) -> Any:
    course = result.exact
    length, force = result.case.length, _core.udunit(result.case.force)
    variables: dict[str, Any] = {}
    put = _putter(variables)
    put("time", ("time",), course["time"], "s", "instants between which straight lines follow the solution")
    of_buildings = {
        "displacement": ("elevation", length, "displacement relative to the own base of the floors of "),
        "drift_ratio": ("elevation", "1", "relative floor displacement over the height of the storeys of "),
        "storey_shear": ("elevation", force, "shear of the storeys of "),
        "node_displacement": ("node", length, "displacement of struck columns where they are struck of "),
    }
    for name, (along, units, what) in of_buildings.items():
        for b, values in enumerate(course[name]):
            if values is not None:
                owner = f'building "{result.case.buildings[b]}"'
                put(f"{name}_{b + 1}", ("time", f"{along}_{b + 1}"), values, units, what + owner)
    if course["opening"].shape[1] > 0:
        put("opening", ("time", "point"), course["opening"], length, _OPENING)
        put("force", ("time", "point"), course["force"], force, "contact force")
    return _with_places(xarray, result, variables, set())


_OPENING = "opening of the contact points, negative in contact"


def _putter(variables: dict[str, Any]) -> Any:
    def put(name: str, dims: tuple[str, ...], values: Any, units: str, what: str, **more: str) -> None:
        attributes = {"long_name": what, **more}
        if units:
            attributes["units"] = units
        variables[name] = (dims, values, attributes)

    return put


def _with_places(xarray: Any, result: Result, variables: dict[str, Any], coordinates: set[str]) -> Any:
    """A Dataset with the places of floors, struck columns and contact points as coordinates, and those named."""
    places = result._run.places()
    length = result.case.length
    known: dict[str, Any] = {}
    put = _putter(known)
    for b, building in enumerate(places["buildings"]):
        owner = f'building "{building["name"]}"'
        put(f"elevation_{b + 1}", (f"elevation_{b + 1}",), building["elevation"], length, "elevation of the floors of " + owner)
        if len(building["node_elevation"]) > 0:
            nodes = f"node_{b + 1}"
            put(f"node_elevation_{b + 1}", (nodes,), building["node_elevation"], length, "where columns are struck")
    if places["points"]:
        left, right, elevation = zip(*(p[:3] for p in places["points"]), strict=True)
        put("point_elevation", ("point",), list(elevation), length, "elevation of the contact points")
        put("point_left", ("point",), list(left), "", "building to the left of the contact points")
        put("point_right", ("point",), list(right), "", "building to the right of the contact points")
    return xarray.Dataset(
        {name: one for name, one in variables.items() if name not in {*coordinates, "time"}},
        coords=known | {name: one for name, one in variables.items() if name in {*coordinates, "time"}},
        attrs={"title": result.case.title, "source": f"bentur {_core.version}", **_inputs(result)},
    )


def _inputs(result: Result) -> dict[str, str]:
    """Which case and record the results are of, where they were files."""
    told = {"case": result.summary.get("case"), "record": result.summary["excitation"]}
    keys = {"case": ("file", "sha256"), "record": ("file", "size", "sha256")}
    return {f"{of}_{key}": str(one[key]) for of, one in told.items() if one and one.get("sha256") for key in keys[of]}
