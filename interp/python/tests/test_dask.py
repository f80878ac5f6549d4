"""Bands and turntables over processes of a Dask cluster: the pictures of one machine, bit for bit."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Iterator

import numpy as np
import pytest
from conftest import ROOT, ring

import displayfile
from displayfile import Error, PicklableSystem, System

dask = pytest.importorskip("dask", reason="Dask is not installed")
distributed = pytest.importorskip("distributed", reason="Dask's distributed is not installed")
import displayfile.dask as over  # noqa: E402

pytestmark = [  # of libraries that Dask uses; of tests that do without the cluster on purpose
    pytest.mark.filterwarnings("ignore:make_current is deprecated:DeprecationWarning"),
    pytest.mark.filterwarnings("ignore:Running on a single-machine scheduler:UserWarning"),
]

GEARS = ROOT / "programs" / "gears.draw"
SIZE = (120, 90)


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    """Two workers, each a process with one thread."""
    settings = {
        "distributed.comm.timeouts.connect": "60s",
        "distributed.scheduler.allowed-failures": 5,
    }
    with dask.config.set(settings):
        with distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as cluster, distributed.Client(cluster) as connected:
            yield connected


@pytest.fixture
def gears() -> PicklableSystem:
    system = PicklableSystem(aspect=SIZE[0] / SIZE[1])
    system.replay(GEARS.read_text())
    return system


@pytest.fixture
def mesh(tmp_path: Path) -> Path:
    path = tmp_path / "ring.obj"
    path.write_text(ring(18, 10))
    return path


def turning(mesh: Path) -> PicklableSystem:
    system = PicklableSystem(aspect=SIZE[0] / SIZE[1])
    system.import_mesh(mesh, up="z")
    return system


# ---- Bit for bit -------------------------------------------------------------------------


def test_bands_are_the_commands_picture(client, gears, command, tmp_path):
    done = command("draw", GEARS, "-o", "a.ppm", "--size", "120x90")
    assert done.returncode == 0, done.stderr
    expected = (tmp_path / "a.ppm").read_bytes()
    picture = over.draw(gears, SIZE, band=7)
    assert picture.shape == (90, 120, 4) and picture.dtype == np.uint8
    assert picture.chunks == ((7,) * 12 + (6,), (120,), (4,))
    pixels = picture.compute()
    assert b"P6\n120 90\n255\n" + pixels[..., :3].tobytes() == expected
    names = over.save(gears, tmp_path / "band.ppm", SIZE, band=40).compute()
    assert names == [str(tmp_path / f"band-00{k}.ppm") for k in range(3)]
    bands = [Path(name).read_bytes().split(b"\n255\n", 1) for name in names]
    assert [header for header, _ in bands] == [b"P6\n120 40", b"P6\n120 40", b"P6\n120 10"]
    assert b"P6\n120 90\n255\n" + b"".join(rows for _, rows in bands) == expected


def test_ids_depth_and_other_options(client, gears):
    options = {"hidden": "scan-line", "samples": 2, "background": (0, 0.5, 1)}
    expected = gears.draw(SIZE, ids=True, depth=True, **options)
    drawn = over.draw(gears, SIZE, ids=True, depth=True, band=np.int64(31), **options)
    assert isinstance(drawn, displayfile.Picture)
    pixels, ids, depth = dask.compute(*drawn)
    for part, of_one in zip((pixels, ids, depth), expected):
        assert part.dtype == of_one.dtype and np.array_equal(part, of_one)
    assert over.draw(gears, SIZE, ids=True).depth is None
    assert int((drawn.ids >= 0).sum().compute()) == (expected.ids >= 0).sum()


@pytest.mark.parametrize("hidden", [None, "z-buffer"])
def test_views_are_those_of_the_commands_turntable(hidden, client, mesh, command, tmp_path):
    words = [] if hidden is None else ["--hidden", hidden]
    done = command(
        *("draw", mesh, "-o", "t.png", "--turntable", 11, "--size", "120x90", "--up", "z"), *words
    )
    assert done.returncode == 0, done.stderr
    system = turning(mesh)
    folder = tmp_path / "on workers"
    folder.mkdir()
    saved = over.save_turntable(system, folder / "t.png", 11, SIZE, block=2, hidden=hidden)
    names = saved.compute()
    assert names == [str(folder / f"t-{k:03}.png") for k in range(11)]
    for name in names:
        assert Path(name).read_bytes() == (tmp_path / Path(name).name).read_bytes()
    views = over.turntable(system, 11, SIZE, block=3, hidden=hidden)
    assert views.shape == (11, 90, 120, 4) and views.chunks[0] == (3, 3, 3, 2)
    one = system.calls.system(retain=True).turntable(11, SIZE, hidden=hidden)
    assert np.array_equal(views.compute(), np.stack([one.draw(k) for k in range(11)]))
    picture = over.turntable(system, 4, SIZE, ids=True, hidden=hidden)
    with_ids = system.calls.system(retain=True).turntable(4, SIZE, ids=True, hidden=hidden)
    expected = np.stack([with_ids.draw(k).ids for k in range(4)])
    assert picture.depth is None and np.array_equal(picture.ids.compute(), expected)


def test_without_a_cluster_threads_of_this_process_draw(gears):
    expected = gears.draw(SIZE)
    for scheduler in ("synchronous", "threads"):
        picture = over.draw(gears, SIZE, band=9)
        assert np.array_equal(picture.compute(scheduler=scheduler, num_workers=4), expected)


def test_only_what_a_slice_touches_is_drawn(gears):
    from dask.callbacks import Callback

    drawn: list[Any] = []
    picture = over.draw(gears, (60, 1000), band=10)
    with Callback(pretask=lambda key, *_: drawn.append(key)):
        part = picture[505:525].compute(scheduler="synchronous")
    assert np.array_equal(part, gears.draw((60, 1000), rows=(505, 525)))
    assert len([key for key in drawn if key[0].startswith("displayfile-draw")]) == 3


def test_pictures_are_stored_band_by_band(client, gears, tmp_path):
    dask.array.to_npy_stack(tmp_path / "stack", over.draw(gears, SIZE, band=20))
    stored = dask.array.from_npy_stack(tmp_path / "stack")
    assert stored.chunks[0] == (20, 20, 20, 20, 10)
    assert np.array_equal(stored.compute(), gears.draw(SIZE))


# ---- What is kept on workers -------------------------------------------------------------


def scenes_of(dask_worker: Any) -> list[int]:
    """How many systems each scene made on the worker."""
    return [
        sum(map(len, value._ready.values()))
        for value in dask_worker.data.values()
        if isinstance(value, over._Scene)
    ]


def test_a_scene_is_entered_once_on_each_worker(client, gears):
    kept = client.compute(over._scene_of(gears))
    over.draw(gears, SIZE, band=3).compute()
    over.draw(gears, (60, 45), band=3).compute()
    made = list(client.run(scenes_of).values())  # a worker that was late may have none
    assert [1] in made and all(of_one in ([], [1]) for of_one in made)
    over.turntable(gears, 20, 32, block=1).compute()
    over.turntable(gears, 20, 32, block=1).compute()
    made = list(client.run(scenes_of).values())
    assert any(made) and all(of_one in ([], [1], [2]) for of_one in made)
    del kept


def test_calls_tell_their_size(gears):
    from dask.sizeof import sizeof

    gears.mesh(np.zeros((100000, 3)), np.zeros((0, 3), int))
    scene = over._Scene(gears.calls, "key")
    assert sizeof(scene) >= 100000 * 3 * 8


def test_large_scenes_are_sent_without_a_warning(client, recwarn):
    system = PicklableSystem()
    system.mesh(np.random.default_rng(1).uniform(-1, 1, (90000, 3)), np.zeros((0, 3), int))
    assert over.draw(system, 64, band=16).compute().shape == (64, 64, 4)
    assert not [w for w in recwarn if "Large object" in str(w.message)]


# ---- What goes wrong ---------------------------------------------------------------------


def times_run(client: Any, future: Any) -> int:
    """How often a worker was to compute it."""
    key = str(future.key)

    def count(dask_scheduler: Any) -> int:
        return sum(
            str(entry[0]) == key and entry[2] == "processing"
            for entry in dask_scheduler.transition_log
        )

    return int(client.run_on_scheduler(count))


def test_what_a_dead_worker_had_done_and_was_doing_is_done_again(client, gears):
    size = (600, 480)
    expected = gears.draw(size, samples=6)
    bands = over.draw(gears, size, band=8, samples=6).to_delayed().ravel()
    processes = client.run(os.getpid)
    futures = client.compute(list(bands))
    first = next(iter(distributed.as_completed(futures)))
    [[address]] = client.who_has([first]).values()
    assert len([future for future in futures if future.done()]) < len(futures)
    os.kill(processes[address], signal.SIGKILL)
    assert np.array_equal(np.concatenate(client.gather(futures)), expected)
    assert times_run(client, first) == 2
    assert processes[address] not in client.run(os.getpid).values()


def test_what_has_not_begun_is_dropped(client, mesh, tmp_path):
    (tmp_path / "turn").mkdir()
    names = over.save_turntable(
        turning(mesh), tmp_path / "turn" / "t.png", 400, (400, 300), block=1
    )
    future = client.compute(names)
    while not list((tmp_path / "turn").glob("t-*.png")):
        time.sleep(0.01)
    future.cancel()
    while any(client.processing().values()):
        time.sleep(0.01)
    assert 0 < len(list((tmp_path / "turn").iterdir())) < 400


def test_an_error_is_told_once_and_not_tried_again(client, mesh):
    system = turning(mesh)
    picture = over.draw(system, SIZE, band=45)
    mesh.unlink()
    futures = client.compute(list(picture.to_delayed().ravel()))
    for future in futures:
        with pytest.raises(Error, match="ring.obj") as told:
            future.result()
        assert isinstance(told.value, Error)
        assert times_run(client, future) == 1
    with pytest.raises(Error, match="ring.obj"):
        picture.compute()
    drawn = over.draw(PicklableSystem(), SIZE, band=45).compute()  # workers go on
    assert (drawn == 255).all()


def test_a_folder_that_is_not_there_is_told(client, gears, tmp_path):
    with pytest.raises(Error, match="nowhere"):
        over.save(gears, tmp_path / "nowhere" / "a.ppm", SIZE, band=45).compute()
    with pytest.raises(Error, match="nowhere"):
        over.save_turntable(gears, tmp_path / "nowhere" / "a.ppm", 3, SIZE).compute()
    assert list(tmp_path.iterdir()) == []


def test_what_is_refused_is_refused_at_once(gears, tmp_path):
    for draw in (over.draw, lambda *a, **s: over.turntable(a[0], 3, *a[1:], **s)):
        for said in (
            {"size": 0},
            {"size": (3, 70000)},
            {"hidden": "magic"},
            {"samples": 0},
            {"colour": 1},
            {"lines": "outline"},
            {"hidden": "franklin", "ids": True},
        ):
            with pytest.raises(Error):
                draw(gears, **said)
        with pytest.raises(Error, match="expected a PicklableSystem, not System"):
            draw(System())
        with pytest.raises(Error):
            draw(None)
    for said in ({"rows": (0, 3)}, {"band": 0}, {"band": 2.5}, {"band": True}):
        with pytest.raises(Error):
            over.draw(gears, **said)
    for views in (0, 10001, "3"):
        with pytest.raises(Error):
            over.turntable(gears, views)
    for said in ({"block": 0}, {"hidden": "depth-sort"}, {"axis": (0, 0, 0)}, {"fit": "well"}):
        with pytest.raises(Error):
            over.turntable(gears, 3, **said)
    for path in ("a.svg", "a.bmp", "a", None, 5):
        with pytest.raises(Error):
            over.save(gears, path, SIZE)
    for path in ("a.bmp", "a", None):
        with pytest.raises(Error):
            over.save_turntable(gears, path, 3, SIZE)


# ---- Importing ---------------------------------------------------------------------------


def output_of(program: str) -> str:
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_importing_the_package_does_not_load_dask():
    program = "import sys, displayfile; print([name for name in sys.modules if 'dask' in name])"
    assert output_of(program) == "[]\n"


def test_without_dask_an_error_names_the_package():
    program = """
import sys, displayfile
sys.modules["dask"] = None
try:
    import displayfile.dask
except displayfile.Error as refused:
    print(refused)
"""
    assert "python3-dask" in output_of(program)


def test_distributed_is_not_needed():
    program = """
import sys
sys.modules["distributed"] = None
import displayfile, displayfile.dask
print(displayfile.dask.draw(displayfile.PicklableSystem(), 8).compute().sum())
"""
    assert output_of(program) == f"{8 * 8 * 4 * 255}\n"
