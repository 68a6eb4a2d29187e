"""bentur: seismic pounding of neighbouring buildings.

>>> import bentur
>>> result = bentur.run(bentur.example())
>>> print(result)

docs/python.md has the rest.
"""

from . import _core, _numpy

_numpy.check(_core.pybind11)  # before anything else

from . import _model
from ._case import Case
from ._core import version as __version__
from ._errors import CaseError, Finding, RefusedOutput, RemarkWarning, SolveError
from ._functions import (
    Record,
    Spectrum,
    example,
    examples,
    logarithmic_periods,
    height_rules,
    minimum_gap,
    modes,
    read_record,
    response_spectrum,
    run,
    run_suite,
    sensitivity,
)
from ._model import *
from ._result import Result
from ._sample import sample
from ._study import fragility, ida, remedy, risk, run_many, sweep, vary

__all__ = [
    "Case",
    "CaseError",
    "Finding",
    "Record",
    "RefusedOutput",
    "RemarkWarning",
    "Result",
    "SolveError",
    "Spectrum",
    "__version__",
    "example",
    "examples",
    "fragility",
    "ida",
    "logarithmic_periods",
    "height_rules",
    "minimum_gap",
    "modes",
    "read_record",
    "remedy",
    "response_spectrum",
    "risk",
    "run",
    "run_many",
    "run_suite",
    "sample",
    "sensitivity",
    "sweep",
    "vary",
]
__all__ += _model.__all__
