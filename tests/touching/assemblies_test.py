#!/usr/bin/python3
"""Tests of what judge_assemblies compares, solids and files, and of how it counts."""
import importlib.machinery
import importlib.util
import json
import math
import pathlib
import random
import struct
import sys
import unittest
from collections import Counter

sys.dont_write_bytecode = True
try:
    import numpy as np
except ImportError:
    print("python3-numpy is not installed")
    sys.exit(77)

import assemblies
import posed_meshes
import solids

HERE = pathlib.Path(__file__).resolve().parent
VIEWS = 6


def judge():
    """The script, as a module."""
    path = str(HERE / "judge_assemblies")
    loader = importlib.machinery.SourceFileLoader("judge_assemblies", path)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def area(face):
    return math.hypot(*solids.normal(face)) / 2


class Solids(unittest.TestCase):
    def test_a_box(self):
        faces = solids.box((0, 0, 0), (2, 3, 4))
        self.assertTrue(solids.is_closed(faces))
        self.assertEqual(solids.volume(faces), 6 * 24)
        self.assertEqual(Counter(map(round, solids.angles(faces))), {90: 12})
        self.assertFalse(solids.is_closed(faces[1:]))
        self.assertFalse(solids.is_closed([faces[0][::-1], *faces[1:]]))

    def test_a_plate_with_a_hole(self):
        hole = [(6, 5), (5, 6), (4, 5), (5, 4)]
        for axis in range(3):
            faces = solids.plate_with_hole(0, 10, 0, 10, hole, 0, 1, axis)
            self.assertTrue(solids.is_closed(faces))
            self.assertEqual(solids.volume(faces), 6 * (100 - 2))

    def test_a_frustum(self):
        faces = solids.tapered([(1, -1), (1, 1), (-1, 1), (-1, -1)], (0, 0), (2, 1), 0, 3)
        self.assertTrue(solids.is_closed(faces) and all(map(solids.is_flat, faces)))
        self.assertEqual(solids.volume(faces), 6 * (16 + 8 + 4))  # h / 3 (A + sqrt(A B) + B)

    def test_triangles_of_faces(self):
        source = random.Random(1)
        for letter in assemblies.LETTERS.values():
            for axis in range(3):
                face = [solids.on_axis(axis, *p, 7) for p in letter]
                first = source.randrange(len(face))
                face = face[first:] + face[:first]
                triangles = solids.triangles_of(face)
                self.assertEqual(len(triangles), len(face) - 2)
                self.assertAlmostEqual(sum(map(area, triangles)), area(face))
                for triangle in triangles:
                    self.assertGreater(solids.dot(solids.normal(triangle), solids.normal(face)), 0)

    def test_corners_on_sides_are_corners_of_triangles(self):
        face = [(0, 0, 0), (2, 0, 0), (4, 0, 0), (4, 4, 0), (2, 4, 0), (0, 4, 0)]
        triangles = solids.triangles_of(face)
        self.assertEqual(len(triangles), 4)
        self.assertTrue(all(area(t) > 0 for t in triangles))

    def test_cuts_leave_the_solid_as_it_is(self):
        source, is_cut = random.Random(1), False
        for number in range(VIEWS):
            clean = assemblies.assembly("t-vertices", "test", number).faces()
            faces = solids.cut_at_random(source, clean, 40, 4)
            self.assertEqual(solids.volume(faces), solids.volume(clean))
            self.assertTrue(all(map(solids.is_flat, faces)))
            self.assertAlmostEqual(sum(map(area, faces)), sum(map(area, clean)))
            is_cut = is_cut or not solids.is_closed(faces)
        self.assertTrue(is_cut)


