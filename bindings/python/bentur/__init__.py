"""bentur: seismic pounding of neighbouring buildings.

>>> import bentur
>>> result = bentur.run(bentur.example())
>>> print(result)

docs/python.md has the rest.
"""

from ._case import Case
from ._core import version as __version__
from ._errors import CaseError, Finding, RefusedOutput, SolveError
from ._functions import (
    Record,
    Spectrum,
    example,
    examples,
    logarithmic_periods,
    minimum_gap,
    modes,
    read_record,
    response_spectrum,
    run,
)
from ._model import (
    Analysis,
    Branch,
    BranchLaw,
    Building,
    Contact,
    Excitation,
    ForceLaw,
    Frame,
    Gap,
    Generic,
    Guard,
    Initial,
    Isolation,
    Link,
    Matrices,
    Modal,
    Section,
    Soil,
    Stick,
    Units,
)
from ._result import Result
from ._study import fragility, ida, sweep, vary

__all__ = [
    "Analysis",
    "Branch",
    "BranchLaw",
    "Building",
    "Case",
    "CaseError",
    "Contact",
    "Excitation",
    "Finding",
    "ForceLaw",
    "Frame",
    "Gap",
    "Generic",
    "Guard",
    "Initial",
    "Isolation",
    "Link",
    "Matrices",
    "Modal",
    "Record",
    "RefusedOutput",
    "Result",
    "Section",
    "Soil",
    "SolveError",
    "Spectrum",
    "Stick",
    "Units",
    "__version__",
    "example",
    "examples",
    "fragility",
    "ida",
    "logarithmic_periods",
    "minimum_gap",
    "modes",
    "read_record",
    "response_spectrum",
    "run",
    "sweep",
    "vary",
]
