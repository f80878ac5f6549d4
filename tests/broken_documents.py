"""What tests/check-documents must refuse, and what it must not."""

# Each has one fault: its line, words of the message, and the document.
BROKEN = [
    # Headings.
    (1, "a blank and a text", "#Title\n\n# Title\n"),
    (3, "a blank and a text", "# Title\n\n##The idea\n"),
    (3, "a blank and a text", "# Title\n\n####### Seven\n"),
    (3, "a blank and a text", "# Title\n\n##\n"),
    (3, "indented as code is", "# Title\n\n        ##The definition\n"),
    (3, "a heading that is indented", "# Title\n\n ## Idea\n"),
    (1, "no heading", "Text alone.\n"),
    (1, "the first heading is of the first level", "## Idea\n"),
    (1, "text before the first heading", "Text.\n\n# Title\n"),
    (3, "a second heading of the first level", "# Title\n\n# Title\n"),
    (3, "level 3 below one of level 1", "# Title\n\n### Detail\n"),
    (4, "not underlined", "# Title\n\nIdea\n----\n"),
    (4, "not underlined", "# Title\n\nIdea\n====\n"),
    # Links and pictures.
    (3, "no such file", "# Title\n\nSee [it](no_such_file.md).\n"),
    (4, "no such file", "# Title\n\nSee what\n[is not](no_such_file.md) there.\n"),
    (3, "no such file", "# Title\n\n![It](no_such_picture.png)\n"),
    (3, "no such file", "# Title\n\n[![It](no_such_picture.png)](README.md)\n"),
    (3, "no such file", "# Title\n\n[![It](../programs/page/page.png)](no_such_file.md)\n"),
    (3, "no such file", "# Title\n\n- a [`CODE`](no_such_file.md)\n"),
    (5, "no such file", "# Title\n\n10. An item.\n\n    A [link](no_such_file.md) in it.\n"),
    (5, "no such file", "# Title\n\n| a | b |\n|---|---|\n| 1 | [2](no_such_file.md) |\n"),
    (3, "no such file", "# Title\n\n[It](../build/check/CMakeCache.txt)\n"),
    (3, "no such file", "# Title\n\n[It](../.git)\n"),
    (3, "no such file", "# Title\n\n[It](../..)\n"),
    (3, "no such file", "# Title\n\n[It](/)\n"),
    (3, "no such heading", "# Title\n\n[It](#no-such-heading)\n"),
    (3, "no such heading", "# Title\n\n[It](README.md#no-such-heading)\n"),
    (3, "no such heading", "# Title\n\n[It](#title-1)\n"),
    (3, "blanks within a link", "# Title\n\n[It](../ tests / README.md)\n"),
    (3, "blanks within a link", "# Title\n\n[It]()\n"),
    (3, "a blank within a link", "# Title\n\n[It] (README.md)\n"),
    (3, "unknown kind", "# Title\n\n[It](htp://example.org)\n"),
    (3, "without its beginning or end", "# Title\n\n[It](README.md\n"),
    (3, "without its beginning or end", "# Title\n\nIt](README.md)\n"),
    # Code.
    (3, "not closed", "# Title\n\n```\ncode\n"),
    (3, "not closed", "# Title\n\n````\ncode\n```\n"),
    (7, "not closed", "# Title\n\n~~~\n```\n~~~\n\n```\n"),
    (3, "a ` without another", "# Title\n\nThe `function is.\n"),
    (3, "a ` without another", "# Title\n\nThe ``function` is.\n"),
    (3, "blanks within a path", "# Title\n\nIn `../ exact / line.cpp`.\n"),
    (3, "blanks within a path", "# Title\n\nIn `tests / line_test.cpp`.\n"),
    # Tables.
    (5, "1 cells: expected 2", "# Title\n\n| a | b |\n|---|---|\n| 1 |\n"),
    (5, "3 cells: expected 2", "# Title\n\n| a | b |\n|---|---|\n| 1 | `2|3` |\n"),
    (4, "3 cells: expected 2", "# Title\n\n| a | b |\n|---|---|---|\n"),
    (5, "does not end with |", "# Title\n\n| a | b |\n|---|---|\n| 1 | 2\n"),
    (3, "line of dashes", "# Title\n\n| a | b |\n| 1 | 2 |\n"),
    (5, "directly below a table", "# Title\n\n| a | b |\n|---|---|\nText.\n"),
    # Lists and paragraphs.
    (4, "item 3 follows item 1", "# Title\n\n1. One.\n3. Three.\n"),
    (5, "item 4 follows item 2", "# Title\n\n1. One.\n2. Two.\n4. Four.\n"),
    (3, "in the middle of a line", "# Title\n\n1. One.2. Two.\n"),
    (3, "in the middle of a line", "# Title\n\n1. By `one`.2. Two.\n"),
    (4, "indented unlike its paragraph", "# Title\n\nText that goes\n    on.\n"),
    (3, "indented unlike its paragraph", "# Title\n\n  Text.\n"),
    (4, "indented unlike its paragraph", "# Title\n\n- An item that\n      goes on.\n"),
    (4, "indented unlike its paragraph", "# Title\n\n- An item that\ngoes on.\n"),
    # Prose.
    (3, "before a punctuation mark", "# Title\n\nThat is it : this.\n"),
    (3, "before a punctuation mark", "# Title\n\nThat is it .\n"),
    (4, "begins with a punctuation mark", "# Title\n\nThat is it\n, this too.\n"),
    (4, "begins with a punctuation mark", "# Title\n\nThat is\n: this.\n"),
    (3, "no blank after a full stop", "# Title\n\nThat is it.The other is not.\n"),
    (3, "moved into an emphasis", "# Title\n\nTwo polygons* pass through* each other.\n"),
    (3, "moved into an emphasis", "# Title\n\nIt is *the line itself *that counts.\n"),
    (3, "beside an apostrophe", "# Title\n\nThe polygon' s plane.\n"),
    (3, "beside an apostrophe", "# Title\n\nThe planes ' order.\n"),
    (3, "before a link in parentheses", "# Title\n\nThe truth([tests](README.md)).\n"),
    # Idioms. Each of plain_words.py is tried by its example, too.
    (3, "such as: the number", "# Title\n\nThis process has no memory beyond so\nmany bytes.\n"),
    (5, "such as: the number", "# Title\n\n| a |\n|---|\n| so many threads |\n"),
    (4, "such as: a noun", "# Title\n\nRows are kept.\nWhat is left is freed.\n"),
    (3, "such as: a caller that", "# Title\n\n- Rows: one each. Who reads them\n  waits.\n"),
    (1, "such as: is requested", "# A picture that is asked for\n"),
    # Lines.
    (3, "blanks at the end", "# Title\n\nText. \n"),
    (3, "a tab", "# Title\n\nText\tand more.\n"),
    (3, "one newline at the end", "# Title\n\nText."),
    (4, "one newline at the end", "# Title\n\nText.\n\n"),
]

