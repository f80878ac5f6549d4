#!/usr/bin/env python3
"""Tests of run-document: a document that is run, and documents with one fault each."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

RUN_DOCUMENT = pathlib.Path(__file__).resolve().parent / "run-document"

WHOLE = """# A page

In a file `a/names.txt`, a name a line:

```draw
Ada
```

Now add to
`a/names.txt`:

```draw
Ben
```

```sh
sort -r a/names.txt
cp a/names.txt names.svg
```

```text
Ben
Ada
```

<!-- ![Names](names.svg) -->
"""


class RunDocument(unittest.TestCase):
    def run_page(self, text):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text(text, encoding="utf-8")
            return subprocess.run([RUN_DOCUMENT, page], capture_output=True, text=True)

    def expect_fault(self, line, message, text):
        done = self.run_page(text)
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"page.md:{line}: ", done.stderr)
        self.assertIn(message, done.stderr)

    def test_a_page_is_run(self):
        done = self.run_page(WHOLE)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, "page.md: 1 block of commands was run\n")

    def test_other_output_is_a_fault(self):
        self.expect_fault(16, "printed is\nBen\nAda\n", WHOLE.replace("Ben\nAda\n", "Ada\nBen\n"))

    def test_output_that_is_not_shown_is_a_fault(self):
        self.expect_fault(3, "printed is\n1\n", "# A page\n\n```sh\necho 1\n```\n\nThe end.\n")

    def test_output_that_no_command_prints_is_a_fault(self):
        page = "# A page\n\n```sh\ntrue\n```\n\n```text\n1\n```\n"
        self.expect_fault(3, "expected is\n1\n", page)
        self.expect_fault(3, "no commands", "# A page\n\n```text\n1\n```\n" + page)

    def test_a_command_that_fails_is_a_fault(self):
        self.expect_fault(3, "exit status 3", "# A page\n\n```sh\n(exit 3)\necho done\n```\n")
        self.expect_fault(3, "exit status 1", "# A page\n\n```sh\nfalse | cat\n```\n")

    def test_a_picture_that_is_not_drawn_is_a_fault(self):
        self.expect_fault(26, "have drawn other.svg", WHOLE.replace("(names.svg)", "(other.svg)"))

    def test_a_block_without_a_purpose_is_a_fault(self):
        self.expect_fault(5, "neither run nor a file", "# A page\n\nThis:\n\n```cpp\nint i;\n```\n")
        self.expect_fault(5, "an indented block", "# A page\n\nThis:\n\n    displayfile draw\n")
        self.expect_fault(3, "not closed", "# A page\n\n```sh\ntrue\n")

    def test_a_page_without_commands_is_a_fault(self):
        self.expect_fault(1, "no commands", "# A page\n\nNothing.\n")

    def test_a_page_whose_module_is_missing_is_not_run(self):
        program = "In a file `a.py`:\n\n```python\nimport no_such_module\n```\n"
        done = self.run_page(f"# A page\n\n{program}\n```sh\nfalse\n```\n")
        self.assertEqual(done.returncode, 0)
        self.assertIn("not run: Python's module no_such_module is not installed", done.stdout)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main()
