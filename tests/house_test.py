#!/usr/bin/python3
"""Tests of tests/house, on small trees in a temporary folder."""
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SCRIPT = pathlib.Path(__file__).resolve().parent / "house"


def script():
    """The script, as a module."""
    loader = importlib.machinery.SourceFileLoader("house", str(SCRIPT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("house", loader))
    loader.exec_module(module)
    return module


house = script()


def write(tree, files):
    for name, text in files.items():
        path = tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def printed(*words):
    done = subprocess.run([SCRIPT, *words], check=True, capture_output=True, text=True)
    return done.stdout


class Tokens(unittest.TestCase):
    def check(self, text, *tokens):
        self.assertEqual(house.tokens_of(text), list(tokens))

    def test_comments_are_none(self):
        self.check("a // b\nc /* d\n e */ f", "a", "c", "f")
        self.check("a // b \\\n still b\nc", "a", "c")
        self.check("a /**/ / b", "a", "/", "b")

    def test_literals_are_one(self):
        self.check('"a // b" "c\\"d" u8"e"sv', '"a // b"', '"c\\"d"', 'u8"e"sv')
        self.check("'\"' '\\'' L'x'", "'\"'", "'\\''", "L'x'")
        self.check('R"(a "b" // c)" x', 'R"(a "b" // c)"', "x")
        self.check('R"ab()" )a" \n)ab" x', 'R"ab()" )a" \n)ab"', "x")

    def test_numbers(self):
        self.check("1'000'000u + .5e-3f", "1'000'000u", "+", ".5e-3f")
        self.check("0x1.8p+4 1e5-2 1..2", "0x1.8p+4", "1e5", "-", "2", "1..2")
        self.check("f(1, '2')", "f", "(", "1", ",", "'2'", ")")

    def test_operators(self):
        self.check("a<=>b->*c...", "a", "<=>", "b", "->*", "c", "...")
        self.check("x<<=1;y>>z::w", "x", "<<=", "1", ";", "y", ">>", "z", "::", "w")
        self.check("++a---b!~c", "++", "a", "--", "-", "b", "!", "~", "c")

    def test_lines_of_the_preprocessor(self):
        self.check("#include <a/b.h>\n#define X \\\n 1", *"# include <a/b.h> # define X 1".split())
        self.assertEqual(house.tokens_of('#include "a.h"'), ["#", "include", '"a.h"'])

    def test_includes(self):
        text = '#include "a.h"\n#include <b.h>\n// #include "c.h"\n#  include "d/e.h"\n'
        self.assertEqual(house.includes_of(house.tokens_of(text)), ["a.h", "d/e.h"])


class Types(unittest.TestCase):
    def types(self, text):
        return house.types_of(house.tokens_of(text))

    def members(self, text):
        (found,) = self.types(f"struct X {{ {text} }};")
        return found.members

    def test_definitions(self):
        text = """
            struct A; class B : public A, C<int> {}; enum class D : int { x }; enum E {};
            template <class F> struct G final { class H {}; enum class I : char; };
            struct A a; template <> struct J<int> {}; struct K::L {}; friend class M;
            struct alignas(16) N {}; class [[nodiscard]] O {}; struct {} p; struct A q{1};
            void f(struct A& a) { struct R {}; }
        """
        names = [found.qualified for found in self.types(text)]
        self.assertEqual(names, ["B", "D", "E", "G", "G::H", "J", "L", "N", "O", "R"])

    def test_members(self):
        self.assertEqual(self.members("int a, b = f(1, 2); double c[3]{1, 2};"), ["a", "b", "c"])
        self.assertEqual(self.members("std::map<int, A> d; const T* e = nullptr;"), ["d", "e"])
        self.assertEqual(self.members("std::function<bool(int)> stop = {}; int f;"), ["stop", "f"])
        self.assertEqual(self.members("unsigned g : 3; alignas(8) mutable int h;"), ["g", "h"])
        self.assertEqual(self.members("enum { a, b } kind; private: int i_;"), ["kind", "i_"])

    def test_no_members(self):
        self.assertEqual(self.members("static int a; using B = int; friend class C;"), [])
        self.assertEqual(self.members("void f(int a) { int b; } bool g() const;"), [])
        self.assertEqual(self.members("X(int a) : a_{a}, b_(a) { int c; } int d;"), ["d"])
        self.assertEqual(self.members("bool operator==(const X& x) const = default;"), [])
        self.assertEqual(self.members("auto f() -> int { return 1; } int g;"), ["g"])

    def test_members_are_of_their_own_type(self):
        outer, inner = self.types("struct Out { struct In { int a; } in; int b; };")
        self.assertEqual((outer.qualified, outer.members), ("Out", ["in", "b"]))
        self.assertEqual((inner.qualified, inner.members), ("Out::In", ["a"]))


class Functions(unittest.TestCase):
    def functions(self, text):
        return house.public_functions(house.tokens_of(text), "X")

    def test_public_ones(self):
        text = """
            class Other { public: void other(); };
            class X {
              void a();
             public:
              X(); explicit X(int n) : n_{n}, m_(n) {} ~X() = default;
              X& operator=(const X&) = default;
              void b(); void b(int x = 1); int c() const { return n_; }
              template <class T> std::vector<T> d(T&& t) { if (t) return {}; }
              static constexpr int kE = 3;
              struct F { void g(); };
              std::function<void()> h = {};
              friend void i(X& x);
              [[nodiscard]] auto j() noexcept(true) -> int;
             private:
              void k();
             public:
              void l();
            };"""
        self.assertEqual(self.functions(text), ["b", "b", "c", "d", "j", "l"])

    def test_struct(self):
        self.assertEqual(self.functions("struct X { void a(); private: void b(); };"), ["a"])

    def test_no_such_class(self):
        self.assertIsNone(self.functions("class X; class Y { public: void x(); };"))


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name).resolve()

    def write(self, files):
        write(self.tree, files)

    def numbers(self):
        return house.measured(self.tree)["numbers"]


