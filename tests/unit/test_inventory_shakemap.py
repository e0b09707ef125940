"""Shake maps: what a grid or a CSV says of a place, motions that have its strength, and what is refused."""

from __future__ import annotations

import gzip
import math
import os
import re
import zlib
from pathlib import Path

import numpy as np
import pytest
from inventories import city, rows_of_results, table

import stayput as sp
from stayput import files
from stayput.fragility.intensity_measures import PGA, PGV, spectral_acceleration
from stayput.inventory import assess
from stayput.inventory.scenarios import read_scenarios
from stayput.inventory.shakemap import GroundLevel, unwrapped
from stayput.inventory.shakemap_files import read_shakemap
from stayput.montecarlo.scaled_motions import ScaledMotions, factors_to_level_zero
from stayput.motion.ground_shaking import MERCALLI_SCATTER, horizontal_peak
from stayput.motion.intensity import pgv_of_mercalli

G = 9.80665
FIELDS = {"LON": "dd", "LAT": "dd", "PGA": "pctg", "PGV": "cms", "MMI": "intensity", "PSA03": "pctg"}
DEVIATIONS = {"LON": "dd", "LAT": "dd", "STDPGA": "ln(pctg)", "STDPGV": "ln(cms)", "STDMMI": "intensity"}


def grid(folder, rows, fields=None, name="grid.xml", head="", size=(2, 2)):
    """A grid as ShakeMap writes it."""
    fields = fields or FIELDS
    space = "http://earthquake.usgs.gov/eqcenter/shakemap"
    specified = f'lon_min="135" lat_min="35" lon_max="136" lat_max="36" nominal_lon_spacing="1.0" nlon="{size[0]}" nlat="{size[1]}"'
    named = "".join(
        f'<grid_field index="{n}" name="{field}" units="{unit}" />\n'
        for n, (field, unit) in enumerate(fields.items(), 1)
    )
    lines = "".join(" ".join(map(str, row)) + "\n" for row in rows)
    file = folder / name
    file.write_text(
        f'<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n{head}'
        f'<shakemap_grid xmlns="{space}" event_id="x" shakemap_version="1">\n'
        f'<event event_id="x" magnitude="7.0" />\n<grid_specification {specified} />\n'
        f"{named}<grid_data>\n{lines}</grid_data>\n</shakemap_grid>\n"
    )
    return file


ROWS = [
    (135, 36, 10, 10, 5.0, 20),
    (136, 36, 20, 20, 6.0, 40),
    (135, 35, 40, 40, 7.0, 80),
    (136, 35, 80, 80, 8.0, 160),
]


DEVIATED = [(lon, lat, 0.5, 0.6, 0.7) for lon, lat, *_ in ROWS]


def test_a_grid_says_the_velocity(tmp_path):
    found = read_shakemap(grid(tmp_path, ROWS))
    assert found.measure == PGV
    assert found.lats.tolist() == [35, 36]
    assert 10.0 ** found.at(36.0, 135.0).level == pytest.approx(0.1, rel=0.03)
    assert 10.0 ** found.at(35.0, 136.0).level == pytest.approx(0.8, rel=0.03)
    assert 10.0 ** found.at(35.5, 135.5).level == pytest.approx(0.1 * 8.0**0.5, rel=0.03)
    assert found.at(35.0, 135.0 - 360.0) == found.at(35.0, 135.0)
    assert found.at(35.0, 135.0).scatter == 0.0


@pytest.mark.parametrize(
    ("field", "measure", "level"),
    [
        ("PGA", PGA, math.log10(0.4 * G)),
        ("pgv", PGV, math.log10(0.4)),
        ("MMI", PGV, math.log10(pgv_of_mercalli(7.0))),
        ("PSA03", spectral_acceleration(0.3), math.log10(0.8)),
    ],
)
def test_any_field_of_a_grid_may_count(tmp_path, field, measure, level):
    found = read_shakemap(grid(tmp_path, ROWS), field)
    assert found.measure == measure
    assert found.at(35.0, 135.0).level == pytest.approx(level, abs=0.0125)


