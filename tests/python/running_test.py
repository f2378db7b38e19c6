# SPDX-License-Identifier: GPL-3.0-or-later
"""While it draws: progress, Ctrl-C, threads; and what importing costs and needs."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import orograph
import pytest
from conftest import CRS, TRANSFORM, hills

# Some half a second of one core.
LONG = {"profiles": 1500, "jobs": 1, "simplify": 0}


@pytest.fixture(scope="module")
def large():
    return orograph.terrain(hills(700, 700), TRANSFORM, CRS).session()


def test_progress_rises_to_1_on_the_callers_thread(large):
    told, threads = [], set()

    def progress(share):
        told.append(share)
        threads.add(threading.get_ident())

    large.render(progress=progress, **LONG)
    assert len(told) > 3
    assert told == sorted(told) and told[-1] == 1 and told[0] > 0
    assert threads == {threading.get_ident()}


def test_what_a_callback_raises_comes_through(large, ground):
    wanted = ground.render().to_svg()

    class Enough(Exception):
        pass

    def progress(share):
        raise Enough(share)

    for options in ({}, LONG):
        with pytest.raises(Enough):
            large.render(progress=progress, **options)
    assert ground.render().to_svg() == wanted
    assert large.render(page="a6").to_svg() == large.render(page="a6").to_svg()


def test_ctrl_c_in_the_middle(large, ctrl_c):
    pressed = []

    def press():
        pressed.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.3, press)
    timer.start()
    deadline = time.monotonic() + 20
    with pytest.raises(KeyboardInterrupt):
        while time.monotonic() < deadline:
            large.render(**LONG)
    waited = time.monotonic() - pressed[0]
    timer.join()
    # A tenth of a second, and what busy machines take to wake a thread.
    assert waited < 0.1 + 0.2
    assert large.render(page="a6").to_svg() == large.render(page="a6").to_svg()


def test_other_threads_go_on_meanwhile(large):
    counted = [0]
    done = threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.005)

    thread = threading.Thread(target=count)
    thread.start()
    begin = time.monotonic()
    large.render(**LONG)
    seconds = time.monotonic() - begin
    done.set()
    thread.join()
    assert counted[0] > 20 * seconds  # of 200 a second


def test_two_threads_at_once(ground):
    session = ground.session()
    wanted = [ground.render(view_from=(azimuth, 25)).to_svg() for azimuth in range(0, 360, 60)]
    got = [[None] * 6, [None] * 6]

    def draw(mine):
        for i in range(6):
            mine[i] = session.render(view_from=(60 * i, 25)).to_svg()

    threads = [threading.Thread(target=draw, args=(mine,)) for mine in got]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert got == [wanted, wanted]


def test_many_renders_leave_nothing(ground):
    session = ground.session()

    def pages():
        with open("/proc/self/statm") as statm:
            return int(statm.read().split()[1])

    def some(count):
        for i in range(count):
            drawing = session.render(view_from=(i, 20), page="a6", jobs=1)
            drawing.attributes, drawing.coords, drawing.report, drawing.to_svg()
            with pytest.raises(orograph.Error):
                session.render(fov=-1)

    some(20)
    before = pages()
    some(40)
    # 40 drawings are 12 MB; what an allocator keeps for itself is less.
    assert (pages() - before) * os.sysconf("SC_PAGE_SIZE") < 5e6


def run_python(code):
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)


def test_importing_takes_little():
    code = (
        "import numpy, time; begin = time.process_time(); import orograph; "
        "print(time.process_time() - begin)"
    )
    assert min(float(run_python(code).stdout) for _ in range(3)) < 0.5


def test_numpy_alone_is_needed(tmp_path):
    code = f"""
import sys
class Refuse:
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in ("matplotlib", "geopandas", "shapely", "pandas", "rasterio", "xarray", "affine"):
            raise ImportError(name)
sys.meta_path.insert(0, Refuse())
import numpy, orograph
z = numpy.add.outer(numpy.arange(20.0) ** 2, numpy.arange(30.0))
drawing = orograph.terrain(z, (0, 10, 0, 0, 0, -10)).render(contours="20m")
drawing.save({str(tmp_path / 'x.svg')!r})
print(len(drawing.coords) == drawing.offsets[-1], sorted(drawing.attributes), drawing.layers.keys())
try:
    drawing.plot()
except ImportError as error:
    print(error)
"""
    run = run_python(code)
    assert run.stderr == ""
    assert run.stdout.startswith("True") and run.stdout.endswith("matplotlib\n")
    assert (tmp_path / "x.svg").exists()


def test_an_interpreter_that_ends_with_terrains_alive():
    run = run_python(
        "import numpy, orograph, threading\n"
        "z = numpy.add.outer(numpy.arange(20.0), numpy.arange(30.0) ** 2)\n"
        "kept = orograph.terrain(z, (0, 10, 0, 0, 0, -10)).session()\n"
        "drawing = kept.render()\n"
        "import sys; sys.modules['kept'] = kept\n"
    )
    assert (run.returncode, run.stderr) == (0, "")