class Kinds(unittest.TestCase):
    def test_parts_are_closed_and_turned_outward(self):
        for kind in assemblies.KINDS:
            for number in range(VIEWS):
                made = assemblies.assembly(kind, "test", number)
                self.assertTrue(all(isinstance(x, int) for f in made.faces() for p in f for x in p))
                for part in made.parts:
                    self.assertTrue(all(map(solids.is_flat, part.faces)), (kind, part.name))
                    self.assertTrue(all(area(face) > 0 for face in part.faces), (kind, part.name))
                    if part.closed:
                        self.assertTrue(solids.is_closed(part.faces), (kind, part.name))
                        self.assertGreater(solids.volume(part.faces), 0, (kind, part.name))

    def test_a_pump_has_some_20_parts(self):
        self.assertGreaterEqual(len(assemblies.assembly("pump", "test", 0).parts), 20)

    def test_figures_lie_in_faces(self):
        for kind in assemblies.IN_FACES:
            made, figures = assemblies.assembly(kind, "test", 1), 0
            solid = [f for part in made.parts if part.closed for f in part.faces]
            for part in made.parts:
                if not part.closed:
                    self.assertTrue(any(self.lies_in(part.faces[0], face) for face in solid))
                    figures += 1
            self.assertGreater(figures, 3, kind)

    def test_faces_that_rounding_takes_out_of_a_plane_are_found(self):
        faces = assemblies.assembly("plates", "11", 17).faces()
        posed = posed_meshes.Posed("11/plates", 17, faces, faces)
        self.assertTrue(posed.is_beyond("obj"))
        self.assertFalse(posed.is_beyond("ply"))

    @staticmethod
    def lies_in(figure, face):
        n = solids.normal(face)
        return all(
            solids.dot(n, solids.minus(p, face[0])) == 0
            and all(
                solids.dot(n, solids.cross(solids.minus(b, a), solids.minus(p, a))) >= 0
                for a, b in solids.sides(face)
            )
            for p in figure
        )

    def test_the_same_words_make_the_same(self):
        for kind in assemblies.KINDS:
            one, other = (assemblies.assembly(kind, "test", 2).faces() for _ in range(2))
            self.assertEqual(one, other)


class Features(unittest.TestCase):
    def test_of_boxes_that_touch_and_are_apart(self):
        low = solids.box((0, 0, 0), (40, 40, 40))
        self.assertEqual(posed_meshes.least_feature(low), 40)
        on_top = solids.box((8, 8, 40), (30, 30, 60))
        self.assertEqual(posed_meshes.least_feature(low + on_top), 8)
        above = solids.box((10, 10, 43), (30, 30, 63))
        self.assertEqual(posed_meshes.least_feature(low + above), 3)

    def test_an_offset_leaves_the_reach_a_quarter(self):
        for kind in ("plates", "gears", "labels"):
            for number in range(VIEWS):
                faces = assemblies.assembly(kind, "test", number).faces()
                posed = posed_meshes.Posed("test", number, faces, faces)
                for form in posed_meshes.FORMATS:
                    self.assertTrue(posed.is_clear(form), (kind, number, form))
                    offset = math.hypot(*posed.motion(form).offset)
                    self.assertLessEqual(offset, 1000 * posed.size * (1 + 1e-9))

    def test_six_digits(self):
        self.assertAlmostEqual(posed_meshes.unit_of_digits(123.456), 0.0005)
        self.assertAlmostEqual(posed_meshes.reach_of("obj", 123.456), 0.004)
        self.assertEqual(posed_meshes.reach_of("stl", 2.0), 2.0**-20)