class Groups(Tree):
    def test_group_of(self):
        groups = {
            "clip/view.h": "engine",
            "programs/page/page.cc": "engine",
            "programs/benchmark.cpp": "engine",
            "programs/bench/page.cpp": "benchmarks",
            "programs/process/bench_program.h": "benchmarks",
            "interp/python/bench/bindings.cpp": "benchmarks",
            "tests/bench/seams/a.cpp": "benchmarks",
            "tests/bench_command_test.cpp": "tests",
            "tests/hard/a.cpp": "tests",
            "interp/c/tests/a.cpp": "tests",
            "interp/c/system.h": "bindings",
            "interp/vector/a.h": "engine",
            "other/a.h": None,
            "a.h": None,
        }
        for path, group in groups.items():
            self.assertEqual(house.group_of(path), group, path)

    def test_files_and_lines(self):
        short, long = "int a;\n" * 24, "\n" * 600
        self.write({"clip/a.h": short, "clip/b.hpp": short + "x"})
        self.write({"hidden/c.cpp": long + "int b;\n"})
        self.write({"clip/a.md": short, "build/clip/d.h": short, ".cache/clip/d.h": short})
        numbers = self.numbers()
        self.assertEqual(numbers["engine: files"], 3)
        self.assertEqual(numbers["engine: lines"], 24 + 25 + 601)
        self.assertEqual(numbers["engine: median lines a file"], 25)
        self.assertEqual(numbers["engine: tokens"], 72 + 73 + 3)
        self.assertEqual(numbers["engine: files under 25 lines"], 1)
        self.assertEqual(numbers["engine: files over 600 lines"], 1)
        self.assertEqual(numbers["tests: files"], 0)
        self.assertIsNone(numbers["tests: median lines a file"])
        self.assertEqual(house.measured(self.tree)["long"], ["hidden/c.cpp (601)"])


