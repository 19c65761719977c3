"""Errors of input and of files."""

import re
from typing import NamedTuple, Optional


class Problem(NamedTuple):
    """One error of an input, taken apart."""

    file: Optional[str]  #: file or name of the scene
    line: Optional[int]  #: counted from 1; None for a scene that is no text
    field: Optional[str]  #: e.g. "body 'ball': mass"
    message: str  #: what was found and what is allowed


_place = re.compile(r"(?:(?P<file>[^:]+(?:\.\w+)?):(?:(?P<line>\d+):)? )?(?P<rest>.*)", re.DOTALL)
_field = re.compile(r"(?P<field>.+?): (?P<message>(?:found|it is|is not|not) .*)", re.DOTALL)


def _problem(text):
    place = _place.fullmatch(text)
    if not place["line"] and not _field.fullmatch(place["rest"]) and _field.fullmatch(text):
        place = re.fullmatch("(?P<file>)?(?P<line>)?(?P<rest>.*)", text, re.DOTALL)  # "end: found ..."
    field = _field.fullmatch(place["rest"])
    return Problem(
        file=place["file"] or None,
        line=int(place["line"]) if place["line"] else None,
        field=field["field"] if field else None,
        message=field["message"] if field else place["rest"],
    )


class InputError(ValueError):
    """Wrong input; `problems` lists all that were found, `file`, `line` and `field` are of the first."""

    def __init__(self, message):
        super().__init__(message)
        self.problems = [_problem(line) for line in message.split("\n")]

    @property
    def file(self):
        return self.problems[0].file

    @property
    def line(self):
        return self.problems[0].line

    @property
    def field(self):
        return self.problems[0].field


class IoError(OSError):
    """A file that cannot be read."""
