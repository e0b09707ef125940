"""Headers as agencies, phones and spreadsheets write them: columns, units and the vertical."""

import io
import math
import re
import zipfile
from importlib.resources import files

import pytest
from test_readers_japan import knet
from test_readers_peer import VALUES, at2
from test_readers_world import WAVE, cosmos, csmip_channel, esm

import stayput as sp
from stayput.errors import InputError, warnings_to
from stayput.motion.channels import is_direction, is_vertical
from stayput.motion.units import ACCELERATION_UNITS, known_unit

PEAKS = (0.1, 3.0, 2.0)  # of the columns behind the time [m/s²], in gal in the files
ROWS = [(0.02 * i, *(100.0 * peak * math.sin(math.pi * i / 20) for peak in PEAKS)) for i in range(41)]


def table(mark=" ", columns=4):
    return "".join(mark.join(f"{value:.3f}" for value in row[:columns]) + "\n" for row in ROWS)


@pytest.fixture
def read(tmp_path):
    """Read a file; return the peaks of its components and what was told of it."""

    def reader(text, name="record.txt", **given):
        file = tmp_path / name
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        told: list[str] = []
        with warnings_to(lambda warning: told.append(warning.code)):
            motion = sp.read_motion(file, **given)
        return {key: round(float(abs(a).max()), 6) for key, a in motion.components.items()}, told

    return reader


def refusal(read, text, **given) -> InputError:
    with pytest.raises(InputError) as caught:
        read(text, **given)
    return caught.value


CWA = (
    "#StationCode: X01\n#StartTime: 2020/01/02-03:04:05.000\n#RecordLength(sec):   0.800\n"
    "#SampleRate(Hz): 50\n"
    "#AmplitudeUnit:  gal. DCoffset(corr)\n#AmplitudeMAX. U:   10.000~  -10.000\n"
    "#DataSequence: Time U(+); N(+); E(+)\n#Data: 4F10.3\n"
)
UP_FIRST = {"x": 3.0, "y": 2.0, "z": 0.1}
UP_LAST = {"x": 0.1, "y": 3.0, "z": 2.0}


@pytest.mark.parametrize(
    "header",
    [
        CWA,
        CWA.upper(),
        "# unit: gal\n# columns: t, UD, NS, EW\n",
        "# Unit = gal\n# Data columns = Time; Vertical; N-S; E-W\n",
        "# unit: gal\n# Fields: time UP NORTH EAST\n",
        "# unit: gal\n# column 1: Time (s)\n# column 2: UD\n# column 3: NS\n# column 4: EW\n",
        "% col 1 = t | col 2 = Z (gal) | col 3 = N (gal) | col 4 = E (gal)\n",
        "# t [s]  UD  NS  EW\n# event of magnitude 7, unit: gal\n",
        "A record\nColumns: time, UD, NS, EW\nUnits: gal\n",
        "# unit: gal\n# Format: time, UD, NS, EW\n",
        "# ch1: UD, ch2: NS, ch3: EW\n# unit: gal, filtered below 50 Hz\n",
        "# unit: gal\n# UP NORTH EAST\n",
        "# unit: gal\n# Channels: UD, NS, EW\n",
        "# unit: gal\n# x: UD, y: NS, z: EW\n",
        "! time | UD | NS | EW\n# unit of measurement: gal\n",
        "t UD NS EW\n---- ---- ---- ----\n# unit: gal\n",
        "# t UD NS EW\n# s gal gal gal\n",
        "UD,NS,EW\ns,gal,gal,gal\n".replace("UD", "t,UD"),
    ],
)
def test_an_order_of_columns_that_is_stated_is_followed(read, header):
    assert read(header + table())[0] == UP_FIRST


@pytest.mark.parametrize(
    ("header", "columns", "english", "japanese"),
    [
        (
            "# columns: t, A, B, C\n",
            4,
            "as 't', 'A', 'B', 'C', and has 4 columns",
            "「t」、「A」、「B」、「C」",
        ),
        ("#DataSequence: Time U(+); N(+)\n", 4, "each must be named once", "4列あります"),
        ("# t, UD, NS, EW\n# from 2020\n", 2, "and has 2 columns", "2列あります"),
        ("t,UD,NS,EW\n", 2, "and has 2 columns", "2列あります"),
        ("# column 1: time\n# column 3: UD\n", 2, "each must be named once", "2列あります"),
        (
            "#DataSequence: Time U(-); N(+); E(+)\n",
            4,
            r"'U(-)' is positive the other way",
            "正負の向きが逆です",
        ),
        (
            "time,acc\nof the north\n",
            2,
            "'of the north' stands between",
            "見出しと数値の間に「of the north」",
        ),
    ],
)
def test_an_order_that_is_not_understood_is_refused(read, header, columns, english, japanese):
    error = refusal(read, header + table(columns=columns), unit="gal")
    assert english in str(error)
    assert japanese in error.told("ja")


