"""Errors of input and of files."""

import errno
import os
import re
from typing import NamedTuple, Optional


class Problem(NamedTuple):
    """One error of an input, taken apart as far as its message has these parts."""

    file: Optional[str]  #: file or name of the scene
    line: Optional[int]  #: counted from 1; None for a scene that is no text
    field: Optional[str]  #: e.g. "body 'ball': mass"
    message: str  #: what was found and what is allowed


_lines = re.compile(r"(?P<file>.+?):(?P<line>\d+): (?P<rest>.*)", re.DOTALL)
_key = r"[a-z_][\w.\[\]]*"
# A table, with its name or number if it has one, and a key; or one of both; or a path in quotes.
_field = re.compile(rf"(?P<field>(?:[a-z_]+ (?:'[^']*'|\d+)|{_key})(?:: {_key})?|'[^']*'): (?P<rest>.*)", re.DOTALL)
# An argument: "restitution is 1.6; it must be ...", "integrator 'rk44' is not known; ...".
_argument = re.compile(r"(?P<field>[a-z_]+) (?:is [-+\d.]|'[^']*' is not known)")


def _problem(text, scene):
    file = line = None
    if scene is not None and text.startswith(scene + ":"):
        file, text = scene, text[len(scene) + 1 :]
        number = re.match(r"(\d+): ", text)
        line = int(number[1]) if number else None
        text = text[number.end() :] if number else text.lstrip()
    elif place := _lines.fullmatch(text):
        file, line, text = place["file"], int(place["line"]), place["rest"]
    if field := _field.fullmatch(text):
        return Problem(file, line, field["field"], field["rest"])
    argument = _argument.match(text)
    return Problem(file, line, argument["field"] if argument else None, text)


def _problems(message, scene):
    """The problems of a message: a line each; a found text can have lines, too."""
    texts = []
    for text in message.split("\n"):
        if texts and scene is not None and not text.startswith(scene + ":"):
            texts[-1] += "\n" + text
        else:
            texts.append(text)
    return [_problem(text, scene) for text in texts]


class InputError(ValueError):
    """Wrong input; `problems` lists all that were found, `file`, `line` and `field` are of the first."""

    def __init__(self, message, scene=None):
        super().__init__(message, scene)
        self.problems = _problems(str(message), scene)

    def __str__(self):
        return str(self.args[0])

    @property
    def file(self):
        return self.problems[0].file

    @property
    def line(self):
        return self.problems[0].line

    @property
    def field(self):
        return self.problems[0].field


#: Numbers of the system's errors by the text that ends a message.
_numbers = {os.strerror(number): number for number in sorted(errno.errorcode, reverse=True)}


class IoError(OSError):
    """A file that cannot be read or written; `errno`, `strerror` and `filename` are None without a system's reason."""

    def __init__(self, message):
        super().__init__(message)
        places, _, reason = str(message).rpartition(": ")
        if reason in _numbers:
            self.errno, self.strerror, self.filename = _numbers[reason], reason, places.rpartition(": ")[2]

    def __str__(self):
        return str(self.args[0])


class FileNotFound(IoError, FileNotFoundError):
    """A file or folder that does not exist."""


class FileNotPermitted(IoError, PermissionError):
    """A file or folder that the user may not read or write."""


_classes = {errno.ENOENT: FileNotFound, errno.EACCES: FileNotPermitted, errno.EPERM: FileNotPermitted}


def io_error(message, scene=None):
    """The error of a message, which Python's own class for the system's reason catches, too."""
    return _classes.get(IoError(message).errno, IoError)(message)