class Files(unittest.TestCase):
    def setUp(self):
        faces = solids.prism([(0, 0), (9, 0), (9, 4), (4, 4), (4, 9), (0, 9)], 0, 5)
        self.posed = posed_meshes.Posed("test", 0, faces, faces)
        self.points, self.faces = posed_meshes.unique_points(faces)
        self.triangles = posed_meshes.unique_points(solids.triangulated(faces)[0])

    def test_stl(self):
        data = posed_meshes.stl(*self.triangles)
        self.assertEqual(len(data), 84 + 50 * len(self.triangles[1]))
        self.assertEqual(struct.unpack_from("<I", data, 80)[0], len(self.triangles[1]))
        corners = struct.unpack_from("<9f", data, 84 + 50 + 12)
        expected = self.triangles[0][self.triangles[1][1]]
        self.assertEqual(list(corners), [float(x) for p in expected for x in p])

    def test_ply(self):
        data = posed_meshes.ply(self.points, self.faces)
        header, body = data.split(b"end_header\n", 1)
        self.assertIn(f"element face {len(self.faces)}\n".encode(), header)
        lists = sum(1 + 4 * len(face) for face in self.faces)
        self.assertEqual(len(body), 12 * len(self.points) + lists)

    def test_gltf(self):
        scene = json.loads(posed_meshes.gltf(*self.triangles))
        self.assertEqual(scene["accessors"][1]["count"], 3 * len(self.triangles[1]))
        views, (buffer,) = scene["bufferViews"], scene["buffers"]
        self.assertEqual(buffer["byteLength"], sum(view["byteLength"] for view in views))

    def test_obj_has_six_digits(self):
        text = posed_meshes.obj(self.points / 7 + 1000, self.faces).decode()
        self.assertIn("v 1001.29 1000 1000\n", text)
        self.assertEqual(text.count("\nf "), len(self.faces))

    def test_a_turn_keeps_lengths_and_hands(self):
        rows = np.array(posed_meshes.random_turn(random.Random(1)))
        self.assertLess(abs(rows @ rows.T - np.eye(3)).max(), 1e-15)
        self.assertAlmostEqual(np.linalg.det(rows), 1)


class Counts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.judge = judge()

    def strokes(self, *pieces, joined=1e-6):
        return self.judge.lone_strokes(np.array(pieces), joined)

    def test_strokes(self):
        long, far = (0.1, 0.1, 0.9, 0.1), (0.5, 0.5, 0.501, 0.5)
        self.assertEqual(self.strokes(long), 0)
        self.assertEqual(self.strokes(long, far), 1)
        self.assertEqual(self.strokes(long, far, far), 1)  # it is there twice
        self.assertEqual(self.strokes(far), 1)
        self.assertEqual(self.strokes(long, (0.5, 0.1, 0.5, 0.101)), 0)  # stands on it
        self.assertEqual(self.strokes(long, (0.5, 0.1 + 1e-5, 0.5, 0.101)), 1)
        self.assertEqual(self.strokes(long, (0.5, 0.1 + 1e-5, 0.5, 0.101), joined=1e-4), 0)
        chain = [(0.5 + k / 1000, 0.5, 0.501 + k / 1000, 0.5) for k in range(4)]
        self.assertEqual(self.strokes(long, *chain), 0)  # together longer than the pen is wide
        self.assertEqual(self.strokes(long, chain[0], chain[2]), 2)

    def test_pixels(self):
        finer = np.zeros((36, 36), int)
        finer[:, 18:] = 1
        self.assertEqual(self.judge.wrong_pixels(finer, finer[1::3, 1::3]), 0)
        found = finer[1::3, 1::3].copy()
        found[:, 5] = 1  # next to the edge
        self.assertEqual(self.judge.wrong_pixels(finer, found), 0)
        found[4, 3] = 1
        self.assertEqual(self.judge.wrong_pixels(finer, found), 1)
        finer[13, 11] = 2  # a sliver between centres
        self.assertEqual(self.judge.wrong_pixels(finer, found), 0)

    def test_dumps_and_paths(self):
        dump = "displayfile-dump 1\nsegment 1 visible\npick 0\nmove 0 0 1\nline 0.3 0.4 1\nend\n"
        self.assertEqual(self.judge.lengths(self.judge.pieces_of_dump(dump)).sum(), 0.5)
        self.assertEqual(len(self.judge.pieces_of_dump("displayfile-dump 1\nend\n")), 0)
        svg = '<path id="HATCH-1" stroke-width="0.13" d="M0 0L3 4M1 1L1 2 2 2Z"/>'
        self.assertAlmostEqual(
            self.judge.length_of_layer(svg, "HATCH"), 5 + 1 + 1 + math.sqrt(2)
        )
        self.assertEqual(self.judge.length_of_layer(svg, "VISIBLE"), 0)


if __name__ == "__main__":
    unittest.main()
