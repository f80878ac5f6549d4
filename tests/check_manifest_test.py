#!/usr/bin/python3
"""Tests of tests/check-manifest, on the reports of a build with four tests."""
import pathlib
import subprocess
import sys
import tempfile
import unittest
from xml.sax.saxutils import quoteattr

sys.dont_write_bytecode = True
SCRIPT = pathlib.Path(__file__).resolve().parent / "check-manifest"
TESTS = ["Curves.AreDrawn", "Sheet.Dxf", "Sheet.Pdf", "python"]
# bash is a package that every system offers that has dpkg; the other is of no system.
OFFERED, NOT_OFFERED = "bash", "no-such-package"


class CheckManifest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        tests = "".join(f'add_test("{name}" "true")\n' for name in TESTS)
        (self.folder / "CTestTestfile.cmake").write_text(tests)
        (self.folder / "CMakeCache.txt").write_text("dxf_DIR:PATH=/usr\nnone_DIR:PATH=none_DIR-NOTFOUND\n")

    def failures(self, manifest="", **statuses):
        """The lines of its message where tests have a status other than `run`; None: not reported."""
        cases = "".join(
            f'\t<testcase name={quoteattr(name)} classname="" time="0" status="{status}">\n\t</testcase>\n'
            for name in TESTS
            if (status := statuses.get(name.replace(".", "_"), "run")) is not None)
        (self.folder / "report.xml").write_text(f"<testsuite>\n{cases}</testsuite>\n")
        (self.folder / "manifest.txt").write_text(manifest)
        done = subprocess.run(
            [SCRIPT, self.folder, self.folder / "report.xml", self.folder / "manifest.txt"],
            capture_output=True, text=True)
        self.assertEqual(done.returncode == 0, done.stderr == "", done.stderr)
        return done.stderr.splitlines()

    def test_a_whole_report_passes(self):
        self.assertEqual(self.failures(), [])
        self.assertEqual(self.failures(f"{OFFERED} dxf_DIR ^Sheet\\.(Dxf|Pdf)$\n"), [])

    def test_a_report_of_some_tests_is_refused(self):
        self.assertEqual(
            self.failures(Curves_AreDrawn=None, python=None),
            ["must have run: 2 of 4 tests are not in the report, such as Curves.AreDrawn"])

    def test_a_report_without_tests_is_refused(self):
        none = {name.replace(".", "_"): None for name in TESTS}
        self.assertEqual(self.failures(**none), [f"{self.folder}/report.xml: no tests in it"])

    def test_a_skipped_test_is_refused_unless_its_package_is_not_offered(self):
        self.assertEqual(self.failures(Sheet_Dxf="notrun"), ["must have run: skipped: Sheet.Dxf"])
        self.assertEqual(
            self.failures(f"{OFFERED} - ^Sheet\\.Dxf\n", Sheet_Dxf="notrun"),
            ["must have run: skipped: Sheet.Dxf"])
        self.assertEqual(self.failures(f"{NOT_OFFERED} - ^Sheet\\.Dxf\n", Sheet_Dxf="notrun"), [])

    def test_each_alternative_has_a_test(self):
        self.assertEqual(
            self.failures(f"{OFFERED} - ^Sheet\\.(Dxf|Svg|Png)$\n"),
            [f"must have run: {OFFERED}: no test is named ^Sheet\\.{name}$" for name in ("Svg", "Png")])

    def test_the_build_has_found_what_is_offered(self):
        self.assertEqual(
            self.failures(f"{OFFERED} none_DIR ^Sheet\n"),
            [f"must have run: {OFFERED} is offered, but the build has found nothing of it (none_DIR)"])


if __name__ == "__main__":
    unittest.main()