@pytest.mark.parametrize("line", ["# Component: UD", "# channel = HNZ", "Direction: Up", "# 成分：上下"])
@pytest.mark.parametrize("columns", [1, 2])
def test_a_component_that_is_stated_names_the_only_column(read, line, columns):
    rows = "".join(f"{row[1]:.3f}\n" for row in ROWS) if columns == 1 else table(columns=2)
    assert read(f"{line}\n# unit: gal\n{rows}", dt=0.02)[1] == ["motion.vertical_alone"]


@pytest.mark.parametrize(
    ("heading", "factor"),
    [
        ("acc [mg]", 9.80665e-3),
        ("acc (mG)", 9.80665e-3),
        ("acc_mg", 9.80665e-3),
        ("acc [%g]", 9.80665e-2),
        ("Acc. (% g)", 9.80665e-2),
        ("acc [in/s2]", 0.0254),
        ("acc (in/sec/sec)", 0.0254),
        ("acc [ft/s^2]", 0.3048),
        ("acc_x_m_s2", 1.0),
        ("ax_mps2", 1.0),
        ("a [m s^-2]", 1.0),
        ("Linear Acceleration x (m/s^2)", 1.0),
        ("Acceleration (m·s⁻²)", 1.0),
        ("acc [cm/sec**2]", 0.01),
        ("NS (Gal)", 0.01),
        ("accx [g]", 9.80665),
        ("g", 9.80665),
    ],
)
def test_units_of_headings_that_can_be_known(read, heading, factor):
    peaks, told = read(f"Time [S],{heading}\n0,0.1\n0.01,-0.2\n0.02,0.1\n")
    assert peaks == {"x": pytest.approx(0.2 * factor, abs=1e-6)}
    assert told == []


@pytest.mark.parametrize(
    ("header", "unit", "english", "japanese"),
    [
        ("time [s],acc [km/h2]\n", "km/h2", "states the unit 'km/h2'", "単位「km/h2」には対応していません"),
        (
            "time [s],acc [kip]\n",
            "kip",
            "states the unit 'kip', which is not known",
            "単位「kip」には対応していません",
        ),
        (
            "Time,Acc\n(s),(kip)\n",
            "kip",
            "states the unit 'kip', which is not known",
            "単位「kip」には対応していません",
        ),
        ("# UNITS OF G * 10\n", "G * 10", "states the unit 'G * 10'", "単位「G * 10」には対応していません"),
        ("# unit: G (X 1000)\n", "G (X 1000)", "states the unit 'G (X 1000)'", "「G (X 1000)」"),
        ("# units = 0.01 g\n", "0.01 g", "states the unit '0.01 g'", "「0.01 g」"),
        ("# unit: g/10\n", "g/10", "states the unit 'g/10'", "「g/10」"),
    ],
)
def test_a_unit_that_is_not_known_is_named_unless_the_user_states_it(read, header, unit, english, japanese):
    error = refusal(read, header + table(",", 2))
    assert english in str(error)
    assert japanese in error.told("ja")
    assert error.field == "unit"
    peaks, told = read(header + table(",", 2), unit="gal")
    assert peaks == {"x": 0.1}
    assert told == ["motion.unit_mentioned"]
    assert known_unit(unit) is None


def test_the_page_offers_every_unit():
    script = files("stayput").joinpath("app", "page", "upload.js").read_text("utf-8")
    assert re.findall('"([^"]+)"', script[script.index("UNITS = [") :].split("]")[0]) == list(
        ACCELERATION_UNITS
    )


@pytest.mark.parametrize("units", ["G * 10", "G (X 1000)"])
def test_a_multiple_of_g_in_an_at2_file_is_not_g(read, units):
    error = refusal(read, at2(unit=f"IN UNITS OF {units}"))
    assert f"states the unit '{units}'" in str(error)


@pytest.mark.parametrize(
    ("header", "english", "japanese"),
    [
        ("# unit: counts\n", "'counts', that of raw counts", "「counts」は収録器の生のカウント値や電圧"),
        ("# UNITS: cm/s\n", "'cm/s', that of velocity", "「cm/s」は速度の単位です"),
        ("time,acc [counts]\n", "is of raw counts", "収録器の生のカウント値や電圧のファイルです"),
        ("t,Gyroscope x (rad/s)\n", "is of velocity", "速度のファイルです"),
        ("t,vel\ns,in/s\n", "is of velocity", "速度のファイルです"),
    ],
)
def test_what_is_no_acceleration_is_refused_whatever_the_user_states(read, header, english, japanese):
    error = refusal(read, header + table(",", 2), unit="gal")
    assert english in str(error)
    assert japanese in error.told("ja")


