# SPDX-License-Identifier: GPL-3.0-or-later
"""A drawing's arrays, its ways out, and what wrong options are told."""

import inspect
import json
import re

import numpy as np
import orograph
import pytest
from conftest import DATA


@pytest.fixture(scope="module")
def drawn(ground):
    return ground.render(contours="20m", of="geojson", title="made")


def test_arrays_fit_each_other(drawn):
    points, strokes = len(drawn.coords), len(drawn.offsets) - 1
    assert drawn.coords.shape == (points, 2) and drawn.coords.dtype == np.float64
    assert drawn.ground.shape == (points, 3) and drawn.ground.dtype == np.float64
    assert drawn.offsets.dtype == np.int64
    assert drawn.offsets[0] == 0 and drawn.offsets[-1] == points
    assert (np.diff(drawn.offsets) >= 2).all()
    width, height = drawn.page
    assert (drawn.coords >= 0).all() and (drawn.coords <= [width, height]).all()
    for name, values in drawn.attributes.items():
        assert len(values) == strokes, name
    for name, layer in drawn.layers.items():
        assert set(drawn.attributes["layer"][layer.strokes]) <= {name}
    assert sum(s.strokes.stop - s.strokes.start for s in drawn.layers.values()) == strokes


def test_they_are_what_geojson_holds(drawn, tmp_path):
    drawn.save(tmp_path / "x.geojson")
    features = json.loads((tmp_path / "x.geojson").read_text())["features"]
    assert len(features) == len(drawn.offsets) - 1
    for i in (0, len(features) // 2, len(features) - 1):
        properties = features[i]["properties"]
        assert properties["layer"] == drawn.attributes["layer"][i]
        assert properties["profile"] == drawn.attributes["profile"][i]
        assert len(features[i]["geometry"]["coordinates"]) == np.diff(drawn.offsets)[i]
        height = features[i]["geometry"]["coordinates"][0][2]
        assert height == pytest.approx(drawn.ground[drawn.offsets[i], 2], abs=1e-3)
    elevations = [f["properties"].get("elevation") for f in features]
    told = [None if np.isnan(e) else e for e in drawn.attributes["elevation"]]
    assert told == elevations
    assert len(set(told)) > 5


def test_contours_lie_at_their_height(drawn):
    elevation = drawn.attributes["elevation"]
    for i in np.flatnonzero(~np.isnan(elevation)):
        heights = drawn.ground[drawn.offsets[i] : drawn.offsets[i + 1], 2]
        assert np.allclose(heights, elevation[i], atol=1e-6)


def test_paper_has_no_ground(ground):
    with pytest.raises(orograph.Error, match='of="geojson"'):
        ground.render().ground


def test_saving(ground, tmp_path):
    drawing = ground.render()
    drawing.save(tmp_path / "map.svg")
    assert (tmp_path / "map.svg").read_text() == drawing.to_svg()
    with pytest.raises(orograph.Error, match="overwrite"):
        drawing.save(tmp_path / "map.svg")
    drawing.save(str(tmp_path / "map.svg"), overwrite=True)
    with pytest.raises(orograph.Error):
        drawing.save(tmp_path / "no" / "map.svg")
    assert drawing.save(tmp_path / "odd.name") is None
    assert (tmp_path / "odd.name").read_text() == drawing.to_svg()
    copy = tmp_path / "dem.tif"
    copy.write_bytes((DATA / "volcano.tif").read_bytes())
    with pytest.raises(orograph.Error, match="is the input"):
        orograph.read(copy).render().save(copy, overwrite=True)


def error_of(call, *arguments, **options):
    with pytest.raises(orograph.Error) as caught:
        call(*arguments, **options)
    error = caught.value
    assert str(error) == f"{error.wrong}: {error.right}"
    assert "--" not in str(error) and "`" not in str(error) and "\n" not in str(error)
    return str(error)


@pytest.mark.parametrize(
    "options, told",
    [
        ({"spacng": 1}, "unknown option spacng: did you mean spacing?"),
        ({"contour_tick": True}, "did you mean contour_ticks?"),
        ({"azimuth": 3}, "view_from"),
        ({"spacing": 3}, "0.6mm on the page"),
        ({"fov": 400}, "above 0 and at most 360"),
        ({"fov": float("nan")}, "fov 'nan' can't be used"),
        ({"fov": [1, 2]}, "fov '1,2' can't be used"),
        ({"fov": True}, "fov True can't be used"),
        ({"fov": object}, "can't be used"),
        ({"crop": "yes"}, "give True or False"),
        ({"profiles": 2.5}, "a whole number"),
        ({"view_from": (1, 2, 3)}, "view_from '1/2/3'"),
        ({"layers": ["a"]}, "each once of profiles"),
        ({"light": False, "haze": 0.5}, "haze has no meaning without light"),
        ({"eye": (500100, 5199000), "view_from": (1, 2)}, "exclude each other"),
        ({"eye": (0, 0)}, "outside of the terrain"),
        ({"device": "hp7475a"}, "device has no meaning in svg"),
        ({"of": "xyz"}, "unknown format 'xyz'"),
        ({"bbox": (1, 2, 3, 4)}, "give it to orograph.read"),
        ({"report": "x.json"}, "report"),
        ({"quiet": True}, "quiet"),
        ({"settings": "no.toml"}, "no.toml"),
        ({"scene": "no.toml"}, "no.toml"),
    ],
)
def test_wrong_options(ground, options, told):
    assert told in error_of(ground.render, **options)


def test_wrong_files():
    assert "no such file" in error_of(orograph.read, "no.tif")
    assert "a scene, not a terrain" in error_of(orograph.read, DATA / "scenes/village.toml")
    assert "holds nothing" in error_of(orograph.read, DATA / "volcano.tif", bbox=(0, 0, 1, 1))
    assert "give it to render" in error_of(orograph.read, DATA / "volcano.tif", fov=3)
    assert "no file is named" in error_of(orograph.read, [])


def test_none_is_the_default(ground):
    assert ground.render(fov=None, crop=False).to_svg() == ground.render().to_svg()


def test_every_option_is_in_the_docstring_and_in_the_stubs():
    from orograph.options import table

    stub = (DATA.parent / "python/orograph/terrain.pyi").read_text()
    for function, where, of in (
        ("render", orograph.Terrain.render, "RenderOptions"),
        ("read", orograph.read, "ReadOptions"),
    ):
        text = inspect.getdoc(where)
        typed = set(re.findall(r"^    (\w+):", stub.split(f"class {of}(")[1].split("\nclass ")[0].split("\ndef ")[0], re.M))
        names = {name.replace("-", "_") for name in table(function)}
        assert len(names) > 10
        assert names <= set(re.findall(r"^ +(\w+)(?: = .*)?$", text, re.M))
        assert typed == names


def test_stubs_have_what_there_is():
    folder = DATA.parent / "python/orograph"
    for module, names in (("terrain", ["Terrain", "Session"]), ("drawing", ["Drawing"])):
        stub = (folder / f"{module}.pyi").read_text()
        for name in names:
            of = stub.split(f"class {name}")[1].split("\nclass ")[0]
            there = {n for n in vars(getattr(orograph, name)) if not n.startswith("_")}
            assert there == {n for n in re.findall(r"(?:def (\w+)|^    (\w+):)", of, re.M) for n in n if n and not n.startswith("_")}


def test_matplotlib(ground):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    drawing = ground.render()
    ax = drawing.plot()
    assert tuple(ax.figure.get_size_inches() * 25.4) == pytest.approx(drawing.page)
    lines = ax.collections[0]
    assert len(lines.get_segments()) == len(drawing.offsets) - 1
    widths = drawing.attributes["width_mm"] * 72 / 25.4
    assert np.allclose(lines.get_linewidths(), widths, rtol=1e-6)
    small = drawing.plot(plt.figure(figsize=(3, 3)).add_subplot())
    assert small.collections[0].get_linewidths()[0] < 0.5 * lines.get_linewidths()[0]
    profiles = drawing.layers["profiles"]
    depth = drawing.attributes["depth"][profiles.strokes]
    coloured = drawing.line_collection("profiles", array=depth, cmap="viridis", linewidths=0.2)
    assert len(coloured.get_segments()) == len(depth)
    with pytest.raises(orograph.Error, match="no layer 'rivers'"):
        drawing.line_collection("rivers")
    plt.close("all")


def test_geopandas(ground):
    pytest.importorskip("geopandas")
    drawing = ground.render(contours="20m")
    frame = drawing.to_geopandas()
    assert frame.crs.to_epsg() == 32632
    tied = ground.render(contours="20m", of="geojson")
    assert len(frame) == len(tied.offsets) - 1
    assert set(frame.columns) == {*tied.attributes, "geometry"}
    for i in (0, len(frame) - 1):
        points = tied.ground[tied.offsets[i] : tied.offsets[i + 1]]
        assert np.array_equal(np.array(frame.geometry[i].coords), points)