class Circles(Tree):
    def circles(self):
        return house.circles_of(house.sources_of(self.tree, house.files_of(self.tree)))

    def test_none(self):
        self.write({"clip/a.h": '#include "b.h"\n', "clip/b.h": '#include "clip/a.h"\n'})
        self.write({"hidden/c.h": '#include "clip/a.h"\n#include "nothing/there.h"\n'})
        self.assertEqual(self.circles(), [])
        self.assertEqual(self.numbers()["folders in circles"], 0)

    def test_a_folder_and_a_folder_in_it(self):
        back = '#include "hidden/a.h"\n#include "hidden/d.h"\n'
        self.write({"hidden/a.h": "", "hidden/d.h": "", "hidden/lines/b.h": back})
        self.write({"hidden/a.cpp": '#include "hidden/lines/b.h"\n'})
        self.write({"hidden/d.cpp": '#include "lines/b.h"\n'})
        self.write({"clip/e.h": '#include "hidden/a.h"\n'})
        (circle,) = self.circles()
        self.assertEqual(circle["folders"], ["hidden", "hidden/lines"])
        (edge,) = circle["weakest"]  # one file includes two headers, the other way it is two files
        self.assertEqual((edge["from"], edge["to"], edge["files"]), ("hidden/lines", "hidden", 1))
        headers = [("hidden/lines/b.h", "hidden/a.h"), ("hidden/lines/b.h", "hidden/d.h")]
        self.assertEqual(edge["includes"], headers)

    def test_through_others_and_several(self):
        self.write({"clip/a.h": '#include "hidden/a.h"\n', "hidden/a.h": '#include "interp/a.h"\n'})
        self.write({"interp/a.h": '#include "clip/a.h"\n', "interp/b.h": '#include "clip/a.h"\n'})
        self.write({"clip/b.h": '#include "hidden/a.h"\n'})
        self.write({"programs/a.h": '#include "programs/b/b.h"\n#include "clip/a.h"\n'})
        self.write({"programs/b/b.h": '#include "programs/a.h"\n'})
        first, second = self.circles()
        self.assertEqual(first["folders"], ["clip", "hidden", "interp"])
        weakest = [(edge["from"], edge["to"]) for edge in first["weakest"]]
        self.assertEqual(weakest, [("hidden", "interp")])
        self.assertEqual(second["folders"], ["programs", "programs/b"])
        self.assertEqual(self.numbers()["folders in circles"], 5)

    def test_printed(self):
        self.write({"clip/a.h": '#include "hidden/a.h"\n', "hidden/a.h": '#include "clip/a.h"\n'})
        self.write({"hidden/b.h": '#include "clip/a.h"\n'})
        lines = printed("--circles", self.tree).splitlines()
        self.assertEqual(lines[-3], "circle of 2 folders: clip, hidden")
        self.assertEqual(lines[-2].strip(), "clip -> hidden (1 file)")
        self.assertEqual(lines[-1].strip(), "clip/a.h includes hidden/a.h")
        self.assertNotIn("circle of", printed(self.tree))


class Structs(Tree):
    def test_options_of_hidden_surfaces(self):
        three = "{ Method method; int threads = 1; bool shadows; };"
        private = three.replace("method;", "method_;")
        self.write({"interp/a.h": f"struct A {three} struct B {{ int method, threads, x; }};"})
        self.write({"interp/b.h": f"class C {{ struct D {private} }};"})
        no_three = "struct E { int method; void threads(); struct { int scope; } s; };"
        self.write({"interp/c.h": no_three})
        self.write({"interp/d.h": "struct F { int scope, scope_, method; };"})
        self.write({"tests/a.h": f"struct G {three}", "programs/bench/a.h": f"struct H {three}"})
        names = ["A (interp/a.h)", "C::D (interp/b.h)", "H (programs/bench/a.h)"]
        self.assertEqual(house.measured(self.tree)["structs"], names)

    def test_types_of_scenes_and_views(self):
        self.write({"clip/a.h": "struct Scene {}; class B {}; enum class ViewKind { a };"})
        self.write({"clip/b.cpp": "struct Scene {}; struct Viewer; struct Review {};"})
        self.write({"tests/a.h": "struct TestScene {};", "interp/c/a.h": "struct CView {};"})
        self.assertEqual(house.measured(self.tree)["types"], ["Scene", "ViewKind"])

    def test_functions_of_the_system(self):
        self.assertIsNone(self.numbers()["public functions of GraphicsSystem"])
        text = "class GraphicsSystem { public: void a(); void a(int); private: void b(); };"
        self.write({"displayfile/graphics_system.h": text})
        self.assertEqual(self.numbers()["public functions of GraphicsSystem"], 2)