def test_what_else_stands_in_brackets_is_no_unit(read):
    for heading in ("acc (filtered)", "NS (channel 1)", "acc (+)", "a (NS)"):
        assert read(f"t,{heading}\n{table(',', 2)}", unit="gal") == ({"x": 0.1}, [])
        assert refusal(read, f"t,{heading}\n{table(',', 2)}").code == "motion.no_unit"


def test_places_are_no_directions_of_columns(read):
    for line in ("# station at x: 135.2 E, y: 35.1 N", "# Station: TST, component 3 of 3", "# channel: 7"):
        assert read(f"{line}\n# unit: gal\n{table(columns=2)}") == ({"x": 0.1}, [])


def test_a_unit_of_time_is_none_of_acceleration(read):
    for header in ("# time unit: s, unit: gal\n", "# Unit of time: s\n# unit of acceleration: gal\n"):
        assert read(header + table(columns=2))[0] == {"x": 0.1}
    assert refusal(read, "# recorder unit (S/N 3)\n" + table(columns=2)).code == "motion.no_unit"


@pytest.mark.parametrize(
    "label",
    [
        *("UD", "U-D", "UD1", "UP", "Up", "V", "U", "Z", "Vert.", "vertical", "DN", "UP DEG"),
        *("HNZ", "BHZ00", "HNZ.10", "00.HNZ", "acc_z", "accZ", "az", "z-axis", "acc_z_g"),
        *("Linear Acceleration z", "Acceleration Up", "Vertical component"),
    ],
)
def test_names_of_the_vertical(label):
    assert is_vertical(label)


@pytest.mark.parametrize(
    "label", ["NS", "HNE10", "ax", "acc_y", "L", "T", "H1", "East", "Linear Acceleration x"]
)
def test_names_of_horizontal_directions(label):
    assert is_direction(label)
    assert not is_vertical(label)


@pytest.mark.parametrize(
    "label", ["acc", "S14E1 rotated", "20 Hz", "Hachinohe", "60 deg", "a 1", "channel 2", ""]
)
def test_labels_that_are_not_vertical(label):
    assert not is_vertical(label)


@pytest.mark.parametrize(
    ("names", "peaks"),
    [
        ("Time (s),U,N,E", UP_FIRST),
        ("t,V,L,T", UP_FIRST),
        ("t,L,T,V", UP_LAST),
        ("Time,L (gal),T (gal),V (gal)", UP_LAST),
        ("time,BHN00,BHE00,BHZ00", UP_LAST),
        (
            '"Time (s)",' + ",".join(f'"Linear Acceleration {axis} (gal)"' for axis in "xyz"),
            UP_LAST,
        ),
        ("time_s,acc_x,acc_y,acc_z", UP_LAST),
        ("time\tgFx\tgFy\tgFz", UP_LAST),
        ("Time (s)\tAcc NS (gal)\tAcc EW (gal)\tAcc UD (gal)", UP_LAST),
    ],
)
def test_the_vertical_of_columns_is_known_by_its_usual_names(read, names, peaks):
    mark = "\t" if "\t" in names else ","
    found, told = read(f"{names}\n{table(mark)}", unit="gal")
    assert found == peaks
    assert told in ([], ["motion.x_chosen"])


def test_a_transverse_component_is_not_the_time(read):
    error = refusal(read, "L,T,V,R\n" + table(","), unit="gal")
    assert error.code == "motion.column_no_time"
    assert read("T,acc\n" + table(",", 2), unit="gal")[0] == {"x": 0.1}


@pytest.mark.parametrize("heading", ["acc_z", "Linear Acceleration z (gal)", "Acceleration UD", "U", "V"])
def test_a_vertical_column_alone_is_told(read, heading):
    assert read(f"time,{heading}\n{table(',', 2)}", unit="gal")[1] == ["motion.vertical_alone"]


def test_a_vertical_at2_file_is_told_by_its_title_or_its_name(read):
    for direction in ("BHZ00", "HNZ", "U", "V", "UP"):
        assert read(at2(title=f"QUAKE 1/2/99, PLACE, {direction}"))[1] == ["motion.vertical_alone"]
    for name in ("RSN1_QUAKE_BHZ00.AT2", "A-PLCDWN.AT2", "PLCCUP.AT2", "PLC-UP.AT2", "quake_HNZ.AT2"):
        assert read(at2(title="no direction"), name=name)[1] == ["motion.vertical_by_name"]
    assert read(at2(title="QUAKE 1/2/99, PLACE, BHN00"), name="RSN1_BHN00.AT2")[1] == []


