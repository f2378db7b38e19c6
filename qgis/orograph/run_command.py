# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the command: finds it, follows its progress, ends it when that is asked for."""

import codecs
import os
import shutil
import subprocess
import threading

from .progress import ProgressReader

# Between looks at the cancel button, and until a process that was asked to end is killed: the command
# removes its unfinished file in a few milliseconds.
_LOOK_S = 0.1
_GRACE_S = 2.0

_NAME = "orograph"
_PREFIX = _NAME + ": "
_ERROR = _PREFIX + "error: "

# Programs that QGIS starts from a desktop don't have the shell's PATH.
_USUAL_FOLDERS = ("/usr/bin", "/usr/local/bin", "~/.local/bin")

# A console window would open for each run on Windows.
_FLAGS = {"creationflags": getattr(subprocess, "CREATE_NO_WINDOW", 0)}


class CommandFailed(Exception):
    """With one line that says what is wrong and what would be right."""


class Cancelled(Exception):
    pass


def find_program(asked=""):
    """The command's path: the one that is asked for, or that of PATH and the usual folders."""
    if asked:
        found = shutil.which(os.path.expanduser(asked))
        if not found:
            raise CommandFailed(f"{asked} is no program that can be run: give the path of orograph")
        return found
    folders = [os.path.expanduser(folder) for folder in _USUAL_FOLDERS]
    found = shutil.which(_NAME) or shutil.which(_NAME, path=os.pathsep.join(folders))
    if not found:
        raise CommandFailed("orograph isn't installed where programs are looked for: install it, or give its path"
                            " in Settings, Options, Processing, Providers, Orograph")
    return found


def _start(words, **how):
    try:
        return subprocess.Popen(words, stdin=subprocess.DEVNULL, **how, **_FLAGS)
    except OSError as error:
        raise CommandFailed(f"{words[0]} can't be run ({error.strerror}): give the path of orograph") from None


def _failure(lines, code):
    """The error line without the command's name, or what is known without one."""
    for line in reversed(lines):
        if line.startswith(_ERROR):
            return CommandFailed(line[len(_ERROR):])
    how = f"signal {-code}" if code < 0 else f"code {code}"
    return CommandFailed(f"orograph ended with {how}" + (f": {lines[-1]}" if lines else " and said nothing"))


def answer_of(words):
    """What a run prints, within ten seconds: for questions that no terrain is read for."""
    process = _start(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", errors="replace")
    try:
        printed, said = process.communicate(timeout=10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        raise CommandFailed(f"{words[0]} doesn't answer: give the path of orograph") from None
    if process.returncode != 0:
        raise _failure(said.splitlines(), process.returncode)
    return printed


def _end(process):
    process.terminate()
    try:
        process.wait(_GRACE_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def run(words, tell_percent, tell_line, is_cancelled):
    """Runs the words of a command line to their end, and tells what they say, on this thread.

    Raises CommandFailed with the error line, and Cancelled soon after is_cancelled() answers True; then
    the process has ended."""
    process = _start(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    heard = []
    gate = threading.Condition()

    def hear():
        while True:
            piece = process.stderr.read1(65536)
            with gate:
                heard.append(piece)
                gate.notify()
            if not piece:
                return

    listener = threading.Thread(target=hear, daemon=True)
    listener.start()
    lines = []

    def take_line(line):
        lines.append(line)
        if not line.startswith(_ERROR):
            tell_line(line[len(_PREFIX):] if line.startswith(_PREFIX) else line)

    reader = ProgressReader(tell_percent, take_line)
    decoder = codecs.getincrementaldecoder("utf-8")("replace")
    try:
        ended = False
        while not ended:
            with gate:
                if not heard:
                    gate.wait(_LOOK_S)
                pieces, heard[:] = heard[:], []
            for piece in pieces:
                reader.take(decoder.decode(piece))
                ended = ended or not piece
            if is_cancelled():
                raise Cancelled
        reader.end()
        code = process.wait()
    finally:
        if process.poll() is None:
            _end(process)
        listener.join()
        process.stderr.close()
    if code != 0:
        raise _failure(lines, code)
