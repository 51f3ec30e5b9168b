# SPDX-License-Identifier: BSD-3-Clause
"""Where the bed under clear water ends: with the water it goes on, in open water it does not; and multisampling mixes
nothing into what is seen through the surface."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkDiskSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper

SIZE = (240, 180)
VIEWS = {"above": (3, -9, 9), "middle": (6, -9, 5), "low": (-4, -12, 1.5)}
WHITE = (1.0, 1.0, 1.0)


def clear_water(view, sheet):
    water = wt.add_water(view.renderer, None, sheet, None)
    look = water.GetWaterProperty()
    look.RefractionOn()
    look.SetAbsorption(0.4, 0.15, 0.1)
    look.SetScattering(0.01, 0.02, 0.03)
    look.SetShoreSoftness(0.0)
    return water


def over_a_bed(position, bed, samples=0, waves=()):
    """Water of 8 m x 8 m over a level bed of another width, striped across."""
    view = wt.View(SIZE, WHITE, samples)
    for stripe in range(-20, 20):
        low, high = max(stripe, -bed), min(stripe + 1, bed)
        if low < high:
            actor = wt.add_actor(view.renderer, wt.box((0.5 * (low + high), 0, -1.6), (high - low, 2 * bed, 0.2)),
                                 (0.5, 0.3, 0.2) if stripe % 2 else (0.4, 0.25, 0.15))
            actor.GetProperty().LightingOff()
    water = clear_water(view, (-4, 4, -4, 4))
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    wt.place_camera(view.renderer, position, (0, 0, 0), (0.5, 60))
    return view, water


@pytest.mark.parametrize("is_software", (1, 0))
@pytest.mark.parametrize("name", VIEWS)
def test_a_bed_that_ends_with_the_water_goes_on(name, is_software, monkeypatch):
    """Nearly all of the water shows what it shows over a bed without an end: no rim of deep water at its borders."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    ended, water = over_a_bed(VIEWS[name], 4)
    endless, _ = over_a_bed(VIEWS[name], 20)
    mask = wt.water_mask(ended, water)
    off = np.abs(ended.picture() - endless.picture()).max(axis=2)
    wt.check_at_least("% of the pixels are water", 100 * mask.mean(), 3)
    # stripes go on as the one at the border
    wt.check_at_most("% of them that differ by more than 30 of 255", 100 * float((off[mask] > 30).mean()), 0.5)


@pytest.mark.parametrize("is_software", (1, 0))
@pytest.mark.parametrize("name, samples, most", (("low", 0, 5), ("low", 4, 0), ("middle", 4, 20), ("above", 0, 100)))
def test_waves_show_no_dots_of_deep_water_where_the_bed_ends(name, samples, most, is_software, monkeypatch):
    """Deep water is blue, the bed is not: with waves, hardly a pixel is blue near the edge of a bed that ends with the
    water, and where the ray leaves the picture."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    view, water = over_a_bed(VIEWS[name], 4, samples, ((0.03, 0.9, 20.0), (0.02, 0.5, 75.0)))
    picture = view.picture()
    blue = wt.water_mask(view, water) & (picture[..., 2] > picture[..., 0] + 10)
    wt.check_at_most("blue pixels", int(blue.sum()), most)


@pytest.mark.parametrize("is_software", (1, 0))
def test_open_water_has_no_bed_that_goes_on(is_software, monkeypatch):
    """Rocks under the border of open water are seen where they are, and nowhere else: as much of the picture is rock."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))

    def rocks(sheet):
        view = wt.View(SIZE, WHITE)
        for place in ((0, 0), (3, 2), (-3, 3), (2.5, -2.8)):
            rock = wt.add_actor(view.renderer, wt.sphere((*place, -0.4), 0.8), (0.9, 0.2, 0.1))
            rock.GetProperty().LightingOff()
        clear_water(view, sheet)
        wt.place_camera(view.renderer, VIEWS["above"], (0, 0, 0), (0.5, 60))
        picture = view.picture()
        return picture[..., 0] > picture[..., 2] + 20
    bounded, wide = rocks((-4.2, 4.2, -4.2, 4.2)), rocks((-20, 20, -20, 20))
    wt.check_at_least("pixels of rock", int(wide.sum()), 200)
    wt.check_at_most("pixels of rock where there is none", int((bounded & ~wide).sum()), 0)


