# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights in arrays: the same drawing as of files, nothing copied that needn't be, clear errors."""

import gc
import weakref

import numpy as np
import orograph
import pytest
from conftest import CRS, DATA, TRANSFORM, hills, run_command

AFFINE_ORDER = (25.0, 0.0, 500000.0, 0.0, -25.0, 5200000.0)
OPTIONS = {"view_from": (200, 30), "title": "The same", "page": "a6"}


def svg(*terrain, **more):
    return orograph.terrain(*terrain, **more).render(**OPTIONS).to_svg()


def write_ascii_grid(path, z):
    rows, columns = z.shape
    x, size, _, y, _, _ = TRANSFORM
    head = f"ncols {columns}\nnrows {rows}\nxllcorner {x}\nyllcorner {y - rows * size}\ncellsize {size}\n"
    lines = [" ".join("-9999" if np.isnan(h) else f"{h:.9g}" for h in row) for row in z]
    path.write_text(head + "NODATA_value -9999\n" + "\n".join(lines) + "\n")


def test_arrays_and_files_of_the_same_heights(tmp_path):
    z = hills()
    z[20:26, 30:37] = np.nan
    write_ascii_grid(tmp_path / "z.asc", z)
    read = orograph.read(tmp_path / "z.asc").render(**OPTIONS)
    made = orograph.terrain(z, TRANSFORM).render(**OPTIONS)
    assert made.to_svg() == read.to_svg()
    tied = [drawn.render(of="geojson") for drawn in (orograph.read(tmp_path / "z.asc"), orograph.terrain(z, TRANSFORM))]
    assert np.array_equal(tied[0].coords, tied[1].coords)
    assert np.array_equal(tied[0].ground, tied[1].ground)


@pytest.mark.parametrize(
    "other",
    [
        lambda z: z.astype(np.float64),
        lambda z: z.astype(">f4"),
        lambda z: z.astype(">f8"),
        lambda z: np.asfortranarray(z),
        lambda z: np.kron(z, np.ones((2, 2), np.float32))[::2, ::2],
        lambda z: z[::-1].copy()[::-1],
        lambda z: np.ma.masked_array(z, np.zeros(z.shape, bool)),
        lambda z: np.frombuffer(b"x" + z.tobytes(), np.float32, offset=1).reshape(z.shape),
        lambda z: z.tolist(),
    ],
    ids=["float64", "big-endian", "big-endian doubles", "fortran", "strided", "reversed", "masked", "unaligned", "lists"],
)
def test_arrays_laid_out_otherwise_draw_the_same(other):
    z = np.round(hills() * 8) / 8
    assert svg(other(z), TRANSFORM, CRS) == svg(z, TRANSFORM, CRS)


@pytest.mark.parametrize("dtype", [np.int16, np.uint16, np.int32, np.uint64, np.float16, np.longdouble])
def test_numbers_of_other_kinds(dtype):
    z = np.round(hills())
    assert svg(z.astype(dtype), TRANSFORM, CRS) == svg(z, TRANSFORM, CRS)


def test_what_isnt_a_height():
    z = hills()
    z[5, 6], z[30, 40:44] = np.nan, np.nan
    wanted = svg(z, TRANSFORM, CRS)
    assert svg(np.where(np.isnan(z), -9999, z).astype(np.float32), TRANSFORM, CRS, nodata=-9999) == wanted
    assert svg(np.where(np.isnan(z), np.inf, z).astype(np.float32), TRANSFORM, CRS) == wanted
    assert svg(np.ma.masked_invalid(z), TRANSFORM, CRS) == wanted
    whole = np.round(z)
    ints = np.where(np.isnan(z), -32768, whole).astype(np.int16)
    assert svg(ints, TRANSFORM, CRS, nodata=-32768) == svg(whole, TRANSFORM, CRS)


def test_transforms_and_crs_in_every_way():
    z = hills()
    wanted = svg(z, TRANSFORM, CRS)

    class Affine:
        a, b, c, d, e, f = AFFINE_ORDER

    class Crs:
        def to_wkt(self):
            return "EPSG:32632"

    assert svg(z, Affine(), CRS) == wanted
    assert svg(z, np.array(TRANSFORM), 32632) == wanted
    assert svg(z, (*AFFINE_ORDER, 0, 0, 1), Crs()) == wanted
    # The first row in the south, and columns from east to west.
    assert svg(z[::-1], (500000, 25, 0, 5200000 - 60 * 25, 0, 25), CRS) == wanted
    assert svg(z[:, ::-1], (500000 + 80 * 25, -25, 0, 5200000, 0, -25), CRS) == wanted
    feet = svg((z.astype(np.float64) / 0.3048), TRANSFORM, CRS, height_unit="ft")
    assert len(feet) == pytest.approx(len(wanted), rel=0.01)


def test_heights_are_borrowed_and_kept_alive():
    for dtype in (np.float32, np.float64):
        z = hills(dtype=dtype)
        alive = weakref.ref(z)
        terrain = orograph.terrain(z, TRANSFORM, CRS)
        session = terrain.session()
        drawing = session.render(**OPTIONS)
        del z, terrain
        gc.collect()
        assert alive() is not None
        assert session.render(**OPTIONS).to_svg() == drawing.to_svg()
        del session, drawing
        gc.collect()
        assert alive() is None


