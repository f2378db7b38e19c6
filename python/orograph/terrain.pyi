# SPDX-License-Identifier: GPL-3.0-or-later
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, TypedDict, Unpack

from numpy.typing import ArrayLike

from orograph.drawing import Drawing
from orograph.sights import Horizon, Sights

Path = str | os.PathLike[str]
Several = str | float | Sequence[str | float]  # texts as the command takes them, or their parts

class ReadOptions(TypedDict, total=False):
    """Those of `orograph render` that read a terrain."""

    band: int | str | None
    oo: Path | Sequence[Path] | None
    bbox: Several | None
    bbox_lonlat: Several | None
    overview: int | str | None
    fill_voids: float | str | None
    height_unit: str | None
    allow_network: bool | None
    max_memory: str | None
    input_layer: str | None
    repair: bool | None
    columns: Several | None
    height_field: str | None
    breaklines: Path | None
    boundary: Path | None
    max_edge: float | str | None
    jobs: int | str | None


class RenderOptions(TypedDict, total=False):
    """Those of `orograph render` that draw one."""

    view_from: Several | None
    elevation_above: Literal["target", "eye"] | None
    projection: (
        Literal["perspective", "orthographic", "oblique", "cylindrical", "equirectangular"] | None
    )
    oblique: Several | None
    axonometric: Literal["isometric", "dimetric", "trimetric"] | None
    view: Path | None
    distance: float | str | None
    fov: float | str | None
    eye: Several | None
    eye_lonlat: Several | None
    eye_height: float | str | None
    eye_summit: float | str | bool | None
    azimuth_range: Several | None
    altitude_range: Several | None
    strips: int | str | None
    look_at: Several | None
    look_at_lonlat: Several | None
    look_azimuth: float | str | None
    pitch: float | str | None
    roll: float | str | None
    curvature: Literal["auto", "on", "off"] | None
    refraction: float | str | None
    curvature_coefficient: float | str | None
    exaggeration: Several | None
    profiles: int | str | None
    spacing: Several | None
    detail: float | str | None
    level_error: float | str | None
    spread: Literal["even", "planes"] | None
    light: Several | None
    light_contrast: float | str | None
    light_smooth: float | str | None
    light_by: Literal["width", "density"] | None
    haze: float | str | None
    occluder: Literal["surface", "profiles"] | None
    underside: Literal["draw", "omit"] | None
    visibility_tolerance: float | str | None
    simplify: float | str | None
    silhouette_jump: float | str | None
    join: float | str | None
    shore_smooth: float | str | None
    min_stroke: float | str | None
    flat: Literal["shore", "draw", "waterlines"] | None
    outline: Literal["one", "by-layer"] | None
    void_edges: bool | None
    layers: Several | None
    palette: Literal["mono", "map"] | None
    colour: str | Mapping[str, str] | Sequence[str] | None
    hidden: Literal["omit", "dash"] | None
    hidden_layers: Several | None
    contours: Several | None
    contour_offset: float | str | None
    index_every: int | str | None
    contour_ticks: bool | None
    mesh: Several | None
    mesh_lines: Literal["both", "x", "y"] | None
    mesh_along: Literal["map", "view"] | None
    drape: Path | Sequence[Path] | None
    drape_where: str | None
    drape_offset: float | str | None
    graticule: Several | None
    grid: Several | None
    hachures: bool | None
    hachure_spacing: Several | None
    hachure_slope: Several | None
    block: float | str | bool | None
    block_sides: Literal["lines", "outline"] | None
    labels: Path | None
    label_field: str | None
    label_weight: str | None
    label_where: str | None
    label_max: int | str | None
    label_range: float | str | None
    label_haze: float | str | None
    label_angle: float | str | None
    label_rows: int | str | None
    label_elevation: Literal["m", "ft", "none"] | None
    label_size: float | str | None
    label_halo: float | str | None
    contour_labels: bool | None
    coordinate_labels: bool | None
    text: Literal["font", "stroke"] | None
    font: str | None
    stroke_letters: Path | None
    furniture: Several | None
    subtitle: str | None
    source: str | None
    date: str | None
    template: Path | None
    scene: Path | None
    page: Several | None
    crop: bool | None
    scale: Several | None
    portrait: bool | None
    landscape: bool | None
    margin: float | str | None
    pen_width: Several | None
    title: str | None
    of: Literal["svg", "pdf", "ps", "eps", "png", "geojson", "gpkg", "hpgl", "gcode",
        "dxf"] | None
    device: Path | None
    pen_order: Literal["drawing", "sorted", "best"] | None
    dpi: float | str | None
    overwrite: bool | None
    check: int | str | None
    pen_speed: float | str | None
    pen_up_speed: float | str | None
    pen_lift_s: float | str | None
    pens: Path | None
    pause_between_pens: bool | None
    clip_to: Several | None
    sheets: Several | None
    overlap: Several | None
    jobs: int | str | None
    settings: Path | None