def endless_over(actors, rows):
    """Clear water without an end. rows: how many of 180 the window has, from the top."""
    view = wt.View((240, rows), WHITE)
    for data, color in actors:
        wt.add_actor(view.renderer, data, color).GetProperty().LightingOff()
    clear_water(view, (-1, 1, -1, 1)).SetSheetToHorizon()
    # the picture's upper part: the same pixels, by a camera that looks at another place of its window
    wt.place_camera(view.renderer, (0.6, -6.0, 0.9), (0, 0, 0), (0.05, 200))
    camera = view.renderer.GetActiveCamera()
    tangent = np.tan(np.radians(15.0))
    camera.SetViewAngle(2 * np.degrees(np.arctan(tangent * rows / 180)))
    camera.SetWindowCenter(0.0, 180 / rows - 1.0)
    return view


@pytest.mark.parametrize("is_software", (1, 0))
def test_what_the_pictures_border_cuts_is_not_drawn_out(is_software, monkeypatch):
    """A pyramid whose foot the picture's border cuts ends where it ends in a larger picture: what a ray passes before
    it leaves the picture is not what it meets."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    pyramid = [(wt.pyramid((0, 0, -0.3), 2.4, radius=1.2), (0.9, 0.5, 0.1))]
    cut, whole = (endless_over(pyramid, rows).picture() for rows in (180, 260))
    orange = [picture[..., 0] > picture[..., 2] + 60 for picture in (cut, whole[-180:])]
    wt.check_at_least("pixels of it in the larger picture", int(orange[1].sum()), 1000)
    wt.check_at_least("of them under the water", int(orange[1][:90].sum()), 100)
    more = orange[0] & ~orange[1]
    wt.check_at_most("% of the pixels that only the smaller one has", 100 * float(more.mean()), 1.0)


@pytest.mark.parametrize("is_software", (1, 0))
def test_a_floor_goes_on_beyond_the_pictures_border(is_software, monkeypatch):
    """Where a level floor fills the picture's lower border, no water there is deep."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    floor = [(wt.box((0, 0, -1.1), (60, 60, 0.2)), (0.9, 0.5, 0.1))]
    picture = endless_over(floor, 120).picture()
    is_floor = picture[:20, :, 0] > picture[:20, :, 2] + 30
    wt.check_at_least("% of the lower rows that are the floor", 100 * float(is_floor.mean()), 99.9)


