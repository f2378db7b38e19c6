# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command writes to stderr: lines for the reader, and a bar 0...10...20 that grows by marks."""

import re

_MARKS_TO_NUMBER = 4  # a number for every tenth, and three dots between
_BAR = re.compile(r"0[0-9.]*")
_LINE_BEHIND_BAR = re.compile(r"(0[0-9.]*)(orograph: .*)")  # something was told before the bar's end
_END_OF_BAR = " - done."


def percent_of(bar):
    """How far a bar has come, 0 to 100: 12.5 for `0...10.`; None where it isn't one."""
    if not _BAR.fullmatch(bar):
        return None
    whole = re.sub(r"\.[1-9]$", ".", bar)  # a number's second digit is still to come
    dots = len(whole) - len(whole.rstrip("."))
    return min(100.0, int(re.findall(r"[0-9]+", whole)[-1]) + dots * 10 / _MARKS_TO_NUMBER)


class ProgressReader:
    """Takes the stream in pieces of any length; tells percents that rise, and whole lines."""

    def __init__(self, tell_percent, tell_line):
        self._tell_percent = tell_percent
        self._tell_line = tell_line
        self._rest = ""
        self._percent = -1.0

    def take(self, text):
        *lines, self._rest = (self._rest + text).split("\n")
        for line in lines:
            self._take_line(line)
        self._show(percent_of(self._rest))

    def end(self):
        """The last line may have no end."""
        if self._rest:
            self._take_line(self._rest)
        self._rest = ""

    def _take_line(self, line):
        behind = _LINE_BEHIND_BAR.fullmatch(line)
        bar, line = behind.groups() if behind else (line, line)
        percent = percent_of(bar.removesuffix(_END_OF_BAR))
        self._show(percent)
        if percent is None or behind:
            if line != _END_OF_BAR:
                self._tell_line(line)

    def _show(self, percent):
        # A bar that has only the 10 of its 100 so far says less than before.
        if percent is not None and percent > self._percent:
            self._percent = percent
            self._tell_percent(percent)
