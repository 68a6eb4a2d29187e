"""What goes wrong, as exceptions."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

_KEY = re.compile(r'^[A-Za-z_][\w-]*(?:\.[\w-]+|\["(?:[^"\\]|\\.)*"\]|\[\d+\])*')
# A word without "." and "[" is a key where it is one of a case's, or where this stands behind it; else a sentence begins.
_TABLES = {"title", "units", "building", "gap", "link", "excitation", "initial", "analysis", "code", "screening"}
_AFTER_KEY = (" = ", " is missing", " is not a known key")


@dataclass(frozen=True)
class Finding:
    """One error of a case, study or record.

    `line` and `column` count from 1; they are 0 where the value stands in no file, as that of a case
    made in Python. `key` is the way to it, as in ``building["A"].stick.masses``; it is empty where
    the message is of no key.
    """

    file: str
    line: int
    column: int
    message: str

    @property
    def key(self) -> str:
        found = _KEY.match(self.message)
        if found is None:
            return ""
        key = found[0]
        is_key = "." in key or "[" in key or key in _TABLES or self.message.startswith(_AFTER_KEY, found.end())
        return key if is_key else ""

    def __str__(self) -> str:
        place = self.file
        if self.line > 0:
            place += f":{self.line}:{self.column}"
        return f"{place}: error: {self.message}" if place else f"error: {self.message}"


class CaseError(ValueError):
    """A case, study or record that is not right. `errors` has all that was found, each with its place."""

    errors: list[Finding]

    def __init__(self, errors: Iterable[tuple[str, int, int, str]]) -> None:
        self.errors = [Finding(*one) for one in errors]
        super().__init__("\n".join(str(one) for one in self.errors))

    def __reduce__(self) -> tuple[type[CaseError], tuple[list[tuple[str, int, int, str]]]]:
        return type(self), ([(e.file, e.line, e.column, e.message) for e in self.errors],)


class SolveError(RuntimeError):
    """The numbers failed; the message says why and when."""


def missing(package: str, what: str) -> ImportError:
    """For what needs a package that is not there."""
    return ImportError(f"{what} needs {package}, which is not installed: pip install {package}")