@pytest.mark.parametrize(
    ("field", "scatter"),
    [
        ("PGA", 0.5 / math.log(10)),
        ("PGV", 0.6 / math.log(10)),
        ("MMI", math.hypot(MERCALLI_SCATTER, 0.7 / 3.16)),
    ],
)
def test_uncertainty_is_the_scatter_of_the_level(tmp_path, field, scatter):
    deviations = grid(tmp_path, DEVIATED, DEVIATIONS, "uncertainty.xml")
    found = read_shakemap(grid(tmp_path, ROWS), field, deviations)
    assert found.at(35.0, 135.0).scatter == pytest.approx(scatter, abs=0.005)


def test_a_place_without_a_deviation_is_refused_and_not_taken_as_certain(tmp_path):
    rows = [
        (lon, lat, *(("nan",) * 3 if (lon, lat) == (136, 35) else (0.5, 0.6, 0.7))) for lon, lat, *_ in ROWS
    ]
    deviations = grid(tmp_path, rows, DEVIATIONS, "uncertainty.xml")
    found = read_shakemap(grid(tmp_path, ROWS), "PGV", deviations)
    assert found.at(36.0, 135.0).scatter > 0.0
    with pytest.raises(sp.InputError, match="shake map has no value"):
        found.at(35.2, 135.8)


@pytest.mark.parametrize(
    ("kind", "west", "east"),
    [("grid", 179.5, -179.5), ("grid", -180.5, -179.5), ("csv", 179.5, 180.5), ("places", 179.5, -179.5)],
)
def test_a_map_across_the_antimeridian_is_narrow(tmp_path, kind, west, east):
    rows = [(west if lon == 135 else east, *rest) for lon, *rest in ROWS]
    lines = [f"{lat},{lon},{pgv}" for lon, lat, _, pgv, *_ in rows[: 3 if kind == "places" else 4]]
    csv = table(tmp_path, lines, "lat,lon,pgv[cm/s]", "map.csv")
    found = read_shakemap(grid(tmp_path, rows) if kind == "grid" else csv)
    assert 10.0 ** found.at(36.0, -179.5).level == pytest.approx(0.2, rel=0.03)
    assert found.at(36.0, 180.5) == found.at(36.0, -179.5)
    assert found.at(36.0, 179.6).level <= found.at(36.0, -179.6).level
    with pytest.raises(sp.InputError, match="lon"):
        found.at(36.0, 0.0)


def test_a_map_around_the_earth_stays_as_it_is():
    for lons in ([-180.0, -90.0, 0.0, 90.0, 180.0], [0.0, 120.0, 240.0], [135.0, 136.0]):
        assert unwrapped(np.array(lons)).tolist() == lons


@pytest.mark.parametrize(
    ("name", "unit", "value", "reason"),
    [
        ("STDPGA", "ln(pctg)", "nan", "values of the field STDPGA"),
        ("STDPGA", "pctg", 0.5, r"unit of STDPGA is 'pctg'; it must be ln\(pctg\)"),
        ("STDPGA", "log10(g)", 0.5, "unit of STDPGA"),
        ("STDMMI", "ln(intensity)", 0.5, "unit of STDMMI .* must be intensity"),
    ],
)
def test_an_uncertainty_that_says_nothing_or_something_else_is_refused(tmp_path, name, unit, value, reason):
    rows = [(lon, lat, value) for lon, lat, *_ in ROWS]
    deviations = grid(tmp_path, rows, {"LON": "dd", "LAT": "dd", name: unit}, "uncertainty.xml")
    with pytest.raises(sp.InputError, match=reason):
        read_shakemap(grid(tmp_path, ROWS), name[3:], deviations)


BOMB = "".join(f'<!ENTITY {b} "{9 * f"&{a};"}">' for a, b in zip("abcdefgh", "bcdefghi", strict=True))
BOMB = f'<!DOCTYPE x [<!ENTITY a "{1000 * "a"}">{BOMB}]>\n'
OUTSIDE = '<!DOCTYPE x [<!ENTITY i SYSTEM "file:///etc/passwd">]>\n'

