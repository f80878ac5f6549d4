#!/usr/bin/python3
"""Tests of tests/check-goldens, on a small tree with a command of its own."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

TESTS = pathlib.Path(__file__).resolve().parent

# Instead of `displayfile check`: writes as the dump of programs/NAME.draw what stands in it.
COMMAND = """#!/bin/sh
for folder; do [ "$golden" = --golden ] && break; golden=$folder; done
for file; do
  name=${file##*/} name=${name%.draw}
  case $file in *.draw) { cat "$file"; echo end; } >"$folder/$name.txt" ;; esac
done
"""
HOUSE = "displayfile-dump 1\nsegment 1 visible\npick 0\nsegment 2 invisible\npick 1\n"
TREE = "displayfile-dump 1\nsegment 7 visible\nmove 0 0 0\n"
SETS = (
    "bsp-exact bsp-roundoff depth-sort-exact depth-sort-roundoff map-exact map-roundoff all-segments"
    " franklin-exact perimeter-exact perimeter-roundoff colour-rule"
).split()


class CheckGoldens(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.tree = pathlib.Path(self.folder.name)
        for name in ("check-goldens", "programs-drawn-by"):
            (self.tree / "tests").mkdir(exist_ok=True)
            shutil.copy(TESTS / name, self.tree / "tests")
        (self.tree / "displayfile").write_text(COMMAND)
        (self.tree / "displayfile").chmod(0o755)
        self.write("programs/house.draw", HOUSE)
        self.write("programs/tree.draw", TREE)
        self.write("tests/golden/as-set/tree.txt", "to be written")
        self.write("tests/golden/digests.txt", "".join(f"{name} house\n" for name in SETS))
        self.assertEqual(self.run_script("--update"), (0, "all equal\n"))

    def write(self, name, text):
        (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
        (self.tree / name).write_text(text)

    def text(self, name):
        return (self.tree / name).read_text()

    def table_without(self, start):
        lines = self.text("tests/golden/digests.txt").splitlines(keepends=True)
        self.write("tests/golden/digests.txt", "".join(l for l in lines if not l.startswith(start)))

    def run_script(self, *words):
        script = [self.tree / "tests" / "check-goldens", self.tree / "displayfile", *words]
        done = subprocess.run(script, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def expect_failure(self, *parts):
        status, text = self.run_script()
        self.assertEqual(status, 1, text)
        for part in parts:
            self.assertIn(part, text)

    def test_what_is_written_passes(self):
        self.assertEqual(self.run_script(), (0, "all equal\n"))
        self.assertEqual(self.text("tests/golden/as-set/tree.txt"), TREE + "end\n")
        rows = self.text("tests/golden/digests.txt").splitlines()
        self.assertEqual(len(rows), 3 + 2 * len(SETS))
        segments = [row.rpartition(" ")[0] for row in rows[:3]]
        self.assertEqual(segments, ["as-set house 1", "as-set house 2", "as-set tree 7"])

    def test_a_changed_segment_is_named_with_the_command_that_prints_the_difference(self):
        self.write("programs/house.draw", HOUSE.replace("pick 1", "pick 2"))
        after = f"{self.tree.resolve()}/displayfile"
        self.expect_failure(
            "programs/house.draw, as-set: segment 2 differs",
            f"diff <(BEFORE dump programs/house.draw) <({after} dump programs/house.draw)\n",
            "house.draw, bsp-exact: segment 2 differs",
            f"<({after} dump programs/house.draw --hidden bsp --precision exact --scope segment)\n",
            "\n15 differ\n",
        )
        self.assertEqual(self.run_script("--update"), (0, "all equal\n"))
        self.assertEqual(self.run_script(), (0, "all equal\n"))

    def test_visibility_and_order_of_segments_are_compared(self):
        for changed, message in (
            (HOUSE.replace("invisible", "visible"), "segment 2 differs"),
            (HOUSE + "segment 3 visible\n", "segment 3 is new"),
            (HOUSE.partition("segment 2")[0], "segment 2 is missing"),
            (HOUSE.replace("segment 1", "segment 4"), "segment 4 in the place of segment 1"),
        ):
            self.write("programs/house.draw", changed)
            self.expect_failure("programs/house.draw, as-set: " + message)

    def test_a_dump_for_readers_is_compared(self):
        self.write("tests/golden/as-set/tree.txt", TREE)
        self.expect_failure("programs/tree.draw, as-set: tests/golden/as-set/tree.txt is another dump")

    def test_missing_programs_and_lines_are_noticed(self):
        self.write("programs/new.draw", TREE)
        self.expect_failure("programs/new.draw: no line in", "--update writes it")
        (self.tree / "programs/new.draw").unlink()
        (self.tree / "programs/house.draw").unlink()
        self.expect_failure("programs/house.draw, as-set: no such program", "bsp-exact: no program in")
        self.write("programs/house.draw", HOUSE)
        self.table_without("colour-rule")
        self.expect_failure("colour-rule: no program in")

    def test_what_is_no_line_of_the_table_is_refused(self):
        for line in ("bsp-exakt house", "as-set", "as-set house 1"):
            self.write("tests/golden/digests.txt", line + "\n")
            self.expect_failure("digests.txt:1:1: expected SET PROGRAM SEGMENT DIGEST")

    def test_a_command_that_fails_is_named(self):
        self.write("displayfile", "#!/bin/sh\nexit 2\n")
        self.expect_failure("check-goldens: ", "--golden", "fails")


if __name__ == "__main__":
    unittest.main()
