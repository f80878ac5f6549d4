#!/usr/bin/env python3
"""Writes the source of the site, which Sphinx reads (make-site).

    site_source.py PREFIX OUT    PREFIX: an installation, whose command draws the pictures

Documents and their pictures are copied to the same places in OUT, so that links between them hold.
Added are pictures that documents' own commands draw, lists of contents, and pages: of the gallery,
of algorithms step by step, of the command's options, of headers, and of each source file that a
document links to.
"""
import collections
import functools
import gzip
import importlib.machinery
import importlib.util
import os
import pathlib
import posixpath
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
INDEX = "programs/manual/site/index.md"
RUN_DOCUMENT = ROOT / "tests" / "run-document"
PICTURES = (".png", ".svg")


def module_of(script):
    """A script of tests/ as a module: what it knows of documents is in one place."""
    sys.path.insert(0, str(script.parent))
    loader = importlib.machinery.SourceFileLoader(script.name.replace("-", "_"), str(script))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    sys.modules[loader.name] = module  # Sphinx passes functions of it to other processes
    loader.exec_module(module)
    return module


documents = module_of(ROOT / "tests" / "check-documents")
commands = module_of(RUN_DOCUMENT)

# An algorithm, the document that it is described in, and a scene that shows it; further options.
STEPS = [
    ("bsp", "hidden/sort/bsp.md", "cyclic-overlap"),
    ("depth-sort", "hidden/sort/depth_sort.md", "cyclic-overlap"),
    ("z-buffer", "interp/visibility/z_buffer.md", "interpenetrating-planes"),
    ("scan-line", "interp/visibility/scan_line.md", "interpenetrating-planes"),
    ("scan-line-z", "interp/visibility/scan_line_z.md", "interpenetrating-planes"),
    ("warnock", "interp/visibility/warnock.md", "cyclic-overlap"),
    ("ray-cast", "interp/visibility/ray_cast.md", "cyclic-overlap", "--size", "24x24"),
    ("roberts", "hidden/lines/roberts.md", "house-perspective"),
    ("appel", "hidden/lines/appel.md", "house-perspective"),
    ("franklin", "hidden/lines/franklin.md", "house-perspective"),
    ("perimeter", "hidden/lines/perimeter.md", "surface"),
]
LANGUAGES = {".cpp": "cpp", ".h": "cpp", ".py": "python", ".draw": "draw", ".ts": "typescript"}


# Places.


def version_of(root):
    text = (root / "interp" / "displayfile.h").read_text()
    return ".".join(re.findall(r"#define DISPLAYFILE_VERSION_\w+ (\d+)", text))


def origin_of(docname):
    """Where the document stands from which the page is made: what its links are relative to."""
    return INDEX if docname == "index" else docname + ".md"


def place_of(name):
    """The page, relative to OUT, that shows a file or a folder of the repository."""
    if name == INDEX:
        return "index.md"
    if (ROOT / name / "README.md").is_file():
        return name + "/README.md"
    if re.fullmatch(r"programs/[\w-]+\.draw", name):
        return f"gallery/{pathlib.PurePath(name).stem}.md"
    if name.endswith((".md", *PICTURES)) or not (ROOT / name).is_file():
        return name
    return f"source/{name}.md"


def targets_of(name):
    """Files and folders that a document links to or shows."""
    for _, text in documents.Document(name, (ROOT / name).read_text(encoding="utf-8")).prose:
        plain, _ = documents.blanked(text)
        for _, target in documents.links(plain, text):
            if not documents.SCHEME.match(target) and not target.startswith("#"):
                path = posixpath.join(posixpath.dirname(name), target.split("#")[0])
                yield posixpath.normpath(path)


# Documents.


