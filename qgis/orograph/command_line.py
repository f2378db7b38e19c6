# SPDX-License-Identifier: GPL-3.0-or-later
"""From parameters' values to the words of a command line."""


def _text_of(value):
    """Numbers as short as they are exact: 516000, 0.1."""
    if isinstance(value, float):
        return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)
    return str(value)


def _is_set(value):
    return value is not None and value is not False and value != "" and value != []


def words_of(parameters, values):
    """The words for what is set, in the order of parameters. `values` holds by name: True or False of
    switches, numbers, texts, paths, lists of words and of paths, (x, y) of points in the terrain's
    CRS, (xmin, ymin, xmax, ymax) of extents. What is None, empty or missing isn't set."""
    words = []
    for parameter in parameters:
        value = values.get(parameter.name)
        if parameter.kind == "height" or not _is_set(value):
            continue
        # One word, so that numbers below 0 aren't taken for options.
        if parameter.kind == "switch":
            words.append(parameter.option)
        elif parameter.kind == "vectors":
            words += [f"{parameter.option}={path}" for path in value]
        elif parameter.kind == "texts":
            words += [f"{parameter.option}={line.strip()}" for line in value.splitlines() if line.strip()]
        elif parameter.kind in ("point", "extent", "list"):
            parts = list(value)
            height = values.get(parameter.name + "_Z") if parameter.kind == "point" else None
            if height is not None:
                parts.append(height)
            words.append(f"{parameter.option}={','.join(_text_of(part) for part in parts)}")
        else:
            words.append(f"{parameter.option}={_text_of(value)}")
    return words
