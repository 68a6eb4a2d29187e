"""What goes wrong, as exceptions."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import astuple, dataclass
from importlib import import_module
from typing import Any

_MOST_TOLD = 20  # errors in the message of an exception
_Told = tuple[str, int, int, str, str, str, str, str]  # the fields of a Finding


@dataclass(frozen=True)
class Finding:
    """One error of a case, study or record.

    `line` and `column` count from 1; they are 0 where the value stands in no file, as that of a case
    made in Python. `key` is the way to it, as in ``building["A"].stick.masses``; it is empty where
    the message is of no key. `value` is what stands there, as the message shows it, `rule` what it
    breaks, and `suggestion` the word that may have been meant; each is empty where there is none.
    """

    file: str
    line: int
    column: int
    message: str
    key: str = ""
    value: str = ""
    rule: str = ""
    suggestion: str = ""

    def __str__(self) -> str:
        place = self.file
        if self.line > 0:
            place += f":{self.line}:{self.column}"
        return f"{place}: error: {self.message}" if place else f"error: {self.message}"


class CaseError(ValueError):
    """A case, study or record that is not right. `errors` has all that was found, each with its place."""

    errors: list[Finding]

    def __init__(self, errors: Iterable[_Told]) -> None:
        self.errors = [Finding(*one) for one in errors]
        lines = [str(one) for one in self.errors[:_MOST_TOLD]]
        if len(self.errors) > _MOST_TOLD:
            lines.append(f"and {len(self.errors) - _MOST_TOLD:,} more: .errors has them all")
        super().__init__("\n".join(lines))

    def __reduce__(self) -> tuple[type[CaseError], tuple[list[_Told]]]:
        return type(self), ([astuple(one) for one in self.errors],)


class SolveError(RuntimeError):
    """The numbers failed; the message says why and when."""


class RemarkWarning(UserWarning):
    """Numbers of a run that are unusual, or an input that may not be meant: what ``result.remarks`` has. Once a case."""


class RefusedOutput(FileExistsError):
    """Writing there would harm a file; the message names it, says why, and what to do. Nothing was written."""


def imported(name: str, what: str) -> Any:
    """A module that `what` needs. :raises ImportError: that says so where it is not there."""
    try:
        return import_module(name)
    except ImportError:
        package = name.partition(".")[0]
        raise ImportError(f"{what} needs {package}, which is not installed: pip install {package}") from None