@pytest.mark.parametrize(
    "spell",
    [
        lambda text: text.replace("ACCELERATION", "Acceleration"),
        str.lower,
        lambda text: text.replace(": ", " : "),
        lambda text: text.replace(": ", ":"),
        lambda text: "".join(f"  {line}\n" for line in text.splitlines()),
        lambda text: text.replace("HNE", "U"),
    ],
)
def test_esm_headers_in_any_case_and_spacing(read, spell):
    peaks, told = read(spell(esm()))
    assert peaks == {"x": pytest.approx(0.01 * abs(WAVE).max())}
    assert told == (["motion.vertical_alone"] if "STREAM: U" in spell(esm()) else [])


def test_other_headers_in_any_case_and_spacing(read):
    whole = {"x": pytest.approx(9.80665 * max(map(abs, VALUES)))}
    for size in ("npts= 7, dt= .01 sec", "NPTS: 7, DT: 0.01", "Npts=7,Dt=.01 s"):
        assert read(at2(size).replace("UNITS", "units"))[0] == whole
    spaced = (
        csmip_channel(1, "90 DEG", WAVE)
        .replace("EQUALLY SPACED AT", "EQUALLY-SPACED  AT")
        .replace("/&", " /&")
    )
    assert read(spaced)[0] == {"x": pytest.approx(0.01 * abs(WAVE).max())}
    jma = "Site  Code= 1\nsampling rate= 100Hz\nunit = gal\nns,ew,ud\n1,2,3\n-1,2,3\n"
    assert read(jma)[0] == {"x": 0.01, "y": 0.02, "z": 0.03}
    knet = "#Sampling FREQ(Hz),100\n#offset(gal),0,0,0\n#datetime,relative time(s),ns,ew,ud\n"
    rows = "".join(f"2024/01/01 16:10:00,{i / 100},1,2,3\n" for i in range(3))
    assert read(knet + rows)[0] == {"x": 0.01, "y": 0.02, "z": 0.03}


def test_knet_headers_in_any_case(read):
    whole = knet()
    for spell in (
        str.lower,
        str.upper,
        str.title,
        lambda key: key.replace("Max. ", "Max ").replace("Long", "Lon"),
    ):
        lines = [spell(line[:18]).ljust(18) + line[18:] for line in whole.split("\n")[:17]]
        assert read("\n".join([*lines, *whole.split("\n")[17:]]))[0] == read(whole)[0]


END = "/&  ----------  End of data for channel  1  ----------\n"


@pytest.mark.parametrize(
    "end", [END, END.upper(), "End of data for channel 1\n", "End-of-data for Chan HNE acceleration\n"]
)
@pytest.mark.parametrize("kind", ["acceleration", "accel.", "uncor. accel.", "corrected acceleration"])
def test_cosmos_blocks_and_their_ends_in_the_spellings_in_use(read, end, kind):
    three = "".join(
        cosmos(i * WAVE, label=label, kind=kind, end=end)
        for i, label in enumerate(("1: 360 Deg", "2: 90 Deg", "3: HNZ00"), 1)
    )
    peaks, _ = read(three)
    assert peaks == {key: pytest.approx(0.01 * i * abs(WAVE).max()) for i, key in enumerate("xyz", 1)}


def test_raw_counts_of_cosmos_are_called_so(read):
    raw = cosmos(kind="raw accel. ", unit=" counts (50)", end=END)
    ended = raw.replace(END, "End-of-data for Chan  1 Raw acceleration counts\n")
    for text, unit in ((raw, None), (raw, "gal"), (ended, None)):
        error = refusal(read, text, unit=unit)
        assert "the unit 'counts', that of raw counts or volts of a recorder" in str(error)
        assert "収録器の生のカウント値" in error.told("ja")
    assert refusal(read, cosmos(kind="temperature", end=END)).code == "motion.header_line"


@pytest.mark.parametrize(
    "header",
    [
        "Quake of 2020\nTime (s),NS (gal),EW (gal),UD (gal)\n",
        "1968 quake of May\nStation: PLACE, 34.5 N 135.5 E\n\nDT = 0.02\nt,NS (gal),EW (gal),UD (gal)\n",
        "Time,NS,EW,UD\ns,gal,gal,gal\n",
        "Time,N-S,E-W,U-D\n[s],[cm/s/s],[cm/s/s],[cm/s/s]\n",
        '"Time","NS","EW","UD"\n"(sec)","(Gal)","(Gal)","(Gal)"\n',
        "地震の記録\n時間,南北,東西,上下\ns,ガル,ガル,ガル\n",
        "地震の記録\n時間,南北,東西,上下\n秒,gal,gal,gal\n",
    ],
)
def test_titles_and_a_row_of_units_around_headings(read, header):
    assert read(header + table(","))[0] == UP_LAST