class Source:
    """The folder OUT, and the command that draws."""

    def __init__(self, prefix, out):
        self.prefix, self.out = prefix, out
        is_document = lambda name: name.endswith(".md") and not name.startswith(".github")
        self.names = list(documents.files_of_source(is_document))
        entries = re.findall(r"^(?:.*<)?/([\w./-]+?)>?$", (ROOT / INDEX).read_text(), re.MULTILINE)
        self.listed = set(entries)

    def write(self, place, text):
        path = self.out / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def draw(self, *arguments):
        words = [self.prefix / "bin" / "displayfile", *arguments]
        subprocess.run(words, check=True, cwd=ROOT, stdout=subprocess.DEVNULL)

    def copy_documents(self):
        steps = {document: method for method, document, *_ in STEPS}
        contents = self.contents_of_folders()
        for name in self.names:
            text = (ROOT / name).read_text(encoding="utf-8")
            if commands.PICTURE.search(text):
                text = self.with_pictures(name, text)
            if name in steps:
                up = "../" * name.count("/")
                page = f"{up}steps/{steps[name]}.html"
                text += f'\n<a href="{page}">The algorithm, step by step</a>\n'
            self.write(place_of(name), text + toctree(contents.get(name, []), hidden=True))

    def with_pictures(self, name, text):
        """The pictures that stand in comments are shown, if the document's commands draw them."""
        folder = (self.out / name).with_suffix("")
        subprocess.run([RUN_DOCUMENT, "--keep", folder, ROOT / name], check=True)

        def shown(match):
            picture = folder / match[2]
            place = f"{folder.name}/{match[2]}"
            return match[1].replace(match[2], place) if picture.is_file() else ""

        text = commands.PICTURE.sub(shown, text)
        for path in folder.iterdir():
            if path.suffix not in PICTURES:
                shutil.rmtree(path) if path.is_dir() else path.unlink()
        return text

    def contents_of_folders(self):
        """By README.md: the documents of its folder, and the README.md of folders in it."""
        contents = collections.defaultdict(list)
        for name in set(self.names) - {INDEX}:
            folder = posixpath.dirname(name)
            if name.endswith("README.md"):
                folder = posixpath.dirname(folder)
            while folder and f"{folder}/README.md" not in self.names:
                folder = posixpath.dirname(folder)
            if folder and name.removesuffix(".md") not in self.listed:
                contents[f"{folder}/README.md"].append("/" + name.removesuffix(".md"))
        return {name: sorted(entries) for name, entries in contents.items()}

    def copy_linked_files(self):
        """Pictures to their places; of other files a page each."""
        for name in sorted({target for name in self.names for target in targets_of(name)}):
            path, place = ROOT / name, place_of(name)
            if path.suffix in PICTURES:
                (self.out / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, self.out / name)
            elif place.startswith("source/"):
                self.write(place, self.source_page(name))

    def included(self, name):
        """Shows a file of the repository, which is copied."""
        copy = self.out / "source" / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, copy)
        language = LANGUAGES.get(pathlib.PurePath(name).suffix, "text")
        return f"```{{literalinclude}} /source/{name}\n:language: {language}\n```\n"

    def source_page(self, name):
        """Not in the lists of contents, and not in what is searched."""
        return f"---\norphan: true\nnosearch: true\n---\n\n# {name}\n\n{self.included(name)}"

    def reference_page(self, title, name, introduction):
        text = f"# {title}\n\n[{introduction}]({introduction}) introduces it.\n\n"
        return text + self.included(name)

    # Pages that are drawn.

    def write_gallery(self):
        names = sorted(path.stem for path in (ROOT / "programs").glob("*.draw"))
        index = "# Gallery\n\nThe drawing programs of [programs](programs/README.md).\n"
        (self.out / "gallery").mkdir(parents=True, exist_ok=True)
        for name in names:
            program = f"programs/{name}.draw"
            size = ["--size", "480x480"]
            if name == "problem-10-8":  # a solved problem of two pixels a side
                size = ["--size", "2x2", "--samples", "1"]
            elif name == "exploded-pump":  # its list of parts needs room
                size = ["--paper", "a4-landscape", "--dpi", "96"]
            elif name == "exploded-view":  # so does this one
                size = ["--size", "600x600"]
            self.draw("draw", program, "-o", self.out / "gallery" / f"{name}.png", *size)
            self.write(f"gallery/{name}.md", gallery_page(program, size, self.included(program)))
            index += gallery_figure(name)
        pages = [f"gallery/{name}" for name in names]
        self.write("gallery.md", index + toctree(pages, hidden=True))

    def write_steps(self):
        (self.out / "extra" / "steps").mkdir(parents=True)
        text = (
            "# Algorithms, step by step\n\nEach page runs an algorithm on a small scene: the "
            "picture so far, its data structure, and the listing with the line that is executed. "
            "It opens at the finished picture; play begins at the first step. "
            "Pages of your own scenes: "
            "`displayfile steps SCENE.draw --hidden METHOD -o steps.html`.\n\n"
            "| algorithm | step by step | scene | described in |\n|---|---|---|---|\n"
        )
        for method, document, scene, *options in STEPS:
            page = f"steps/{method}.html"
            program = f"programs/{scene}.draw"
            to = ["-o", self.out / "extra" / page]
            self.draw("steps", program, "--hidden", method, *to, *options)
            text += f'| `{method}` | <a href="{page}">open</a> | [{scene}](gallery/{scene}.md) '
            text += f"| [{document}]({document}) |\n"
        self.write("steps.md", text)

    # Reference.

    def write_command(self):
        pages = sorted((self.prefix / "share" / "man" / "man1").glob("displayfile*.1.gz"))
        names = [page.name.removesuffix(".1.gz") for page in pages]
        for name, page in zip(names, pages):
            roff = gzip.decompress(page.read_bytes()).decode()
            self.write(f"command/{name}.md", Roff(roff).markdown())
        text = "# The command\n\nIts manual pages, which `man` shows where it is installed.\n"
        self.write("command.md", text + toctree([f"command/{name}" for name in names]))

    def write_headers(self):
        headers = self.prefix / "include" / "displayfile"
        names = sorted(str(path.relative_to(headers)) for path in headers.rglob("*.h"))
        names.remove("displayfile.h")
        pages = [f"cpp/{name.removesuffix('.h')}" for name in names]
        xml = self.out.parent / "doxygen" / "xml"
        for name, page in zip(names, pages):
            self.write(page + ".md", header_page(name, xml))
        text = (
            "# C++\n\nAn application includes `displayfile/displayfile.h`, which includes these "
            "headers, and is linked with `displayfile::displayfile` (CMake) or with the output of "
            "`pkg-config --libs displayfile`. Everything is in the namespace `displayfile`. "
            "[The guide](programs/manual/guide.md#the-c-library) introduces it; "
            "[a first application](programs/manual/tutorials/first_application.md) uses it.\n"
        )
        self.write("cpp.md", text + toctree(pages))
        self.write("c.md", c_page(self.prefix / "include" / "displayfile_c.h"))
        types = "interp/web/displayfile.d.ts"
        page = self.reference_page("JavaScript", types, "interp/web/README.md")
        self.write("javascript.md", page)


