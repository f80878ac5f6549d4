"""Sphinx's configuration. The pages open from disk, without a network."""
import pathlib
import posixpath
import re
import sys

import docutils.nodes
import pygments.lexer
import pygments.token
import sphinx.addnodes
import sphinx.transforms

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "programs" / "manual" / "site"))
import site_source  # noqa: E402

project = "Display File"
copyright = re.search(r"Copyright \(c\) (.+)", (ROOT / "LICENSE").read_text())[1]
version = release = site_source.version_of(ROOT)
extensions = ["myst_parser", "breathe"]
root_doc = "index"
smartquotes = False  # two hyphens begin an option

myst_heading_anchors = 6
myst_heading_slug_func = site_source.documents.slug
myst_enable_extensions = ["deflist"]

breathe_projects = {
    "displayfile": str(ROOT / "build" / "site" / "doxygen" / "xml"),
    "displayfile_c": str(ROOT / "build" / "site" / "doxygen-c" / "xml"),
}
breathe_default_project = "displayfile"
breathe_domain_by_file_pattern = {"*displayfile_c.h": "c"}
breathe_default_members = ("members", "undoc-members")

html_theme = "furo"
html_title = f"Display File {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_extra_path = [str(ROOT / "build" / "site" / "source" / "extra")]
exclude_patterns = ["extra"]
html_copy_source = False
html_show_sphinx = False


class DrawLexer(pygments.lexer.RegexLexer):
    """Drawing programs."""

    name, aliases, filenames = "draw", ["draw"], ["*.draw"]
    tokens = {
        "root": [
            (r"#.*", pygments.token.Comment),
            (r'"(\\.|[^"\\])*"', pygments.token.String),
            (r"^\s*[a-z][a-z0-9-]*", pygments.token.Keyword),
            (r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", pygments.token.Number),
            (r"\s+|.", pygments.token.Text),
        ]
    }


class PlacesOfLinks(sphinx.transforms.SphinxTransform):
    """A link to a source file leads to the page that shows it, one to a folder to its README.md."""

    default_priority = 200

    def apply(self, **_):
        origin = site_source.origin_of(self.env.docname)
        for node in self.document.findall(sphinx.addnodes.pending_xref):
            if node["reftype"] == "myst":
                node["reftarget"] = self.place_of(origin, node["reftarget"])
        for node in self.document.findall(docutils.nodes.image):
            node["uri"] = self.place_of(origin, node["uri"])

    def place_of(self, origin, target):
        path, mark, anchor = target.partition("#")
        if not path or path.startswith("/"):
            return target
        named = posixpath.normpath(posixpath.join(posixpath.dirname(origin), path))
        place = site_source.place_of(named)
        here = posixpath.dirname(self.env.docname)
        return posixpath.relpath(place, here or ".") + mark + anchor


def setup(app):
    app.add_lexer("draw", DrawLexer)
    app.add_transform(PlacesOfLinks)
    return {"parallel_read_safe": True}
