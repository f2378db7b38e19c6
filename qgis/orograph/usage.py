# SPDX-License-Identifier: GPL-3.0-or-later
"""A command's options, as `orograph COMMAND --json-usage` tells them."""

import json
from dataclasses import dataclass
from typing import Optional

from .run_command import CommandFailed, answer_of


@dataclass(frozen=True)
class Argument:
    """An option by its name without dashes, or what stands without one (`INPUT`)."""

    name: str
    type: str  # boolean, integer, real or string
    description: str
    metavar: str = ""
    allowed: str = ""
    default: str = ""  # a value or a sentence
    choices: tuple = ()  # no other words are taken
    extensions: tuple = ()  # of the file that it names
    is_list: bool = False  # of choices, with commas between
    is_repeatable: bool = False
    is_positional: bool = False
    least: Optional[float] = None
    greatest: Optional[float] = None
    unit: str = ""


@dataclass(frozen=True)
class Usage:
    command: str
    description: str
    arguments: dict  # name to Argument, in the command's order

    @property
    def options(self):
        return [a for a in self.arguments.values() if not a.is_positional]


def _argument_of(told):
    return Argument(
        name=told["name"],
        type=told["type"],
        description=told["description"],
        metavar=told.get("metavar", ""),
        allowed=told.get("allowed", ""),
        default=told.get("default", told.get("default_text", "")),
        choices=tuple(told.get("choices", ())),
        extensions=tuple(told.get("extensions", ())),
        is_list=told.get("list", False),
        is_repeatable=told.get("repeatable", False),
        is_positional=told.get("positional", False),
        least=told.get("min_value"),
        greatest=told.get("max_value"),
        unit=told.get("unit", ""),
    )


def usage_of(text):
    """The usage in a text of JSON. Raises CommandFailed where it isn't one."""
    try:
        told = json.loads(text)
        arguments = [_argument_of(argument) for argument in told["input_arguments"]]
        return Usage(told["name"], told["description"], {a.name: a for a in arguments})
    except (ValueError, KeyError, TypeError) as error:
        raise CommandFailed(f"the options of orograph can't be read ({error}): install a newer one") from None


def ask_usage(program, command):
    """Asks the program, which takes some 50 ms."""
    return usage_of(answer_of([program, command, "--json-usage"]))