# Text of pages.


def toctree(entries, hidden=False):
    if not entries:
        return ""
    options = ":hidden:\n" if hidden else ":maxdepth: 1\n"
    return "\n```{toctree}\n" + options + "\n" + "\n".join(entries) + "\n```\n"


def header_page(name, xml):
    """Classes, in the header's order, and then all else that it declares."""
    file = re.sub(r"[_.]", lambda m: {"_": "__", ".": "_8"}[m[0]], pathlib.PurePath(name).name)
    text = (xml / f"{file}.xml").read_text(encoding="utf-8")
    classes = re.findall(r'<innerclass refid="(class|struct)\w+"[^>]*>(\w+)</innerclass>', text)
    options = "   :members:\n   :undoc-members:\n"
    directives = [f".. doxygen{kind}:: {name}\n{options}" for kind, name in classes]
    directives.append(f".. doxygenfile:: {name}\n   :sections: enum typedef var func\n")
    return f"# {name}\n\n```{{eval-rst}}\n" + "\n".join(directives) + "```\n"


def c_page(header):
    """The C header's own comment, and its groups."""
    text = (
        "# C: displayfile_c.h\n\n[interp/c/README.md](interp/c/README.md) introduces it.\n\n"
        "```{eval-rst}\n.. doxygenfile:: displayfile_c.h\n   :project: displayfile_c\n"
        "   :sections: briefdescription detaileddescription\n```\n"
    )
    groups = r"@defgroup (\w+) (.+)\n((?: \* [^@].*\n)*)"
    for name, title, about in re.findall(groups, header.read_text(encoding="utf-8")):
        text += (
            f"\n## {title}\n\n{re.sub(r'^ [*] ', '', about, flags=re.MULTILINE)}\n```{{eval-rst}}\n"
            f".. doxygengroup:: {name}\n   :project: displayfile_c\n   :content-only:\n"
            "   :members:\n```\n"
        )
    return text


def title_of(name):
    return name.replace("-", " ").capitalize()


@functools.cache
def description_of(program):
    """The comment with which it begins."""
    lines = (ROOT / program).read_text(encoding="utf-8").splitlines()
    described = []
    for line in lines:
        if not line.startswith("#"):
            break
        described.append(line.lstrip("# ").rstrip())
    return " ".join(described)