@pytest.mark.parametrize("samples", (2, 4, 8))
@pytest.mark.parametrize("is_software", (1, 0))
def test_multisampling_brings_no_fringe(samples, is_software, monkeypatch):
    """White behind a dark bed's edge does not shine into the water: no pixel within it is brighter than all near it
    are without multisampling."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    once, water = over_a_bed(VIEWS["middle"], 4)
    mask = wt.water_mask(once, water)
    single = once.picture().max(axis=2)
    several, _ = over_a_bed(VIEWS["middle"], 4, samples)
    picture = several.picture().max(axis=2)
    inside = mask.copy()
    brightest = single.copy()
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            inside &= np.roll(mask, (dy, dx), (0, 1))
            brightest = np.maximum(brightest, np.roll(single, (dy, dx), (0, 1)))
    fringe = inside & (picture > brightest + 12)
    wt.check_at_least("pixels within the water", int(inside.sum()), 2000)
    wt.check_at_most("brighter than all near them", int(fringe.sum()), 0)


@pytest.mark.parametrize("samples", (0, 4))
@pytest.mark.parametrize("is_software", (1, 0))
def test_a_face_seen_at_its_edge_shows_no_background(samples, is_software, monkeypatch):
    """A cone's hidden face, which refraction turns to the eye, is seen in the pixels of its edge. The white background
    beside them is in none of the water's pixels."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    view = wt.View((320, 240), WHITE, samples)
    cone = vtkConeSource()
    cone.SetDirection(0.0, 0.0, 1.0)
    cone.Update()
    wt.add_actor(view.renderer, cone.GetOutput(), (1.0, 0.55, 0.0))
    water = clear_water(view, (-1, 1, -1, 1))
    water.SetSheetToHorizon()
    water.SetLevel(-0.2)
    water.GetWaterProperty().SetDeepColor(0.02, 0.1, 0.4)
    wt.place_camera(view.renderer, (1.0, -1.33, 2.89), (0, 0, 0), (1, 10))
    picture = view.picture().astype(float)
    is_near = np.zeros(picture.shape[:2], bool)  # the cone, and what is beside it
    is_near[80:180, 100:220] = True
    grey = is_near & (picture.min(axis=2) > 115)
    wt.check_at_least("pixels of the cone", int((is_near & (picture[..., 0] > picture[..., 2] + 60)).sum()), 2000)
    wt.check_at_most("whitish pixels beside it", int(grey.sum()), 0)


@pytest.mark.parametrize("samples", (0, 4))
@pytest.mark.parametrize("is_software", (1, 0))
def test_thin_things_over_the_water_are_seen_once(samples, is_software, monkeypatch):
    """Rays that pass behind thin black rings over the water meet the bed on their other side. No dots or arcs of
    the rings' colour are beside them."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    view = wt.View(SIZE, WHITE, samples)
    wt.add_actor(view.renderer, wt.box((0, 0, -0.9), (30, 30, 0.02)), (0.8, 0.8, 0.7)).GetProperty().LightingOff()
    for number in range(6):
        ring = vtkDiskSource()
        ring.SetInnerRadius(0.3 + 0.04 * number)
        ring.SetOuterRadius(0.3 + 0.04 * number + 0.05)
        ring.SetCircumferentialResolution(48)
        ring.Update()
        middle = (1.3 * (number % 3 - 1), 1.4 * (number // 3) - 0.7, 0)
        actor = wt.add_actor(view.renderer, wt.moved(ring.GetOutput(), middle), (0, 0, 0))
        actor.SetOrigin(*middle)
        actor.RotateX(60)
        actor.SetPosition(0, 0, 0.6)
        actor.GetProperty().LightingOff()
    water = clear_water(view, (-10, 10, -10, 10))
    wt.place_camera(view.renderer, (0, -7, 6), (0, 0, 0), (0.5, 60))
    picture = view.picture()
    water.VisibilityOff()
    dry = view.picture()
    of_rings = dry.min(axis=2) < 170
    near = of_rings.copy()
    for dy, dx in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        near |= np.roll(of_rings, (dy, dx), (0, 1))
    wt.check_at_least("pixels of the rings", int(of_rings.sum()), 500)
    wt.save(picture, wt.output_folder() / f"rings_{samples}_{is_software}.png")
    wt.check_at_most("dark pixels beside them", int((~near & (picture.max(axis=2) < 90)).sum()), 0)


@pytest.mark.parametrize("is_software", (1, 0))
def test_behind_an_object_the_bed_goes_on(is_software, monkeypatch):
    """A ball hides what the rays behind it would meet. The water there shows the bed beside the ball: few pixels of it
    have another colour than without the ball."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    view = wt.View(SIZE, WHITE)
    wt.add_actor(view.renderer, wt.box((0, 0, -0.9), (5, 5, 0.02)), (0.8, 0.8, 0.7))
    water = clear_water(view, None)
    water.SetSheetToAutomatic()
    wt.place_camera(view.renderer, (0, -9, 4), (0, 0, 0), (0.5, 60))
    empty = view.picture()
    water.VisibilityOff()
    dry = view.picture()
    mask = np.abs(empty - dry).max(axis=2) > 3
    wt.add_actor(view.renderer, wt.sphere((0, 0, 0.1), 0.6), (0.9, 0.7, 0.0))
    ball = np.abs(view.picture() - dry).max(axis=2) > 0
    water.VisibilityOn()
    rows, columns = np.nonzero(ball)
    behind = mask & ~ball  # beyond the ball's middle, in the columns that it takes
    behind[: int(rows.mean())] = False
    behind[:, : columns.min()] = behind[:, columns.max() + 1 :] = False
    wt.check_at_least("pixels behind the ball", int(behind.sum()), 300)
    off = np.abs(view.picture() - empty).max(axis=2)[behind]
    wt.check_at_most("% of them that differ by more than 20 of 255", 100 * float((off > 20).mean()), 5)


