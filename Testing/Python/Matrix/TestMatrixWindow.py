# SPDX-License-Identifier: BSD-3-Clause
"""Row Window of the mirror matrix: viewports, layers, sizes, windows, samples, stereo, tiles."""

import mirror_matrix as mm
import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkProperty, vtkTextActor, vtkWindowToImageFilter

row = mm.Results("Window", __file__)
PLANE = wt.plane((0, 0, 0), (0, 0, 1))


def things(scene, color=(1, 0.6, 0.2)):
    scene.add_data(wt.sphere((0, 0, 0.4), 1.5), color, specular=0.6)
    scene.add_data(wt.box((2.4, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4), specular=0.6)
    wt.add_scene_light(scene.renderer, (2, -4, 5))


def expected_of(fill=things, **options):
    return mm.composed_picture(fill, mm.mirrored_picture(fill, **options), **options)


def control_of(fill=things, **options):
    return mm.composed_picture(fill, mm.mirrored_picture(mm.without_props(fill), **options), **options)


def seen_scene(fill=things, **options):
    """A scene with water, and the water."""
    scene = mm.Scene(mm.SEEN, **options)
    fill(scene)
    return scene, wt.add_water(scene.renderer, PLANE, mm.SHEET)


def compare(name, scene, water, seen, expected, control, **notes):
    pixels = mm.water_pixels(scene, water)
    water.VisibilityOff()
    without = scene.pixels()
    water.VisibilityOn()
    row.compare(name, seen, expected, without, pixels, control, **notes)


# Viewports and layers: every renderer is a scene in the window.
class Part(mm.Scene):
    """A scene in one viewport of another scene's window."""

    def __init__(self, whole, viewport, layer=0, background=(0.2, 0.3, 0.4)):
        self.__dict__.update(whole.__dict__)
        self.renderer = whole.add_renderer(background, viewport)
        self.renderer.SetLayer(layer)
        self.camera = self.renderer.GetActiveCamera()
        self.camera.DeepCopy(whole.camera)
        self.keep, self.when_mirrored = [], []


def viewports(kind, add=lambda part, index: None):
    """Two viewports with different scenes; add puts the water, or a sheet, into each."""
    whole = mm.Scene(kind)
    whole.window.RemoveRenderer(whole.renderer)
    parts = [Part(whole, (0, 0, 0.5, 1)), Part(whole, (0.5, 0.3, 1, 1), background=(0.6, 0.5, 0.4))]
    for index, part in enumerate(parts):
        things(part, ((1, 0.6, 0.2), (0.3, 0.5, 1))[index])
        part.camera.Azimuth(25 * index)
        added = add(part, index)
        if kind == mm.MIRRORED:
            mm.mirror(part)
        whole.keep += [part, added]
    return whole


def turned(picture):
    """Left and right changed in each of the viewports."""
    half, low = mm.SIZE[0] // 2, int(0.3 * mm.SIZE[1])
    result = picture.copy()
    result[:, :half] = picture[:, :half][:, ::-1]
    result[low:, half:] = picture[low:, half:][:, ::-1]
    return result


@row.makes("two viewports with different scenes")
def several_viewports():
    waters = []
    scene = viewports(mm.SEEN, lambda part, index: waters.append(wt.add_water(part.renderer, PLANE, mm.SHEET)))
    seen = scene.pixels()
    mirrored = turned(viewports(mm.MIRRORED).pixels())
    expected = viewports(mm.COMPOSED, lambda part, index: mm.add_sheet(part, mirrored)).pixels()
    blank = np.full_like(mirrored, 60)
    control = viewports(mm.COMPOSED, lambda part, index: mm.add_sheet(part, blank)).pixels()
    pixels = mm.water_pixels(scene, waters[0]) | mm.water_pixels(scene, waters[1])
    for water in waters:
        water.VisibilityOff()
    row.compare("two viewports with different scenes", seen, expected, scene.pixels(), pixels, control)


def layers(name, water_layer):
    """A scene in one layer, a ball in the other."""

    def make(kind, mirrored=None):
        whole = mm.Scene(kind, background=(0.5, 0.6, 0.8))
        whole.window.SetNumberOfLayers(2)
        over = Part(whole, (0, 0, 1, 1), layer=1)
        scenes = (whole, over)
        things(scenes[water_layer])
        other = scenes[1 - water_layer]
        other.add_data(wt.sphere((-2.2, -1, 1.4), 0.7), (0.4, 0.5, 1), cut=False)
        whole.keep.append(over)
        added = None
        if kind == mm.SEEN:
            added = wt.add_water(scenes[water_layer].renderer, PLANE, mm.SHEET)
        elif kind == mm.COMPOSED:
            mm.add_sheet(scenes[water_layer], mirrored)
        else:
            other.renderer.RemoveAllViewProps()
            mm.mirror(scenes[water_layer])
            if water_layer == 1:  # the rule: what a layer's water reflects is the layer's own background
                whole.renderer.SetBackground(over.renderer.GetBackground())
        return whole, added

    scene, water = make(mm.SEEN)
    seen = scene.pixels()
    mirrored = make(mm.MIRRORED)[0].pixels()[:, ::-1]
    expected = make(mm.COMPOSED, mirrored)[0].pixels()
    control = make(mm.COMPOSED, np.full_like(mirrored, 60))[0].pixels()
    compare(name, scene, water, seen, expected, control, reason=None if water_layer == 0 else
            "A transparent layer shows no background of its own in the picture, but its colour is reflected.")


row.register("two renderers in layers, water in the lower", layers, 0)
row.register("two renderers in layers, water in the upper", layers, 1)


# Sizes, windows, resources.
@row.makes("resize while running")
def resized():
    scene, water = seen_scene()
    scene.pixels()
    for number, size in enumerate(((301, 200), (160, 240))):
        scene.window.SetSize(*size)
        compare(f"resize while running, to {size[0]} x {size[1]}", scene, water, scene.pixels(),
                expected_of(size=size), control_of(size=size))


@row.makes("re-parenting to another window")
def moved_to_another_window():
    scene, water = seen_scene()
    scene.pixels()
    other = wt.View(mm.SIZE)
    other.window.RemoveRenderer(other.renderer)
    scene.window.RemoveRenderer(scene.renderer)
    other.window.AddRenderer(scene.renderer)
    scene.window, other.window = other.window, scene.window
    compare("re-parenting to another window", scene, water, scene.pixels(), expected_of(), control_of())


def from_the_left(scene):
    scene.camera.SetPosition(-4, -8, 3)
    things(scene)


def two_windows(name, shares_props):
    """What two windows show that look from elsewhere at the same props, or the same data, plane and look."""
    first, water = seen_scene()
    second = mm.Scene(mm.SEEN)
    second.camera.SetPosition(-4, -8, 3)
    wt.add_scene_light(second.renderer, (2, -4, 5))
    props = first.renderer.GetViewProps()
    for prop in [props.GetItemAsObject(i) for i in range(props.GetNumberOfItems())]:
        if not shares_props:
            other = type(prop)()
            other.ShallowCopy(prop)
            if prop is not water:
                other.SetMapper(type(prop.GetMapper())())
                other.GetMapper().ShallowCopy(prop.GetMapper())
            prop = other
        second.renderer.AddViewProp(prop)
    waters = (water, prop)
    frames = [[scene.pixels() for scene in (first, second)] for _ in range(3)]
    both = (first, frames[-1][0], things), (second, frames[-1][1], from_the_left)
    for number, (scene, seen, fill) in enumerate(both):
        compare(f"{name}, the {'second' if number else 'first'}", scene, waters[number], seen,
                expected_of(fill), control_of(fill))
    row.say(f"{name}: the first frame of each is the same",
            all((one == other).all() for one, other in zip(frames[0], frames[-1])))


row.register("two windows that share data", two_windows, False)
row.register("two windows that share props", two_windows, True)


def two_windows_of_vtk():
    """The same without any water, where VTK gets it wrong."""
    with wt.unheard():
        first, second = mm.Scene(mm.SEEN), mm.Scene(mm.SEEN)
        second.renderer.AddViewProp(first.add_data(wt.sphere((0, 0, 0.4), 1.5)))
        pictures = [[scene.pixels() for scene in (first, second)] for _ in range(2)][-1]
        del first, second  # VTK's errors, when they go
    is_blank = [(picture == picture[0, 0]).all() for picture in pictures]
    row.say("two windows that share props, without water: a prop is left out",
            any(is_blank) or (pictures[0] != pictures[1]).any(),
            reason="A defect of VTK 9.6: its EGL and OSMesa windows free each other's buffers in the middle of a "
                   "draw, and continue in the other's context, because their PopContext does nothing. With water "
                   "they are freed earlier.")


if mm.VTK_VERSION >= (9, 6):
    row.makes("two windows that share props, without water")(two_windows_of_vtk)


@row.makes("graphics resources released and made again")
def released():
    scene, water = seen_scene()
    scene.pixels()
    scene.renderer.ReleaseGraphicsResources(scene.window)
    compare("graphics resources released and made again", scene, water, scene.pixels(), expected_of(), control_of())


@row.makes("window finalized and made again")
def finalized():
    scene, water = seen_scene()
    scene.pixels()
    scene.window.Finalize()
    compare("window finalized and made again", scene, water, scene.pixels(), expected_of(), control_of())


def high_resolution(scene):
    things(scene)
    scene.window.SetDPI(192)
    if scene.kind != mm.MIRRORED:
        text = vtkTextActor()
        text.SetInput("high DPI")
        scene.renderer.AddViewProp(text)


row.cell("192 DPI", high_resolution)


# Samples. VTK's clipping planes drop whole pixels of the mirrored picture, not samples: its data is cut.
def cut_data():
    return [(wt.sphere((0, 0, 0.4), 1.5), (1, 0.6, 0.2)), (wt.box((2.4, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4))]


def samples(scene):
    wt.add_scene_light(scene.renderer, (2, -4, 5))
    for data, color in cut_data():
        if scene.kind == mm.MIRRORED:
            data = wt.mirror_image(wt.mirror_image(data, (0, 0, 0), (0, 0, 1)), (0, 0, 0), (0, 0, -1))
        scene.add_data(data, color, cut=False, specular=0.6)


row.cell("8 samples", samples, samples=8)


@row.makes("8 samples, the inside of what is cut")
def insides():
    """The inside of closed things that the water cuts must not be seen, but a look at the middle of a pixel does not
    know which of the samples are water's.

    Of a pixel that the water has a share c of, the mirrored view shows the inside in as many samples as the thing
    hides, 1 - c, and one more at most: the reflection texture's pattern of samples is turned left to right. The water
    shows that in c of the picture's pixel.
    """
    one_sample = 0.25  # Mesa's software renderer has four

    def picture(inside, color=None):
        scene = mm.Scene(mm.SEEN, samples=8)
        samples(scene)
        for i in range(len(cut_data())):
            back = vtkProperty()
            back.SetColor(inside)
            back.LightingOff()
            scene.renderer.GetViewProps().GetItemAsObject(i).SetBackfaceProperty(back)
        water = wt.add_water(scene.renderer, PLANE, mm.SHEET, 0.0 if color else 1.0)
        if color:
            water.GetWaterProperty().SetDeepColor(color)
        return scene.pixels()

    changed = np.abs(picture((0, 0, 0)) - picture((1, 1, 1))).max(axis=2)
    water = np.abs(picture((0, 0, 0), (1, 1, 1)) - picture((0, 0, 0), (0, 0, 0))).max(axis=2) / 255
    print(f"inside: {100 * (changed > 1).sum() / (water > 0).sum():.3f} % of the water's pixels depend on it, by at "
          f"most {changed.max()} of 255")
    wt.check_at_least("inside: pixels that depend on it", int((changed > 1).sum()), 20)
    reason = ("The water looks up its reflection at the centre of a pixel, once for all samples; the pixel of the "
              "reflection texture also contains the samples that the object hides.")
    shared = (water > 0) & (water < 1)
    beside = np.pad(shared, 1)
    near = np.any([beside[1 + i:beside.shape[0] - 1 + i, 1 + j:beside.shape[1] - 1 + j]
                   for i in (-1, 0, 1) for j in (-1, 0, 1)], axis=0)
    row.say("8 samples, the inside of what is cut: only pixels shared by a thing and the water, or next to these, "
            "depend on it",
            near[changed > 1].all(), reason=reason)
    row.say("8 samples, the inside of what is cut: changes a pixel by at most the water's share of it, times the share "
            "of hidden samples and one more, times the contrast",
            (changed <= 255 * water * (1 - water + one_sample) + 2).all(), reason=reason)


# Stereo: the mirror image of the left eye's view is a right eye's.
class CrystalEyesScene(mm.Scene):
    """A window of two buffers, of which one is looked at."""

    right = 0

    def pixels(self):
        self.window.Render()
        return self.shown(1, self.right)


def stereo(name, set_type, crystal_eye=None):
    """crystal_eye: which of a pair of buffers is looked at, 0 left, 1 right; None: there is one."""

    def make(kind, eye=None):
        scene = mm.Scene(kind) if eye or crystal_eye is None else CrystalEyesScene(kind)
        scene.right = crystal_eye
        scene.window.SetStereoCapableWindow(crystal_eye is not None and not eye)
        things(scene)
        scene.camera.SetEyeAngle(3)
        scene.window.StereoRenderOn()
        if eye:
            getattr(scene.window, "SetStereoTypeTo" + eye)()
        else:
            set_type(scene.window)
        return scene

    mirrored = {}
    for eye, other in (("Left", "Right"), ("Right", "Left")):
        scene = make(mm.MIRRORED, other)
        mm.mirror(scene)
        mirrored[eye] = scene.pixels()[:, ::-1]
    scene = make(mm.SEEN)
    water = wt.add_water(scene.renderer, PLANE, mm.SHEET)
    seen = scene.pixels()

    def composed(pictures):
        scene = make(mm.COMPOSED)
        sheets = {eye: mm.add_sheet(scene, pictures[eye]) for eye in pictures}

        def choose(renderer, event):
            is_left = bool(scene.camera.GetLeftEye())
            sheets["Left"].SetVisibility(is_left)
            sheets["Right"].SetVisibility(not is_left)

        scene.renderer.AddObserver("StartEvent", choose)
        return scene.pixels()

    compare(name, scene, water, seen, composed(mirrored),
            composed({"Left": mirrored["Right"], "Right": mirrored["Left"]}))


row.register("stereo, left eye", stereo, lambda window: window.SetStereoTypeToLeft())
row.register("stereo, right eye", stereo, lambda window: window.SetStereoTypeToRight())
row.register("stereo, anaglyph", stereo, lambda window: window.SetStereoTypeToAnaglyph())
row.register("stereo, interlaced", stereo, lambda window: window.SetStereoTypeToInterlaced())
row.register("stereo, side by side", stereo, lambda window: window.SetStereoTypeToSplitViewportHorizontal())
row.register("stereo, crystal eyes, the left buffer", stereo, lambda window: window.SetStereoTypeToCrystalEyes(), 0)
row.register("stereo, crystal eyes, the right buffer", stereo, lambda window: window.SetStereoTypeToCrystalEyes(), 1)


# Tiles: the picture in four by four pieces is the picture rendered large.
@row.makes("tiles, scale 4")
def tiled():
    large = (4 * mm.SIZE[0], 4 * mm.SIZE[1])
    scene, water = seen_scene()

    def capture():
        tiles = vtkWindowToImageFilter()
        tiles.SetInput(scene.window)
        tiles.SetScale(4)
        tiles.SetInputBufferTypeToRGB()
        tiles.ReadFrontBufferOff()
        tiles.Update()
        return vtk_to_numpy(tiles.GetOutput().GetPointData().GetScalars()).reshape(large[1], large[0], 3).astype(int)

    seen = capture()
    big, big_water = seen_scene(size=large)
    pixels = mm.water_pixels(big, big_water)
    row.compare("tiles, scale 4", seen, expected_of(size=large), None, pixels, control_of(size=large))


test_cell = row.test()
