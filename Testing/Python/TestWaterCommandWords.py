# SPDX-License-Identifier: BSD-3-Clause
"""The command's options say the look by the same words as add_water; each arrives in the water, and is checked."""

import re

import numpy as np
import pytest
import water_test as wt
from command_runs import Commands
from PIL import Image
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkwater import command, vtkWaterProperty
from vtkwater.scenes import Scene
from vtkwater.words import QUALITIES, set_look

SIZE = (120, 80)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("words")
    source, writer = vtkCubeSource(), vtkSTLWriter()
    source.SetBounds(-1, 1, -1, 1, -0.6, 1)
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(str(made / "box.stl"))
    writer.Write()
    return made


COMMANDS = Commands()


def run(folder, *options):
    """Exit status, all that was said, and the picture if there is one."""
    out = folder / "box.png"
    out.unlink(missing_ok=True)
    status, said = COMMANDS.run(folder, "render", "box.stl", "--level", 0, "--size", f"{SIZE[0]}x{SIZE[1]}", "--out",
                                out.name, *options)
    picture = np.asarray(Image.open(out)).astype(int)[:, :, :3] if out.exists() else None
    return status, said, picture


def look_of(*options):
    """The look that a command line says."""
    arguments = command.make_parser().parse_args(["render", "box.stl", "--level", "0", *map(str, options)])
    look = vtkWaterProperty()
    set_look(look, **command.words_of(arguments))
    return look


def state_of(look):
    """All that the words set."""
    waves = []
    for i in range(look.GetNumberOfWaves()):
        wave = [0.0] * 5
        look.GetWave(i, wave)
        waves.append([round(part, 9) for part in wave])
    return (
        look.GetSea(),
        look.GetWindSpeed(),
        look.GetWindDirection(),
        waves,
        look.GetRefraction(),
        look.GetRefractionSource(),
        look.GetFoamDepth(),
        look.GetCaustics(),
        [round(part, 9) for part in look.GetDeepColor()],
        look.GetOpacity(),
        look.GetMetresPerUnit(),
        look.GetIndexOfRefraction(),
        look.GetAbsorption(),
        look.GetDomePortRadius(),
        look.GetRayTraceSteps(),
        look.GetRayTraceProbes(),
        look.GetRayTraceRays(),
        look.GetRayTraceLayers(),
        look.GetRayTraceFootprint(),
    )


OPTIONS = {  # the options, the same by words
    "nothing": ((), {}),
    "preset": (("--preset", "clear tropical"), {"preset": "clear tropical"}),
    "wind": (("--wind", 7), {"wind": 7.0}),
    "no wind": (("--preset", "lake", "--wind", 0), {"preset": "lake", "wind": 0.0}),
    "whitecaps": (("--wind", 9, "--whitecaps"), {"wind": 9.0, "whitecaps": True}),
    "whitecaps of 2 s": (("--wind", 9, "--whitecaps", 2), {"wind": 9.0, "whitecaps": 2.0}),
    "direction": (("--wind", 7, "--wind-direction", 40), {"wind": (7.0, 40.0)}),
    "waves": (
        ("--waves", "0.1,2", "--waves", "0.05,1.5,30,10,0.5"),
        {"waves": [(0.1, 2.0), (0.05, 1.5, 30.0, 10.0, 0.5)]},
    ),
    "color name": (("--color", "navy"), {"color": (0.0, 0.0, 128 / 255)}),
    "color number": (("--color", "#ff8000"), {"color": (1.0, 128 / 255, 0.0)}),
    "opacity": (("--opacity", 0.5), {"opacity": 0.5}),
    "refraction": (("--refraction",), {"refraction": True}),
    "no refraction": (("--preset", "lake", "--no-refraction"), {"preset": "lake", "refraction": False}),
    "own view": (("--own-view",), {"own_view": True}),
    "foam": (("--foam",), {"foam": True}),
    "foam depth": (("--foam", 0.4), {"foam": 0.4}),
    "caustics": (("--wind", 3, "--caustics"), {"wind": 3.0, "caustics": True}),
    "dome port": (("--dome-port", 0.3), {"dome_port": 0.3}),
    "shadows": (("--wind", 6, "--shadows"), {"wind": 6.0, "shadows": True}),
    "caustics strength": (("--wind", 3, "--caustics", 0.4), {"wind": 3.0, "caustics": 0.4}),
    **{f"quality {name}": (("--quality", name), {"quality": name}) for name in QUALITIES},
    "units": (("--units", "km"), {"units": "km"}),
    "units of 3 m": (("--units", 3), {"units": 3.0}),
    "automatic units": (("--units", "automatic"), {"units": "automatic"}),
}


