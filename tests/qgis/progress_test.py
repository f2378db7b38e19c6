# SPDX-License-Identifier: GPL-3.0-or-later
"""The bar and the lines of stderr are told apart, in whatever pieces they come."""

import pytest
from orograph_processing.progress import ProgressReader, percent_of

WHOLE = "0...10...20...30...40...50...60...70...80...90...100 - done.\norograph: x.svg: 12 strokes\n"


def read(pieces):
    percents, lines = [], []
    reader = ProgressReader(percents.append, lines.append)
    for piece in pieces:
        reader.take(piece)
    reader.end()
    return percents, lines


@pytest.mark.parametrize("bar, percent", [("0", 0), ("0.", 2.5), ("0...10", 10), ("0...10...20..", 25), ("", None),
                                          ("orograph: 7", None), ("10", None)])
def test_percents_of_bars(bar, percent):
    assert percent_of(bar) == percent


@pytest.mark.parametrize("size", [1, 2, 7, 1000])
def test_pieces_of_any_length(size):
    percents, lines = read(WHOLE[i:i + size] for i in range(0, len(WHOLE), size))
    assert percents == sorted(set(percents)) and percents[-1] == 100
    assert lines == ["orograph: x.svg: 12 strokes"]
    assert size > 2 or len(percents) > 20


def test_what_is_told_in_the_middle_of_the_bar():
    percents, lines = read(["0...10..", "orograph: a doubt\n - done.\n", "orograph: x.svg"])
    assert percents == [15] and lines == ["orograph: a doubt", "orograph: x.svg"]


def test_lines_before_the_bar():
    percents, lines = read(["orograph: the eye goes 3 m\n0...1", "0\n"])
    assert percents == [7.5, 10] and lines == ["orograph: the eye goes 3 m"]