class VisibleOptions(TypedDict, total=False):
    """Those of `orograph visible` that tell the eye."""

    eye: Several | None
    eye_lonlat: Several | None
    eye_height: float | str | None
    eye_summit: float | str | bool | None
    curvature: Literal["auto", "on", "off"] | None
    refraction: float | str | None
    curvature_coefficient: float | str | None
    exaggeration: Several | None
    target_height: float | str | None
    jobs: int | str | None


class HorizonOptions(TypedDict, total=False):
    """The same of the skyline all round."""

    eye: Several | None
    eye_lonlat: Several | None
    eye_height: float | str | None
    eye_summit: float | str | bool | None
    curvature: Literal["auto", "on", "off"] | None
    refraction: float | str | None
    curvature_coefficient: float | str | None
    exaggeration: Several | None
    horizon_step: float | str | None
    jobs: int | str | None


def read(paths: Path | Sequence[Path], **options: Unpack[ReadOptions]) -> Terrain: ...
def terrain(
    z: ArrayLike | Any,
    transform: Any = None,
    crs: Any = None,
    nodata: float | None = None,
    *,
    height_unit: str = "m",
    name: str = "heights",
) -> Terrain: ...
def tin(
    vertices: ArrayLike,
    triangles: ArrayLike,
    crs: Any = None,
    *,
    height_unit: str = "m",
    repair: bool = False,
    name: str = "triangles",
) -> Terrain: ...

class Session:
    terrain: Terrain
    def __init__(self, terrain: Terrain) -> None: ...
    def render(
        self,
        *,
        progress: Callable[[float], object] | None = None,
        **options: Unpack[RenderOptions],
    ) -> Drawing: ...
    def visible(
        self,
        points: ArrayLike | Any,
        *,
        lonlat: bool = False,
        progress: Callable[[float], object] | None = None,
        **options: Unpack[VisibleOptions],
    ) -> Sights: ...
    def horizon(
        self,
        *,
        progress: Callable[[float], object] | None = None,
        **options: Unpack[HorizonOptions],
    ) -> Horizon: ...

class Terrain:
    @property
    def name(self) -> str: ...
    @property
    def crs_wkt(self) -> str: ...
    @property
    def notes(self) -> list[str]: ...
    def session(self) -> Session: ...
    def render(
        self,
        *,
        progress: Callable[[float], object] | None = None,
        **options: Unpack[RenderOptions],
    ) -> Drawing: ...
    def visible(
        self,
        points: ArrayLike | Any,
        *,
        lonlat: bool = False,
        progress: Callable[[float], object] | None = None,
        **options: Unpack[VisibleOptions],
    ) -> Sights: ...
    def horizon(
        self,
        *,
        progress: Callable[[float], object] | None = None,
        **options: Unpack[HorizonOptions],
    ) -> Horizon: ...