def add_chequered_bed(view):
    """A bed of light and dark tiles, 2 m wide, at a depth of 2 m."""
    for column in range(-12, 12):
        for row in range(-12, 12):
            shade = (0.9, 0.9, 0.8) if (column + row) % 2 else (0.3, 0.3, 0.3)
            tile = wt.add_actor(view.renderer, wt.box((2 * column + 1, 2 * row + 1, -2.05), (2, 2, 0.1)), shade)
            tile.GetProperty().LightingOff()


@pytest.mark.parametrize("is_software", (1, 0))
def test_no_comb_stands_behind_an_object(is_software, monkeypatch):
    """Where an object hides the bed, rows of pixels show the same edge of the object's outline: no row differs from both of
    its neighbours."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    view = wt.View(SIZE, WHITE)
    add_chequered_bed(view)
    post = wt.add_actor(view.renderer, wt.box((0.3, 0, 0), (1.8, 1.8, 4.2)), (0.9, 0.0, 0.0))
    post.GetProperty().LightingOff()
    clear_water(view, (-24, 24, -24, 24))
    camera = wt.place_camera(view.renderer, (2.5, -18, 9), (0.5, 1.5, 0.8), (0.5, 90))
    camera.SetViewAngle(24)
    picture = view.picture()
    wt.save(picture, wt.output_folder() / f"comb_{is_software}.png")
    rows, columns = np.nonzero((picture[:, :, 0] > 200) & (picture[:, :, 1] < 60))
    over = picture[rows.max() + 1:rows.max() + 16, columns.min():columns.max() + 1, 1]
    is_tooth = np.minimum(abs(over[1:-1] - over[2:]), abs(over[1:-1] - over[:-2])) > 10
    wt.check_equal("pixels behind the post that differ from what is over and under them", int(is_tooth.sum()), 0)


def test_no_bars_stand_at_the_pictures_lower_border(monkeypatch):
    """Rays that leave the picture at its lower border see a bed that fades to its mean: the colours of the last row that
    is seen do not go on as bars with hard edges. In software: on a GPU this would take a tenth of the surface's time."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "1")
    view = wt.View(SIZE, WHITE)
    add_chequered_bed(view)
    clear_water(view, (-24, 24, -24, 24))
    camera = wt.place_camera(view.renderer, (2.5, -18, 4), (0.5, 1.5, 0.0), (0.5, 90))
    camera.SetViewAngle(24)
    picture = view.picture().astype(int)
    wt.save(picture.astype(np.uint8), wt.output_folder() / "bars.png")
    # of the rows that show the bed, one in the middle and the lowest
    edges = [int((np.abs(np.diff(picture[row, :, 1])) > 30).sum()) for row in (SIZE[1] // 4, 0)]
    wt.check_at_least("hard edges in a row that is seen", edges[0], 3)
    wt.check_at_most("hard edges in the lowest row", edges[1], 0)


def pool_with(is_empty, eye):
    """A view of a pool of 12 m x 6 m whose walls are darker than its floor, with a post near one end or without."""
    view = wt.View((320, 240), WHITE)
    for middle, size, color in (((0, 0, -2.1), (12.0, 6.0, 0.2), (0.8, 0.9, 0.9)),
                                ((0, 3.1, -0.95), (12.4, 0.2, 2.5), (0.3, 0.3, 0.3)),
                                ((0, -3.1, -0.95), (12.4, 0.2, 2.5), (0.3, 0.3, 0.3)),
                                ((6.1, 0, -0.95), (0.2, 6.0, 2.5), (0.3, 0.3, 0.3)),
                                ((-6.1, 0, -0.95), (0.2, 6.0, 2.5), (0.3, 0.3, 0.3))):
        wt.add_actor(view.renderer, wt.box(middle, size), color).GetProperty().LightingOff()
    if not is_empty:
        post = wt.add_actor(view.renderer, wt.box((-3, 0, -0.75), (0.5, 0.5, 2.5)), (0.9, 0.7, 0.0))
        post.GetProperty().LightingOff()
    water = clear_water(view, None)
    water.SetSheetToAutomatic()
    wt.place_camera(view.renderer, eye, (-3, 0, -0.5), (0.5, 60))
    return view, water


@pytest.mark.parametrize("is_software", (1, 0))
@pytest.mark.parametrize("eye", ((10, 10, 11), (8, 5, 8), (6, -6, 8)), ids=str)
def test_behind_a_post_the_floor_goes_on(eye, is_software, monkeypatch):
    """A post hides the floor behind it, and what is seen above it is a wall. The water there shows the floor as far as
    without the post, and not the wall."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    view, water = pool_with(False, eye)
    picture = view.picture()
    water.VisibilityOff()
    dry = view.picture()
    post = (dry[..., 0] > 200) & (dry[..., 2] < 60)
    without, its_water = pool_with(True, eye)
    right = without.picture()
    its_water.VisibilityOff()
    is_water = np.abs(right - without.picture()).max(axis=2) > 3
    rows = np.arange(len(post))[:, None]
    over = post.any(axis=0) & (rows > np.where(post, rows, -1).max(axis=0))  # in the columns that the post takes
    behind = over & is_water & (right.min(axis=2) > 80)
    wt.save(picture, wt.output_folder() / f"post_{eye[0]}_{is_software}.png")
    wt.save(right, wt.output_folder() / f"no_post_{eye[0]}_{is_software}.png")
    wt.check_at_least("pixels behind the post where the floor is seen", int(behind.sum()), 100)
    off = np.abs(picture - right).max(axis=2)[behind]
    # what is straight behind the surface instead: 71 to 100 %; the rest is the wall's foot, and the post's edges
    wt.check_at_most("% of them that differ by more than 20 of 255", 100 * float((off > 20).mean()),
                     35 if is_software else 60)


def hills_of(count=81, half=10.0):
    """Land with hills before and behind a valley; all but the hills lies under 0, and so does its border."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(-half, half, count), np.linspace(-half, half, count)))
    z = -3.0 + sum(high * np.exp(-((x - east) ** 2 + (y - north) ** 2) / 8.0)
                   for east, north, high in ((-4, 3, 7), (5, 4, 4.5), (1, -4, 3.5), (-6, -6, 4)))
    plane = vtkPlaneSource()
    plane.SetResolution(count - 1, count - 1)
    plane.Update()
    land = plane.GetOutput()
    vtk_to_numpy(land.GetPoints().GetData())[:] = np.column_stack([x, y, z])
    land.GetPointData().SetNormals(None)
    return land


@pytest.mark.parametrize("is_software", (1, 0))
@pytest.mark.parametrize("eye", ((3, -20, 6), (14, -15, 5), (-18, 4, 8)), ids=str)
def test_a_parallel_view_is_that_of_an_eye_far_away(eye, is_software, monkeypatch):
    """Behind hills, too, where the end of the bed is hidden: rays that leave the water there do not meet what stands
    before it."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    pictures = []
    for is_parallel in (True, False):
        view = wt.View(SIZE, WHITE)
        wt.add_actor(view.renderer, hills_of(), (0.8, 0.7, 0.5))
        water = clear_water(view, (-1, 1, -1, 1))
        water.SetSheetToAutomatic()
        far = 1.0 if is_parallel else 500.0
        camera = wt.place_camera(view.renderer, np.multiply(eye, far), (0, 0, 0), (1, 80))
        away = np.linalg.norm(np.multiply(eye, far))
        camera.SetClippingRange(away - 18, away + 18)
        camera.SetParallelProjection(is_parallel)
        camera.SetParallelScale(6.0)
        camera.SetViewAngle(2 * np.degrees(np.arctan(6.0 / away)))
        pictures.append(view.picture())
        wt.save(pictures[-1], wt.output_folder() / f"far_{eye[0]}_{is_software}_{is_parallel}.png")
    mask = wt.water_mask(view, water)
    off = np.abs(pictures[0] - pictures[1]).max(axis=2)
    wt.check_at_least("% of the pixels are water", 100 * mask.mean(), 20)
    wt.check_at_most("% of them that differ by more than 30 of 255", 100 * float((off[mask] > 30).mean()), 0.5)


@pytest.mark.parametrize("is_software", (1, 0))
@pytest.mark.parametrize("eye", ((2, -14, 7), (9, -12, 6)), ids=str)
def test_a_mesh_over_its_plane_is_as_deep_as_in_it(eye, is_software, monkeypatch):
    """Of a mesh that lies 1.5 m over its plane the water behind a sill, whose bed is hidden, and that of the shore are as
    deep as with the plane in the mesh: depths count from the surface."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    pictures = []
    for level in (0.0, -1.5, None):
        view = wt.View(SIZE, WHITE)
        # a sill, a basin behind it, and a lower bed before it
        for middle, size in (((0, 5, -2.6), (16, 10, 0.2)), ((0, -0.5, -2.0), (16, 1, 3)), ((0, -6, -3.6), (16, 10, 0.2))):
            wt.add_actor(view.renderer, wt.box(middle, size), (0.8, 0.6, 0.4)).GetProperty().LightingOff()
        if level is not None:
            water = clear_water(view, None)
            plane = vtkPlane()
            plane.SetNormal(0, 0, 1)
            plane.SetOrigin(0, 0, level)
            water.SetPlane(plane)
            sheet = vtkPlaneSource()
            sheet.SetOrigin(-8, -1, 0)
            sheet.SetPoint1(8, -1, 0)
            sheet.SetPoint2(-8, 10, 0)
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(sheet.GetOutputPort())
            water.SetMapper(mapper)
            look = water.GetWaterProperty()
            look.SetShoreSoftness(1.0)
            look.SetReflectanceModeToConstant()
            look.SetReflectance(0.0)
        wt.place_camera(view.renderer, eye, (0, 0, 0), (0.5, 60))
        pictures.append(view.picture())
    wt.save(pictures[0], wt.output_folder() / f"sill_in_plane_{eye[0]}_{is_software}.png")
    wt.save(pictures[1], wt.output_folder() / f"sill_over_plane_{eye[0]}_{is_software}.png")
    is_water = np.abs(pictures[0] - pictures[2]).max(axis=2) > 3
    off = np.abs(pictures[1] - pictures[0]).max(axis=2)[is_water]
    wt.check_at_least("pixels of water", int(is_water.sum()), 2000)
    wt.check_at_most("% of them that differ by more than 5 of 255", 100 * float((off > 5).mean()), 3)
