# SPDX-License-Identifier: GPL-3.0-or-later
"""The command is found, its errors are one line, and it ends when asked to."""

import os
import subprocess
import time

import pytest
from conftest import DATA, PROGRAM
from orograph_processing.run_command import Cancelled, CommandFailed, answer_of, find_program, run
from orograph_processing.usage import ask_usage, usage_of


def script(folder, text):
    path = folder / "program"
    path.write_text("#!/bin/sh\n" + text)
    path.chmod(0o755)
    return str(path)


def run_it(words, is_cancelled=lambda: False):
    percents, lines = [], []
    run(words, percents.append, lines.append, is_cancelled)
    return percents, lines


def test_progress_and_lines_of_a_real_run(tmp_path):
    out = tmp_path / "cone.svg"
    percents, lines = run_it([PROGRAM, "render", str(DATA / "cone.tif"), str(out), "--progress"])
    assert out.stat().st_size > 1000
    assert percents[-1] == 100
    assert len(lines) == 1 and lines[0].startswith(str(out)) and "strokes" in lines[0]


def test_the_bar_is_a_line_of_its_own(tmp_path):
    run_of = subprocess.run([PROGRAM, "render", DATA / "cone.tif", tmp_path / "x.svg", "--progress", "--check=100"],
                            capture_output=True, text=True, check=True)
    bar, check, closing = run_of.stderr.splitlines()
    assert bar.startswith("0...10...") and bar.endswith("100 - done.")
    assert check.startswith("orograph: check: ") and "strokes" in closing


def test_an_error_is_the_commands_own_line(tmp_path):
    with pytest.raises(CommandFailed) as failure:
        run_it([PROGRAM, "render", str(tmp_path / "no.tif"), str(tmp_path / "x.svg"), "--progress"])
    assert "no.tif" in str(failure.value)
    assert "\n" not in str(failure.value) and not str(failure.value).startswith("orograph")


def test_a_crash_is_told(tmp_path):
    with pytest.raises(CommandFailed, match="signal 9: half a word"):
        run_it([script(tmp_path, "printf 'half a word' >&2; kill -9 $$\n")])


@pytest.mark.parametrize("trap", ["", "trap '' TERM\n"])
def test_cancelling_ends_the_process(tmp_path, monkeypatch, trap):
    monkeypatch.setattr("orograph_processing.run_command._GRACE_S", 0.3)
    # The pid stays the same behind exec, and so does what is ignored.
    program = script(tmp_path, trap + f"echo $$ >{tmp_path}/pid\nprintf 0... >&2\nexec sleep 60\n")
    begin = time.monotonic()
    with pytest.raises(Cancelled):
        run_it([program], lambda: (tmp_path / "pid").exists() and (tmp_path / "pid").read_text() != "")
    assert time.monotonic() - begin < 5
    with pytest.raises(ProcessLookupError):
        os.kill(int((tmp_path / "pid").read_text()), 0)


def test_an_exception_of_the_listener_ends_the_process_too(tmp_path):
    program = script(tmp_path, f"echo $$ >{tmp_path}/pid\necho orograph: a line >&2\nexec sleep 60\n")

    def fail(line):
        raise KeyError(line)

    with pytest.raises(KeyError):
        run([program], lambda percent: None, fail, lambda: False)
    with pytest.raises(ProcessLookupError):
        os.kill(int((tmp_path / "pid").read_text()), 0)


def test_where_the_program_is(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("orograph_processing.run_command._USUAL_FOLDERS", ())
    with pytest.raises(CommandFailed, match="isn't installed"):
        find_program()
    with pytest.raises(CommandFailed, match="no program"):
        find_program(str(tmp_path / "orograph"))
    program = script(tmp_path, "exit 0\n")
    os.rename(program, tmp_path / "orograph")
    assert find_program() == find_program(str(tmp_path / "orograph")) == str(tmp_path / "orograph")


def test_a_program_that_is_another_or_too_old(tmp_path):
    with pytest.raises(CommandFailed, match="can't be read"):
        ask_usage(script(tmp_path, "echo hello\n"), "render")
    with pytest.raises(CommandFailed, match="unknown option --json-usage"):
        ask_usage(script(tmp_path, "echo 'orograph: error: unknown option --json-usage' >&2; exit 1\n"), "render")
    with pytest.raises(CommandFailed, match="can't be run"):
        answer_of([str(tmp_path / "nothing")])
    with pytest.raises(CommandFailed):
        usage_of('{"name": "render"}')