def test_quoted_cells_are_read_and_decimal_commas_in_them_refused(read):
    quoted = "".join(",".join(f'"{value:.3f}"' for value in row) + "\n" for row in ROWS)
    assert read(f"t,x,y,z\n{quoted}", unit="gal")[0] == UP_LAST
    assert refusal(read, quoted.replace(".", ","), unit="gal").code in (
        "motion.column_count",
        "motion.not_a_decimal",
    )
    two = "".join(",".join(f'"{value:.3f}"' for value in row[:2]) + "\n" for row in ROWS).replace(".", ",")
    assert refusal(read, two, unit="gal").code == "motion.not_a_decimal"


@pytest.mark.parametrize("coding", ["utf-16", "utf-8-sig"])
def test_codings_of_spreadsheets(read, coding):
    text = "Time (s)\t南北 (gal)\tEW (gal)\tUD (gal)\r\n" + table("\t").replace("\n", "\r\n")
    assert read(text.encode(coding))[0] == UP_LAST


@pytest.mark.parametrize("line", ["41 0.02", "  41, 0.02", "0.02 41", "A quake\n41\t.02E0", "# x\n41 0.02"])
def test_the_number_of_samples_and_the_step_above_one_column(read, line):
    column = "".join(f"{row[1]:.3f}\n" for row in ROWS)
    assert read(f"{line}\n{column}", unit="gal")[0] == {"x": 0.1}
    error = refusal(read, f"{line}\n{column}", unit="gal", dt=0.01)
    assert error.code == "motion.another_time_step"
    assert refusal(read, f"{line.replace('41', '42')}\n{column}", unit="gal").code == "motion.not_as_stated"


def archive(*names) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as file:
        for name in names:
            file.writestr(name, "x")
    return data.getvalue()


SMC = "2 CORRECTED ACCELEROGRAM\n*\n" + "a text\n" * 9 + "         1         2         3\n" * 20
RENADIC = (
    "UNCORRECTED ACCELEROGRAM DATA  PROCESSED: 1/2/20\n" + "a text\n" * 6 + "UNIVERSIDAD DE CHILE - RENADIC\n"
)


@pytest.mark.parametrize(
    ("content", "english", "japanese"),
    [
        (archive("a.txt"), "compressed archive, which is to be unpacked", "圧縮ファイル（展開して"),
        (b"\x1f\x8b\x08\x00\x00", "compressed archive, which is to be unpacked", "圧縮ファイル（展開して"),
        (archive("[Content_Types].xml", "xl/workbook.xml"), "sheet can be saved as CSV", "CSV形式で保存"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\x00", "sheet can be saved as CSV", "表計算ソフトのファイル"),
        (b"\x00\x01\x02", "binary (other formats", "テキストでないファイル"),
        (SMC, "in the format USGS SMC, which is not read", "「USGS SMC」形式のファイルで"),
        (RENADIC + "1 2 3\n" * 9, "in the format RENADIC", "「RENADIC」形式のファイルで"),
        ("UNCORRECTED ACCELEROGRAM DATA\nX\n" + "1 2 3\n" * 9, "in the format CSMIP V1", "「CSMIP V1」"),
        (
            "Uncorrected accelerogram 1 GNS Science\n" + "1 2 3\n" * 9,
            "the format GeoNet",
            "「GeoNet V1A/V2A」",
        ),
        (
            "1993/01/15 20:06:08   3 100 15700 X: Y\n063-GL 1 2\n1 2 3\n",
            "in the format BRI .ac",
            "「BRI .ac」",
        ),
        ("<!DOCTYPE html>\n<p>1</p>\n", "in the format HTML", "「HTML」"),
    ],
)
def test_a_file_of_another_kind_is_called_what_it_is(read, content, english, japanese):
    error = refusal(read, content, unit="gal", dt=0.01)
    assert english in str(error)
    assert japanese in error.told("ja")


def test_columns_that_name_another_format_are_read(read):
    assert read("Taken from RENADIC\nt,acc\n" + table(",", 2), unit="gal")[0] == {"x": 0.1}
    assert refusal(read, "Taken from RENADIC\nt,acc\n" + table(",", 2)).code == "motion.no_unit"