# ruff: noqa: E501 - a case a line
WRONG = {
    "a huge grid": ({"size": (100_000, 100_000)}, "it has 24 numbers; it must have 60000000000"),
    "too many numbers": ({"rows": [*ROWS, ROWS[0]]}, "it has 30 numbers; it must have 24"),
    "an underscore": ({"rows": [*ROWS[:3], (136, 35, "8_0", 1, 1, 1)]}, "must hold numbers alone"),
    "nothing": ({"rows": []}, "it has 0 numbers; it must have 24"),
    "one row of places": ({"rows": ROWS[:2], "size": (2, 1)}, "must be a regular grid"),
    "no places": ({"rows": [row[2:] for row in ROWS], "fields": dict.fromkeys(("PGA", "PGV", "MMI", "X"), "")}, "LON and LAT"),
    "no grid": ({"rows": [ROWS[0], ROWS[1], (135.5, 35, 1, 1, 1, 1), ROWS[3]]}, "must be a regular grid"),
    "a latitude that is none": ({"rows": [(135, "nan", *ROWS[0][2:]), *ROWS[1:]]}, "must be a regular grid"),
    "beyond all": ({"rows": [*ROWS[:3], (136, 35, 80, 80_000, 8, 160)]}, "PGV on the shake map is 80000"),
    "below nothing": ({"rows": [*ROWS[:3], (136, 35, 80, -1, 8, 160)]}, "PGV on the shake map is -1"),
    "unknown unit": ({"fields": {**FIELDS, "PGV": "mph"}}, "it must be one of 'cm/s', 'm/s'"),
    "no field": ({"fields": dict.fromkeys(("LON", "LAT", "A", "B", "C", "SVEL"), "")}, "field is None; it must be one of 'pgv'"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_wrong_grids_are_refused(tmp_path, name):
    given, reason = WRONG[name]
    with pytest.raises(sp.InputError, match=reason):
        read_shakemap(grid(tmp_path, **{"rows": ROWS, **given}))


DAMAGE = {
    "entities that grow": (r"(<shakemap_grid[^>]*>)", rf"{BOMB}\1&i;", "no well-formed XML"),
    "another file": (r"(<shakemap_grid[^>]*>)", rf"{OUTSIDE}\1&i;", "no well-formed XML"),
    "no specification": (r"<grid_specification[^>]*/>", "", "with a grid_specification"),
    "no size": ('nlon="2"', "", "nlon and nlat are whole numbers"),
    "no index": ('index="1"', "", "each field once with an index"),
    "an unknown encoding": ("UTF-8", "klingon", "no well-formed XML"),
    "a late field": ("</grid_data>", '</grid_data><grid_field index="9" name="X"/>', "numbers; it must have"),
}  # fmt: skip


@pytest.mark.parametrize("name", DAMAGE)
@pytest.mark.parametrize("uncertain", [False, True])
def test_damaged_grids_are_refused_in_a_sentence(tmp_path, name, uncertain):
    pattern, other, reason = DAMAGE[name]
    given = (DEVIATED, DEVIATIONS) if uncertain else (ROWS, FIELDS)
    damaged = grid(tmp_path, *given, name="a.xml")
    damaged.write_text(re.sub(pattern, other, damaged.read_text("utf-8")), "utf-8")
    with pytest.raises(sp.InputError) as refused:
        read_shakemap(*((grid(tmp_path, ROWS), "PGV", damaged) if uncertain else (damaged,)))
    told = refused.value.told("en")
    assert "a.xml" in told
    assert told.count("\n") == 0
    assert re.search(reason, told)


@pytest.mark.parametrize("encoding", ["UTF-16LE", "UTF-16BE", "UTF-8"])
def test_a_grid_after_a_byte_order_mark_is_read(tmp_path, encoding):
    file = grid(tmp_path, ROWS)
    plain = read_shakemap(file)
    text = file.read_text("utf-8").replace("UTF-8", encoding[:6])
    file.write_bytes(f"\ufeff{text}".encode(encoding))
    assert read_shakemap(file).levels.tolist() == plain.levels.tolist()


@pytest.mark.parametrize("pack", [gzip.compress, lambda text: b"PK\x03\x04" + zlib.compress(text)])
def test_a_map_that_is_compressed_is_refused(tmp_path, pack):
    file, plain = tmp_path / "grid.xml.gz", grid(tmp_path, ROWS)
    file.write_bytes(pack(plain.read_bytes()))
    with pytest.raises(sp.InputError, match=r"grid\.xml\.gz'; it must be CSV .* or .*grid.xml, uncompressed"):
        read_shakemap(file)
    with pytest.raises(sp.InputError, match="cannot be read: it is no well-formed XML"):
        read_shakemap(plain, None, file)


@pytest.mark.skipif(os.name != "posix", reason="pipes and devices with names are those of POSIX")
@pytest.mark.parametrize(
    ("given", "kind"), [("inventory", "pipe"), ("shakemap", "device"), ("uncertainty", "folder")]
)
def test_what_is_no_file_is_refused_and_not_read(tmp_path, given, kind):
    """A device such as /dev/zero never ends, and a pipe waits for who writes to it."""
    path = {"device": Path("/dev/zero"), "pipe": tmp_path / "pipe", "folder": tmp_path}[kind]
    if kind == "pipe":
        os.mkfifo(path)
    inventory, shakemap = table(tmp_path, ["p,chest"], "id,preset"), grid(tmp_path, ROWS)
    files = {"inventory": inventory, "shakemap": shakemap, given: path}
    called = given.replace("shakemap", "shake map")
    with pytest.raises(sp.InputError, match=f"The {called}.* is '{path}'; it must be a file"):
        assess(scenario=city(tmp_path), out=tmp_path / "out", **files)
    assert not (tmp_path / "out").exists()


def test_a_line_without_end_is_not_read_to_its_end(tmp_path, monkeypatch):
    monkeypatch.setattr(files, "LARGEST_LINE", 1000)
    path, refused = tmp_path / "long.csv", r"'.*long\.csv' has a line of more than 1,000 characters"
    path.write_text("lat,lon,intensity\n" + 3000 * " ")
    with pytest.raises(sp.InputError, match=refused):
        read_shakemap(path)
    path.write_text("id,preset\n" + 3000 * " ")
    with pytest.raises(sp.InputError, match=refused):
        assess(path, city(tmp_path), tmp_path / "out")


def test_an_uncertainty_must_be_of_the_same_places(tmp_path):
    rows = [(lon + 1, lat, 0.5, 0.6, 0.7) for lon, lat, *_ in ROWS]
    other = grid(tmp_path, rows, DEVIATIONS, "uncertainty.xml")
    with pytest.raises(sp.InputError, match="must be one for the places of the shake map"):
        read_shakemap(grid(tmp_path, ROWS), "PGA", other)
    with pytest.raises(sp.InputError, match="must be a file with values of the field STDPSA03"):
        read_shakemap(grid(tmp_path, ROWS), "PSA03", other)
    with pytest.raises(sp.InputError, match="without shakemap"):
        assess(other, city(tmp_path), tmp_path / "out", uncertainty=other)


@pytest.mark.parametrize(
    ("header", "row", "level"),
    [
        ("lat,lon,pga[%g]", "35,135,40", GroundLevel(0.6)),
        ("lat,lon,pga (gal)", "35,135,400", GroundLevel(0.6)),
        ("latitude,longitude,pga_g", "35,135,0.4", GroundLevel(0.6)),
        ("lat,lon,pgv[cm/s]", "35,135,40", GroundLevel(-0.4)),
        ("lat,lon,pgv[m/s]", "35,135,0.4", GroundLevel(-0.4)),
        ("lat,lon,mmi", "35,135,7", GroundLevel(-0.7, 0.38)),
        ("lat,lon,pgv[cm/s],sigma", "35,135,40,0.5", GroundLevel(-0.4, 0.22)),
        ("lat,lon,intensity,sigma", "35,135,5,0.3", GroundLevel(5.0, 0.3)),
    ],
)
def test_columns_of_a_csv_have_their_units(tmp_path, header, row, level):
    found = read_shakemap(table(tmp_path, [row], header, "map.csv")).at(35.0, 135.0)
    assert found == pytest.approx(level, abs=1e-9)


def test_of_several_columns_one_is_chosen(tmp_path):
    file = table(tmp_path, ["35,135,40,30"], "lat,lon,pga[%g],pgv[cm/s]", "map.csv")
    with pytest.raises(sp.InputError, match="of several measures one must be chosen"):
        read_shakemap(file)
    assert read_shakemap(file, "PGV[cm/s]").measure == PGV


MANY = """
[room]
floor = "wood flooring"
[shaking]
intensity = 5.0
vertical = false
suite = { family = "crustal", count = 40, seed = 1 }
[uncertainty]
samples = 1
seed = 3
"""


def test_scatter_is_that_of_independent_draws(tmp_path):
    """The share that overturns under scattered levels is the mean over levels drawn one by one."""
    inventory = table(tmp_path, ["p,0.3,1.8,80,35,135"], "id,width,height,mass,lat,lon")
    scenario = city(tmp_path, MANY)
    level, sigma = math.log10(0.2), 0.6 / math.log(10.0)
    shares = {}
    for name, deviation in (("without", 0.0), ("with", 0.6)):
        file = table(tmp_path, [f"35,135,20,{deviation}"], "lat,lon,pgv[cm/s],sigma", "map.csv")
        done = assess(inventory, scenario, tmp_path / name, shakemap=file, progress=False)
        (row,) = rows_of_results(done)
        shares[name] = row["overturned"]
        assert row["shaking_scatter"] == pytest.approx(deviation / math.log(10.0), abs=0.005)
    body = sp.Body(width=0.3, height=1.8, mass=80.0)
    room = sp.Room(floor=sp.Floor.of("wood flooring"))
    motions = list(read_scenarios(scenario).all[0].ground)
    draw, fallen = np.random.default_rng(5), 0
    tried = 600
    for number in range(tried):
        motion = motions[number % len(motions)]
        wanted = 10.0 ** (level + sigma * draw.normal())
        flat = sp.Motion(dt=motion.dt, x=motion.x)
        fallen += sp.simulate(body, room, flat.scaled(wanted / horizontal_peak(motion, "PGV"))).overturned
    assert shares["with"] != shares["without"]
    assert shares["with"] == pytest.approx(fallen / tried, abs=0.09)  # 40 runs against 600


@pytest.mark.parametrize(
    ("said", "other", "named"),
    [('event_id="x"', 'event_id="us70"', "us70, version 1"), ('version="1"', 'version="2"', "x, version 2")],
)
def test_the_uncertainty_of_another_event_or_version_is_refused(tmp_path, said, other, named):
    map_file, file = grid(tmp_path, ROWS), grid(tmp_path, DEVIATED, DEVIATIONS, "uncertainty.xml")
    assert read_shakemap(map_file, uncertainty=file).at(36.0, 135.0).scatter > 0.0
    file.write_text(file.read_text().replace(said, other, 1))
    with pytest.raises(
        sp.InputError, match=f"is of 'x, version 1' and the uncertainty .* of '{named}'"
    ) as refused:
        read_shakemap(map_file, uncertainty=file)
    assert "grid.xml" in str(refused.value)
    assert "uncertainty.xml" in str(refused.value)
    assert "同じ地震の同じ版でなければ" in refused.value.told("ja")


def test_an_uncertainty_without_an_event_is_warned_of(tmp_path):
    map_file, file = grid(tmp_path, ROWS), grid(tmp_path, DEVIATED, DEVIATIONS, "uncertainty.xml")
    file.write_text(file.read_text().replace(' event_id="x" shakemap_version="1"', "", 1))
    with pytest.warns(sp.InputWarning, match="do not both say of which event they are") as heard:
        read_shakemap(map_file, uncertainty=file)
    assert "同じ地震のものかどうか" in heard[0].message.told("ja")


GRID = ["35,135,5", "35,136,6", "36,135,6", "36,136,7"]


def test_a_shake_map_is_bilinear_on_a_grid(tmp_path):
    file = table(tmp_path, GRID, "lat,lon,intensity", "map.csv")
    found = read_shakemap(file)
    assert found.at(35.0, 135.0).level == 5.0
    assert found.at(35.5, 135.5).level == 6.0
    assert found.at(35.25, 135.25).level == 5.5
    assert found.at(36.0, 136.0).level == 7.0
    with pytest.raises(sp.InputError, match="lat on the shake map is 37"):
        found.at(37.0, 135.5)


def test_a_shake_map_of_any_places_gives_the_nearest(tmp_path):
    file = table(tmp_path, [*GRID[:3], "35.5,135.6,6.66"], "lat,lon,intensity", "map.csv")
    assert read_shakemap(file).at(35.5, 135.5).level == 6.7


def test_a_shake_map_says_how_strong_it_shakes(tmp_path):
    grid = table(tmp_path, GRID, "lat,lon,intensity", "map.csv")
    inventory = table(tmp_path, ["p,chest,35,135", "q,chest,35.5,135.5", "r,chest,1,1"], "id,preset,lat,lon")
    done = assess(inventory, city(tmp_path), tmp_path / "out", shakemap=grid, progress=False)
    assert [row["intensity"] for row in rows_of_results(done)] == [5.0, 6.0]
    assert "shake map" in done.rejects.to_pylist()[0]["reason"]


def geometric_mean_of_sa(motion, period):
    spectra = [motion.spectrum([period], 0.05, name).sa[0] for name in ("x", "y")]
    return np.sqrt(np.prod(spectra)) / G


@pytest.mark.parametrize("field", ["sa_0.05", "sa_0.3", "sa_1", "pga[g]", "pgv[m/s]"])
def test_motions_have_the_strength_of_the_map(tmp_path, field):
    places = ["35,135,0.1", "35,136,0.4", "36,135,0.4", "36,136,1.6"]
    rows = ["p,chest,35,135", "q,chest,35.5,135.5"]
    inventory, scenario = table(tmp_path, rows, "id,preset,lat,lon"), city(tmp_path)
    shakemap = table(tmp_path, places, f"lat,lon,{field}", "map.csv")
    done = assess(inventory, scenario, tmp_path / "out", shakemap=shakemap, progress=False)
    suite, name, measure = (
        read_scenarios(scenario).all[0].ground,
        field[:3].strip("_"),
        read_shakemap(shakemap).measure,
    )
    ground = ScaledMotions(suite, measure=measure)
    unit = {"sa": 1.0, "pga": G, "pgv": 100.0}[name]  # of the results: g, m/s², cm/s
    for row, wanted in zip(rows_of_results(done), (0.1, 0.4), strict=True):
        assert row[name] == pytest.approx(wanted * unit, rel=0.03)
        assert [row[other] for other in ("sa", "pga", "pgv") if other != name] == [None, None]
        level = np.log10(row[name] / (100.0 if name == "pgv" else 1.0))
        felt = [motion.scaled(float(k)) for motion, k in zip(suite, ground.factors(level), strict=True)]
        if name == "sa":
            found = [geometric_mean_of_sa(motion, measure.period) for motion in felt]
        else:
            found = [horizontal_peak(motion, name.upper()) for motion in felt]
        assert found == pytest.approx([10.0**level] * len(felt), rel=1e-9)
        assert row["intensity"] == pytest.approx(np.median([motion.intensity for motion in felt]), abs=0.03)
    if name == "sa":
        page = (done.folder / "report.html").read_text(encoding="utf-8").replace("\N{NO-BREAK SPACE}", " ")
        assert f"Sa at {measure.period:g} s, 5 % damping, geometric mean" in page


def test_a_motion_of_one_component_has_its_sa():
    motion = sp.sine(5.0, 1.0, 10.0)
    (factor,) = factors_to_level_zero(spectral_acceleration(0.5), [motion])
    assert motion.scaled(factor).spectrum([0.5]).sa[0] / G == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize(
    "header",
    [
        "lat,lon",
        "lat,lon,pga",
        "lat,lon,sa(0.3)",
        "lat,lon,sa_-1",
        "lat,intensity,sa_0.3",
        "lat,lon,sa_0.3,sa_1.0",
        "lat,lon,lon,sa_0.3",
        "",
    ],
)
def test_a_map_tells_one_thing(tmp_path, header):
    file = table(tmp_path, ["35,135,0.4"], header, "map.csv")
    with pytest.raises(sp.InputError, match=r"must be lat, lon and one of intensity|unit must be one of"):
        read_shakemap(file)


@pytest.mark.parametrize(
    ("header", "row", "told"),
    [
        ("sa_20", "35,135,1", "is 20 s; it must be between 0.01 and 10 s"),
        ("sa_0.3", "35,135,40", "sa_0.3 in row 2 of the shake map is 40 g; it must be between"),
        ("sa_0.3", "35,135,0", "sa_0.3 in row 2 of the shake map is 0 g"),
        ("sa_0.3", "35,135,nan", "is nan; it must be a finite number"),
        ("sa_0.3", "35,135,0.4 g", "is '0.4 g'; it must be a number"),
        ("sa_0.3", "35,135,,", "row 2: The row has 4 cells; it must have one for each of 3"),
        ("intensity", "35,135,10", "is 10; it must be between -3 and 7.5"),
        (
            "intensity",
            "35,135,5\n35.0,135,6",
            "lat, lon in row 3 of the shake map is 35, 135; it must not be that of row 2",
        ),
    ],
)
def test_a_bad_map_is_refused(tmp_path, header, row, told):
    file = table(tmp_path, [row], f"lat,lon,{header}", "map.csv")
    with pytest.raises(sp.InputError) as error:
        read_shakemap(file)
    assert told in str(error.value)