@pytest.mark.parametrize("name", OPTIONS, ids=lambda name: name.replace(" ", "_"))
def test_an_option_is_a_word(name):
    """An option of the command does what the word of the same name does, and does something."""
    options, words = OPTIONS[name]
    look = vtkWaterProperty()
    set_look(look, **words)
    wt.check_equal(f"{options}", state_of(look_of(*options)), state_of(look))
    without = vtkWaterProperty()
    set_look(without)
    if words not in ({}, {"quality": "default"}, {"refraction": True}, {"units": "automatic"}):
        wt.check_equal("as without it", state_of(look) == state_of(without), False)


SETS = [  # the words, what the look then has
    ({"wind": (7.0, 40.0)}, {"Sea": True, "WindSpeed": 7.0, "WindDirection": 40.0}),
    ({"wind": 0, "preset": "pool"}, {"Sea": False, "NumberOfWaves": 0, "Refraction": True}),
    ({"waves": [(0.1, 2.0)], "preset": "lake"}, {"Sea": False, "NumberOfWaves": 1}),
    ({"wind": 9, "whitecaps": True}, {"Whitecaps": True, "WhitecapLifeTime": 3.5}),
    ({"wind": 9, "whitecaps": 1.5}, {"Whitecaps": True, "WhitecapLifeTime": 1.5}),
    ({"color": (0.1, 0.2, 0.3), "preset": "lake"}, {"DeepColor": (0.1, 0.2, 0.3)}),
    ({"opacity": 0.5}, {"Opacity": 0.5}),
    ({"refraction": False, "preset": "lake"}, {"Refraction": False}),
    ({"own_view": True, "color": (0.1, 0.2, 0.3)}, {"RefractionSource": 1, "Refraction": True}),
    ({"foam": True}, {"FoamDepth": 0.25, "FoamFitsScene": True, "Refraction": True}),
    ({"foam": 0.5}, {"FoamDepth": 0.5, "FoamFitsScene": False, "Refraction": True}),
    ({"foam": False}, {"FoamDepth": 0.0, "Refraction": True}),
    ({}, {"Refraction": True, "MetresPerUnit": 0.0}),
    ({"preset": "mirror floor"}, {"Refraction": False}),
    ({"color": (0.1, 0.2, 0.3)}, {"Refraction": False}),
    ({"opacity": 0.5}, {"Refraction": False}),
    ({"opacity": 0.5, "preset": "lake"}, {"Refraction": True}),
    ({"waves": 5.0}, {"MetresPerUnit": 0.0}),
    ({"waves": [(0.1, 2.0)]}, {"MetresPerUnit": 1.0}),
    ({"waves": [(0.1, 2.0)], "units": "automatic"}, {"MetresPerUnit": 0.0}),
    ({"units": "ft"}, {"MetresPerUnit": 0.3048}),
    ({"units": 2}, {"MetresPerUnit": 2.0}),
    ({"caustics": True, "wind": 3}, {"Caustics": 0.8, "Refraction": True}),
    ({"dome_port": 0.3, "preset": "lake"}, {"DomePortRadius": 0.3, "Refraction": True}),
    ({"shadows": True}, {"Shadows": True}),
    ({"caustics": 0.4, "wind": 3}, {"Caustics": 0.4, "Refraction": True}),
    ({"quality": "fast"}, {"RayTraceSteps": 8, "RayTraceProbes": 3}),
]


