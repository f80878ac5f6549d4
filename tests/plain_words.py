"""Idioms that documents, comments and messages must not have.

One rule: callers call, functions return, options are set.
"""
import re

CODE = "\ufffc"  # stands for a character that is not prose
PASSIVE = "(is|are|was|were|be|been|being|not)"
SENTENCE = rf"(?:\A|[.;:!?{CODE}]\s)\s*"  # its beginning
STATEMENT = r"(?=[^.?!]*[.!](\s|$))"  # up to its full stop: not a question, nor a heading

# Each has a pattern, in which a blank is any blanks; plain words instead; and an example of it.
IDIOMS = [
    ("rightest", "most accurate", "from the fastest to the rightest"),
    (r"so many(?! (\w+ )?that\b)", "the number, or its name", "no memory beyond so many bytes"),
    (rf"{PASSIVE} asked (for|of|by)", "is requested", "the last row that was asked for"),
    ("what (is|was|they) asked", "the request", "does what is asked"),
    (rf"{PASSIVE} (said|told)(?! apart)", "is set, is reported, gets", "a hole where not told"),
    ("said (settings?|options?|styles?)", "settings that are set explicitly", "the said settings"),
    ("(for|to|by|of) who(ever)?", "for callers that", "an order for who draws it"),
    ("takes? up (a|the|its) (scene|mesh|display file)", "prepares for", "takes up a scene"),
    ("lets? go of", "releases", "and lets go of the one before"),
    ("hand(s|ed)? (out|over)", "returns, passes", "as it is handed out"),
    ("what becomes of", "how it is drawn, the result of", "what becomes of a window"),
    ("what stands (for|in|at)", "the value, the contents", "what stands for a number"),
    ("held against", "compared with", "each is held against the truth"),
    ("the time on the wall", "wall time", "else the time on the wall"),
    ("in those of", "relative to, over those of", "times in those of the z-buffer"),
    (SENTENCE + "Who" + STATEMENT, "a caller that", "Who draws it keeps the order."),
    (SENTENCE + "What" + STATEMENT, "a noun: the visible part, the rest", "What is left is freed."),
]


def pattern_of(words):
    """A sentence begins with a capital letter; elsewhere letters may be of either case."""
    begin, flags = (SENTENCE, 0) if words.startswith(SENTENCE) else (r"(?<!\w)", re.IGNORECASE)
    words = words.removeprefix(SENTENCE).replace(" ", r"\s+")
    return re.compile(rf"{begin}(?P<words>{words})(?!\w)", flags)


PATTERNS = [(pattern_of(words), instead) for words, instead, _ in IDIOMS]

TOKENS = re.compile(r"""(?P<raw>R"(?P<mark>\w*)\((?P<within>.*?)\)(?P=mark)")"""
                    r"""|(?P<string>"(\\.|[^"\\\n])*")|'(\\.|[^'\\\n])'"""
                    r"""|(?P<comment>//[^\n]*|/\*.*?\*/)""", re.DOTALL)


def found_in(text):
    """(place, message) of each idiom in prose."""
    for pattern, instead in PATTERNS:
        for found in pattern.finditer(text):
            words = " ".join(found["words"].split())
            yield found.start("words"), f"{words!r}: write plainly, such as: {instead}"


MARKS = {
    "comment": re.compile(r"^/[/*]+[<!]?|\*/$|^ *\*(?= )", re.MULTILINE),
    "string": re.compile(r'^"|"$'),
    "raw": re.compile(r'^R"\w*\(|\)\w*"$'),
}


def part_of_source(text, kinds):
    """Comments or strings of C++: blanks and ends of lines stay, other characters are CODE."""
    kept, at = [], 0
    for token in TOKENS.finditer(text):
        kept.append(re.sub(r"\S", CODE, text[at:token.start()]))
        at = token.end()
        kind = next((kind for kind in kinds if token[kind]), None)
        kept.append(MARKS[kind].sub(lambda mark: re.sub(r"[^\n]", " ", mark[0]), token[0])
                    if kind else re.sub(r"\S", CODE, token[0]))
    return "".join(kept) + re.sub(r"\S", CODE, text[at:])


def faults_in_source(text, kinds):
    """(line, message) of each idiom in those kinds of tokens: comment, string, raw."""
    part = part_of_source(text, kinds)
    for place, message in found_in(part):
        yield part.count("\n", 0, place) + 1, message