# Likewise of comments of headers, and of strings of sources.
BROKEN_HEADERS = [
    (1, "such as: the number", "int a;  // of so many bytes\n"),
    (1, "such as: the number", "/// At most so\n/// many bytes.\nint a;\n"),
    (3, "such as: compared with", "/* Rows.\n *\n * They are held\n * against others. */\n"),
    (2, "such as: a noun", "int a;\n/// What is drawn stays.\nint b;\n"),
    (1, "such as: is requested", "const char* a = \"//\";  ///< when it is asked for\n"),
]
BROKEN_SOURCES = [
    (1, "such as: the number", 'const char* a = "at most so many bytes";\n'),
    (1, "such as: the number", 'const char* a = "at most so "\n                "many bytes";\n'),
    (1, "such as: the number", 'const char a = \'"\', b[] = "so many bytes";\n'),
    (2, "such as: a noun", 'const char* a = R"(Rows are kept.\nWhat is left is freed.)";\n'),
]

# No fault in comments or in strings.
WHOLE_SOURCE = r"""#include "what/is/said/so/many.h"
int is_said, held_against;  // so
int many;                   // bytes, so many
                            // that none is left
const char* a = "so", *b = "many", c = '"';  // "
const char* d = R"(Is what is left freed? No.)";
"""

# No fault: what looks like one, and is none.
WHOLE = r"""<!-- A comment. -->
# `code`, *emphasis* and [a link](README.md): the title

See [the title](#code-emphasis-and-a-link-the-title), [the second idea](#the-idea-1),
[another file](README.md#contributing-adding-to-it), [a folder](bench), [the top](../README.md) and
[elsewhere](https://example.org/a_(b)#c). [![A picture](../programs/page/page.png)](#the-idea)

## The idea

What is it? Who knows? So many things that none is left, `so many`, are told apart, who says what.
`[no link](at all)`, `a | b`, ``a ` b``, 1.5, 2 * x * y, \[no link\](at all), f([a, b]) of x,
|a| + |b|, e.g. this... and the users' own: a.b.C, std::vector.
|a| may begin a line, and 0.5 too,
#1 as well.

    ## a comment of a shell
    #include <no such file>
    [no link](at all) : * this*

### Detail of a z-buffer_2

```cpp
#include "no such file.h"
# no heading
| no | table
```

~~~~
```
~~~~

## The idea

1. One item
   goes on.

       #include <code in the item>

   Its second paragraph.
   - One in it.
   - Another
     goes on.
2. Two.

Text between.

3. Three.

- A list of another kind.

| a | b |
|---|---:|
| `x\|y` | [c](#detail-of-a-z-buffer_2) |
| | ![d](../programs/page/page.png) |
"""