@pytest.mark.parametrize("words, wanted", SETS, ids=lambda value: re.sub(r"\W+", "_", str(value)))
def test_a_word_sets_what_it_names(words, wanted):
    """A word sets what it names, and what that wants."""
    look = vtkWaterProperty()
    set_look(look, **words)
    wt.check_equal(f"{words}", {name: getattr(look, f"Get{name}")() for name in wanted}, wanted)


def test_the_words_are_in_the_picture(folder):
    """The command's picture is that of a scene with the same words, and differs from that without them."""
    options = (
        "--preset",
        "clear tropical",
        "--wind",
        3,
        "--wind-direction",
        30,
        "--foam",
        "--caustics",
        0.5,
        "--color",
        "#204060",
        "--quality",
        "high",
        "--sun",
        30,
    )
    status, said, picture = run(folder, *options)
    wt.check_equal(f"status; said {said.strip()}", status, 0)
    Image.fromarray(picture.astype(np.uint8)).save(wt.output_folder() / "CommandWords.png")
    plain = run(folder, "--sun", 30)[2]
    wt.check_at_least("pixels unlike those without", int((np.abs(picture - plain).max(axis=2) > 10).sum()), 2000)
    from vtkwater import readers

    scene = Scene(SIZE)
    scene.set_sun(30.0, 35.0)
    scene.add_ground(readers.read(folder / "box.stl"), 0.0)
    scene.add_water(0.0, "clear tropical", (3.0, 30.0), foam=True, caustics=0.5, color=(32 / 255, 64 / 255, 96 / 255),
                    quality="high", units="automatic")
    scene.make_island()
    scene.look(200.0, 8.0)
    scene.write(folder / "scene.png")
    shown = np.asarray(Image.open(folder / "scene.png")).astype(int)[:, :, :3]
    wt.check_equal("difference to the scene's", wt.difference(picture, shown), 0)


WRONG = [  # a part of the last line, the options
    ("--wind-direction is 30, but there is no --wind", ("--wind-direction", 30)),
    ("waves and wind are both given", ("--wind", 3, "--waves", "0.1,2")),
    ("foam is True, but refraction is False", ("--foam", "--no-refraction")),
    ("caustics is 0.5, but the water is calm", ("--caustics", 0.5)),
    ("refraction is True, but opacity is 0.5", ("--refraction", "--opacity", 0.5)),
    ("2 must lie in [0, 1]", ("--caustics", 2)),
    ("-1 must lie in [0,", ("--dome-port", -1)),
    ("dome_port is 0.3, but refraction is False", ("--dome-port", 0.3, "--no-refraction")),
    ("-1 must lie in [0, 1e+09]", ("--foam", -1)),
    ("1.5 must lie in [0, 1]", ("--opacity", 1.5)),
    ("'ultra'", ("--quality", "ultra")),
    ("'blurple' is not a colour", ("--color", "blurple")),
    ("'#12' is not a colour", ("--color", "#12")),
    ("must have 2 to 5 numbers", ("--waves", "0.1")),
    ("'long' is not a number", ("--waves", "0.1,long")),
    ("Wavelength must be finite", ("--waves", "0.1,0")),
    ("400 must lie in [-360, 360]", ("--wind", 3, "--wind-direction", 400)),
]


@pytest.mark.parametrize("words, options", WRONG, ids=[re.sub(r"\W+", "_", words) for words, _ in WRONG])
def test_a_wrong_option_is_a_wrong_use(words, options, capsys):
    """A wrong option, or two that contradict each other, are a wrong use that the last line tells of."""
    try:
        status = command.main(["render", "box.stl", "--level", "0", *map(str, options)])
    except SystemExit as end:
        status = end.code
    said = capsys.readouterr().err.strip().splitlines()[-1]
    wt.check_equal(f"{options}: '{said}'", (status, words in said), (2, True))