@pytest.mark.parametrize("more", [{"nodata": 300}, {"height_unit": "ft"}, {}], ids=["nodata", "feet", "strided"])
def test_what_must_be_copied_isnt_kept(more):
    z = hills() if more else hills(120)[::2]
    alive = weakref.ref(z)
    terrain = orograph.terrain(z, TRANSFORM, CRS, **more)
    drawing = terrain.render(**OPTIONS).to_svg()
    z += 1000  # which the terrain knows nothing of
    assert terrain.render(**OPTIONS).to_svg() == drawing
    del z
    gc.collect()
    assert alive() is None


def refused(*arguments, **more):
    with pytest.raises(orograph.Error) as caught:
        orograph.terrain(*arguments, **more)
    error = caught.value
    assert isinstance(error, ValueError)
    assert str(error) == f"{error.wrong}: {error.right}"
    assert "\n" not in str(error)
    return error


@pytest.mark.parametrize(
    "z, wrong",
    [
        (np.zeros(9), "1 dimensions, 9"),
        (np.zeros((2, 3, 4)), "3 dimensions, 2 x 3 x 4"),
        (7.0, "0 dimensions"),
        (np.zeros((1, 5)), "5 columns and 1 rows"),
        (np.zeros((0, 5)), "5 columns and 0 rows"),
        (np.zeros((3, 3), complex), "complex128"),
        (np.zeros((3, 3), bool), "bool"),
        (np.full((3, 3), "high"), "<U4"),
        (np.full((3, 3), None), "object"),
        (np.full((3, 3), np.nan), "no heights"),
        (np.full((3, 3), np.inf), "no heights"),
        (np.ma.masked_all((3, 3)), "no heights"),
    ],
)
def test_what_are_no_heights(z, wrong):
    assert wrong in refused(z, TRANSFORM).wrong


@pytest.mark.parametrize(
    "transform, wrong",
    [
        (None, "no transform"),
        (5, "isn't six numbers"),
        ("north", "isn't six numbers"),
        ((1, 2, 3), "has 3 numbers"),
        (AFFINE_ORDER, "order of an Affine"),
        ((0, 25, 0, 0, 0, 0), "along one line"),
        ((0, np.nan, 0, 0, 0, -25), "isn't finite"),
    ],
)
def test_what_is_no_transform(transform, wrong):
    error = refused(hills(), transform)
    assert wrong in error.wrong and "give" in error.right


@pytest.mark.parametrize("crs", ["nonsense", "EPSG:1", 3.5, b"EPSG:32632", True])
def test_what_is_no_crs(crs):
    error = refused(hills(), TRANSFORM, crs)
    assert "EPSG:32632" in error.right


def test_other_wrong_arguments():
    assert "cubits" in refused(hills(), TRANSFORM, height_unit="cubits").wrong
    assert "latitude" in str(refused(hills(), TRANSFORM, "EPSG:4326"))


def test_triangles():
    vertices = [[0, 0, 10], [100, 0, 20], [0, 100, 30], [100, 100, 60]]
    terrain = orograph.tin(vertices, [[0, 1, 2], [1, 3, 2]], crs=CRS)
    drawing = terrain.render(layers=["edges", "border"], flat="draw", page="a6")
    assert len(drawing.offsets) > 3
    for triangles, wrong in (([[0, 1, 4]], "vertex 4"), ([[0, 1, -1]], "vertex -1"), ([[0, 1]], "1 x 2"), ([[0.0, 1, 2]], "float64")):
        with pytest.raises(orograph.Error, match=wrong):
            orograph.tin(vertices, triangles)


class Dataset:
    """What rasterio's datasets have of it."""

    transform, crs, nodata, scales, offsets = None, "EPSG:32632", -1.0, (1.0,), (0.0,)

    def __init__(self, z):
        self.z = z

        class Affine:
            a, b, c, d, e, f = AFFINE_ORDER

        self.transform = Affine()

    def read(self, band):
        assert band == 1
        return self.z


def test_datasets_tell_their_place_themselves():
    z = hills()
    z[8, 9] = -1
    wanted = svg(z, TRANSFORM, CRS, -1)
    assert svg(Dataset(z)) == wanted
    scaled = Dataset(np.where(z == -1, -1, z / 2).astype(np.float64))
    scaled.scales, scaled.offsets = (2.0,), (0.0,)
    assert svg(scaled) == svg(z.astype(np.float64), TRANSFORM, CRS, -1)


def test_xarray():
    xarray = pytest.importorskip("xarray")
    z = hills()
    x, size, _, y, _, _ = TRANSFORM
    coords = {"y": y - size * (np.arange(60) + 0.5), "x": x + size * (np.arange(80) + 0.5)}
    array = xarray.DataArray(z, coords, ("y", "x"))
    wanted = svg(z, TRANSFORM, CRS)
    assert svg(array, crs=CRS) == wanted
    assert svg(array.transpose(), crs=CRS) == wanted
    assert svg(array.expand_dims("band"), crs=CRS) == wanted
    assert svg(array.sortby("y"), crs=CRS) == wanted
    uneven = array.assign_coords(x=coords["x"] ** 1.1)
    with pytest.raises(orograph.Error, match="x aren't evenly spaced"):
        orograph.terrain(uneven)


def test_rasterio():
    rasterio = pytest.importorskip("rasterio")
    path = DATA / "volcano.tif"
    with rasterio.open(path) as dataset:
        made = orograph.terrain(dataset, name=str(path))
    assert made.render().to_svg() == orograph.read(path).render().to_svg()