class Headers(Tree):
    INSTALL = (
        'install(CODE "execute_process(COMMAND cmake \\"-DSOURCE=${PROJECT_SOURCE_DIR}\\"\n'
        '  -P \\"${PROJECT_SOURCE_DIR}/interp/public.cmake\\"\n'
        '  COMMAND_ERROR_IS_FATAL ANY)" COMPONENT development)\n'
    )
    PROPERTIES = (
        "set_target_properties(c PROPERTIES VERSION 1\n"
        "  PUBLIC_HEADER ${CMAKE_CURRENT_SOURCE_DIR}/c_api.h)\n"
    )

    def test_none_known(self):
        self.write({"clip/a.h": ""})
        self.assertIsNone(self.numbers()["installed headers"])

    def test_installed(self):
        self.write({"CMakeLists.txt": self.INSTALL})
        self.write({"interp/public.cmake": "set(to_visit interp/all.h)\nset(visited)\n"})
        self.write({"interp/all.h": '#include <map>\n#include "clip/a.h"\n#include "clip/b.h"\n'})
        self.write({"clip/a.h": '#include "clip/b.h"\n', "clip/b.h": '#include "clip/a.h"\n'})
        self.write({"clip/c.h": "", "interp/c/c_api.h": "#include <stddef.h>\n"})
        self.write({"interp/c/CMakeLists.txt": self.PROPERTIES})
        headers = ["clip/a.h", "clip/b.h", "interp/all.h", "interp/c/c_api.h"]
        self.assertEqual(house.measured(self.tree)["headers"], headers)

    @unittest.skipUnless(any(map(shutil.which, house.COMPILERS)), "no compiler")
    def test_preprocessed(self):
        self.write({"interp/displayfile.h": '#include "clip/a.h"\n#include "made.h"\nint b;\n'})
        self.write({"clip/a.h": "// a\n#define X 1\nint a;\n", "generated/made.h": "int made;\n"})
        self.assertEqual(house.preprocessed_lines(self.tree, self.tree / "generated"), 3)
        with contextlib.redirect_stderr(io.StringIO()) as errors:
            self.assertIsNone(house.preprocessed_lines(self.tree, self.tree / "other"))
        self.assertIn("made.h", errors.getvalue())


class Output(Tree):
    def test_columns(self):
        self.write({"clip/a.h": "int a;\n"})
        lines = printed(self.tree).splitlines()
        self.assertEqual(lines[0].split(), ["engine:", "files", "1"])
        self.assertEqual({len(line) for line in lines}, {len(lines[0])})

    def test_json(self):
        self.write({"clip/a.h": "struct View { int a; };\n"})
        found = json.loads(printed("--json", self.tree))
        self.assertEqual(found["numbers"]["engine: tokens"], 8)
        self.assertEqual(found["types"], ["View"])

    def test_differences(self):
        self.assertEqual(house.difference(110, 100), "+10.0 %")
        self.assertEqual(house.difference(0, 4), "-100.0 %")
        self.assertEqual(house.difference(0, 0), "0.0 %")
        self.assertEqual(house.difference(3, 0), "new")
        self.assertEqual(house.difference(3, None), "-")


@unittest.skipUnless(shutil.which("git"), "no git")
class Git(Tree):
    def git(self, *words):
        name = ["-c", "user.name=test", "-c", "user.email=test@localhost"]
        subprocess.run(["git", "-C", self.tree, *name, *words], check=True, capture_output=True)

    def setUp(self):
        super().setUp()
        self.git("init")
        self.write({".gitignore": "ignored/\n", "clip/a.h": "int a;\n", "clip/b.h": "int b;\n"})
        self.git("add", ".")
        self.git("commit", "-m", "Two files")

    def test_files(self):
        self.write({"clip/ignored/c.h": "", "clip/new.h": ""})
        (self.tree / "clip/b.h").unlink()
        self.assertEqual(house.files_of(self.tree), [".gitignore", "clip/a.h", "clip/new.h"])

    def test_against_a_revision(self):
        self.write({"clip/c.h": "int c;\n"})
        lines = printed("--against", "HEAD", self.tree).splitlines()
        self.assertEqual(lines[0].split(), ["now", "HEAD", "difference"])
        self.assertEqual(lines[1].split(), ["engine:", "files", "3", "2", "+50.0", "%"])
        found = json.loads(printed("--json", "--against", "HEAD", self.tree))
        self.assertEqual(found["against"]["numbers"]["engine: tokens"], 6)

    def test_no_such_revision(self):
        words = [SCRIPT, "--against", "nothing", self.tree]
        done = subprocess.run(words, capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertTrue(done.stderr.startswith("house: "), done.stderr)


class FunctionsEntered(unittest.TestCase):
    def test_names(self):
        for function, name in {
            "displayfile::Segment::name() const": "displayfile::Segment::name",
            "void displayfile::walk<A<int> >(A<int>&)'2": "displayfile::walk<A<int> >",
            "displayfile::(anonymous namespace)::f(int)": "displayfile::{unnamed}::f",
            "std::vector<displayfile::Edge>::push_back(displayfile::Edge&&)":
                "std::vector<displayfile::Edge>::push_back",
            "main": "main",
        }.items():
            self.assertEqual(house.qualified_name(function), name)


if __name__ == "__main__":
    unittest.main()