def test_help_names_every_word(capsys):
    """The help of render and of animate names every option of the look."""
    for name in ("render", "animate"):
        try:
            command.main([name, "--help"])
        except SystemExit:
            pass
        said = capsys.readouterr().out
        words = ("--preset", "--wind", "--wind-direction", "--waves", "--color", "--opacity", "--refraction", "--foam",
                 "--caustics", "--sun", "--quality")
        wt.check_equal(f"{name}: not in its help", [word for word in words if word not in said], [])


WRONG_WORDS = [  # the exception, parts of its text, the words
    (ValueError, ("caustics is 1.5", "[0, 1]"), {"caustics": 1.5}),
    (TypeError, ("color must be a sequence", "str"), {"color": "navy"}),
    (ValueError, ("DeepColor is (2, 0, 0)", "[0, 1]"), {"color": (2, 0, 0)}),
    (ValueError, ("waves and wind",), {"waves": 0, "wind": 0}),
    (ValueError, ("opacity is 7", "[0, 1]"), {"opacity": 7}),
    (TypeError, ("preset must be str",), {"preset": 3}),
    (ValueError, ("'swamp'", "pool, lake"), {"preset": "swamp"}),
]


@pytest.mark.parametrize(
    "kind, texts, words", WRONG_WORDS, ids=[texts[0].replace(" ", "_") for _, texts, _ in WRONG_WORDS]
)
def test_a_wrong_word_raises(kind, texts, words):
    """A wrong word raises an error that names it and what is accepted."""
    raised = None
    try:
        set_look(vtkWaterProperty(), **words)
    except (TypeError, ValueError) as error:
        raised = error
    wt.check_equal(
        f"{words}: {raised}", (type(raised), [text for text in texts if text not in str(raised)]), (kind, [])
    )


def test_words_that_are_not_said_change_nothing():
    """Without a word only what has a default of its own is set: refraction, and automatic units."""
    look = vtkWaterProperty()
    look.SetPreset("pool")
    look.SetCaustics(0.3)
    look.SetUnits("automatic")
    look.RefractionOn()
    before = look.GetMTime()
    set_look(look)
    wt.check_equal("modified", look.GetMTime() > before, False)


def test_the_sky_is_clear_or_a_gradient(folder):
    """--sky shows a clear sky in place of the gradient, of its turbidity, and refuses air that is none."""
    pictures = []
    for options in ((), ("--sky",), ("--sky", "8")):
        status, said, picture = run(folder, *options)
        wt.check_equal(f"{options}: exit status", (status, said.count("error")), (0, 0))
        pictures.append(picture[:20])
    wt.check_at_least("clear sky against the gradient", wt.difference(pictures[0], pictures[1]), 10)
    wt.check_at_least("haze against clear air", wt.difference(pictures[1], pictures[2]), 10)
    status, said, picture = run(folder, "--sky", "1")
    wt.check_equal("turbidity 1: exit status, picture", (status, picture), (2, None))
    for word in ("--sky", "1", "2", "10"):
        wt.check_equal(f"turbidity 1: the error says '{word}'", word in said, True)


@pytest.mark.parametrize("option, said", (
    ("--levl", "--levl is not an option; did you mean --level?; see vtkwater render --help"),
    ("--lev", "--lev is not an option; did you mean --level?; see vtkwater render --help"),  # no abbreviations
    ("--zzzzzz", "--zzzzzz is not an option; see vtkwater render --help")))
def test_an_option_that_is_none_is_told_in_a_line(option, said, capsys):
    with pytest.raises(SystemExit):
        command.make_parser().parse_args(["render", "box.stl", option, "1"])
    wt.check_equal("all that is said", capsys.readouterr().err.strip(), f"vtkwater render: error: {said}")