def escaped(text):
    return re.sub(r"([\\`*_{}\[\]<>#|~$])", r"\\\1", text)


def gallery_page(program, size, source):
    name = pathlib.PurePath(program).stem
    picture = f"![{title_of(name)}]({name}.png)"
    command = f"displayfile draw {program} -o {name}.png {' '.join(size)}"
    return (
        f"# {title_of(name)}\n\n{escaped(description_of(program))}\n\n{picture}\n\n"
        f"```sh\n{command}\n```\n\n{source}"
    )


def gallery_figure(name):
    return (
        f"\n```{{figure}} gallery/{name}.png\n:figclass: gallery\n:width: 200px\n"
        f":alt: {title_of(name)}\n:target: gallery/{name}.html\n\n{title_of(name)}\n```\n"
    )


class Roff:
    """A manual page of this project as Markdown: it knows the macros of these pages alone."""

    FONT = re.compile(r"\\f([BIR])")
    ESCAPES = [(r"\-", "-"), (r"\&", ""), (r"\[aq]", "'"), (r"\(aq", "'"), (r"\e", "\\")]
    SKIPPED = (".TH", ".nh", ".ad", '.\\"')

    def __init__(self, text):
        self.blocks, self.paragraph, self.term = [], [], None  # term: None, "awaited" or its text
        self.example = None
        for line in text.splitlines():
            self.take(line)
        self.end_paragraph()

    def markdown(self):
        """In place of the heading NAME stands the name itself."""
        name, _, about = self.blocks[1].partition(" - ")
        title = "# " + name.replace("-", " ", 1)
        return "\n\n".join([title, about.capitalize() + ".", *self.blocks[2:]]) + "\n"

    def take(self, line):
        macro, _, rest = line.partition(" ")
        if self.example is not None:
            self.take_example(line)
        elif line.startswith(self.SKIPPED) or not line:
            return
        elif not line.startswith("."):
            self.take_text(self.inline(line))
        elif macro in (".SH", ".SS"):
            self.end_paragraph()
            marks = "##" if macro == ".SH" else "###"
            self.blocks.append(f"{marks} {self.plain(rest).strip(chr(34)).capitalize()}")
        elif macro in (".PP", ".TP"):
            self.end_paragraph()
            self.term = "awaited" if macro == ".TP" else None
        elif macro == ".EX":
            self.end_paragraph()
            self.example = []
        elif macro in (".B", ".I", ".BR", ".IR"):
            self.take_text(self.alternating(macro[1:], rest))
        else:
            raise ValueError(f"a macro that no page had before: {line}")

    def take_example(self, line):
        if line == ".EE":
            self.blocks.append("```sh\n" + "\n".join(self.example) + "\n```")
            self.example = None
        else:
            self.example.append(self.plain(line))

    def take_text(self, text):
        if self.term == "awaited":
            self.term = text
        else:
            self.paragraph.append(text)

    def end_paragraph(self):
        text = "\n".join(self.paragraph)
        if self.term is not None:
            text = self.term + "\n: " + text.replace("\n", "\n  ")
        if self.paragraph:
            self.blocks.append(text)
        self.paragraph, self.term = [], None

    def plain(self, text):
        text = self.FONT.sub("", text)
        for escape, character in self.ESCAPES:
            text = text.replace(escape, character)
        return text

    def inline(self, text):
        """Bold words are code, italic ones are emphasised."""
        parts = self.FONT.split("\\fR" + text)
        return "".join(self.in_font(font, part) for font, part in zip(parts[1::2], parts[2::2]))

    def in_font(self, font, text):
        text = self.plain(text)
        if font == "R" or not text.strip():
            return escaped(text)
        return f"`{text}`" if font == "B" else f"<i>{text}</i>"

    def alternating(self, fonts, text):
        words = re.findall(r'"[^"]*"|(?:\\ |\S)+', text)
        if len(fonts) == 1:
            return self.in_font(fonts, " ".join(words))
        return "".join(self.in_font(fonts[i % 2], word.strip('"')) for i, word in enumerate(words))


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: site_source.py PREFIX OUT")
    source = Source(pathlib.Path(sys.argv[1]), pathlib.Path(os.path.abspath(sys.argv[2])))
    source.copy_documents()
    source.copy_linked_files()
    source.write_gallery()
    source.write_steps()
    source.write_command()
    source.write_headers()


if __name__ == "__main__":
    main()
