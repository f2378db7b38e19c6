# SPDX-License-Identifier: GPL-3.0-or-later
"""Python's values as those of the command's options.

Nothing here knows an option: the command's own tables tell what each takes, and the command's own
parser reads the texts that come from here.
"""

import functools
import json
import numbers
import os

from orograph._orograph import in_python, usage
from orograph.errors import error


@functools.cache
def table(function):
    """The options of `render`, `read`, `visible` or `horizon` by name, as --json-usage tells them."""
    return {option["name"]: option for option in json.loads(usage(function))["input_arguments"]}


def named_values(function, given):
    """Pairs of an option's name and its values as texts, from keyword arguments.

    What is None is as if it weren't given. What there is no option for goes along, for the
    command to suggest what may have been meant.
    """
    options = table(function)
    pairs = []
    for key, value in given.items():
        name = key.replace("_", "-")
        if value is None:
            continue
        if name not in options:
            _refuse_misplaced(function, key, name)
            pairs.append((name, [str(value)]))
            continue
        texts = _texts(options[name], key, value)
        if texts is not None:
            pairs.append((name, texts))
    return pairs


def describe(function):
    """A line for each option, for a docstring."""
    lines = []
    group = None
    for option in table(function).values():
        if option["group"] != group:
            group = option["group"]
            lines += ["", group + ":"]
        default = option.get("default", option.get("default_text"))
        details = [option.get("allowed"), default and f"default {default}"]
        details = "; ".join(detail for detail in details if detail)
        takes = f" = {option['metavar']}" if "metavar" in option else ""
        told = in_python(option["description"])
        lines.append(f"    {option['name'].replace('-', '_')}{takes}")
        lines += _wrapped(told + (f" ({in_python(details)})." if details else "."))
    return "\n".join(lines) + "\n"


def _wrapped(text):
    # Faster than textwrap, which would be a tenth of what importing takes.
    indent = " " * 8
    lines = [indent]
    for word in text.split():
        if len(lines[-1]) + len(word) > 98:
            lines.append(indent)
        lines[-1] += word + " "
    return [line.rstrip() for line in lines]


def _refuse_misplaced(function, key, name):
    if function != "read" and name in table("read"):
        raise error(f"{key} is an option of reading a terrain", "give it to orograph.read")
    if function == "read" and name in table("render"):
        raise error(f"{key} is an option of drawing", "give it to render")


def _texts(option, key, value):
    if option["type"] == "boolean":
        if not isinstance(value, bool):
            raise _unsuitable(option, key, value)
        return [] if value else None
    if option.get("repeatable"):
        several = value if isinstance(value, (list, tuple)) else [value]
        return [_text(option, key, one) for one in several] or None
    return [_text(option, key, value)]


def _text(option, key, value):
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, bool):  # which is a number, too
        if not value and "off" in [*option.get("words", []), *option.get("choices", [])]:
            return "off"
        raise _unsuitable(option, key, value)
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, dict):
        return ",".join(f"{name}={_text(option, key, one)}" for name, one in value.items())
    try:
        parts = list(value)
    except TypeError:
        raise _unsuitable(option, key, value) from None
    return option.get("between", ",").join(_text(option, key, part) for part in parts)


def _unsuitable(option, key, value):
    if option["type"] == "boolean":
        right = "give True or False"
    else:
        allowed = option.get("allowed")
        right = f"give {option.get('metavar', '')}" + (f", {allowed}" if allowed else "")
    return error(f"{key} {value!r} can't be used", in_python(right))

