"""A Markdown page as the tests of the documentation read it."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
COMMAND = re.compile(r"\./steadyhand (\w+)([^`\n#|]*)")
HEADING = re.compile(r"^#+ +(.*)$")
NOT_PROSE = re.compile(r"^ *(?:[#|<]|!\[)")  # heading, table, comment, picture
BEGINS_ITEM = re.compile(r"^ *(?:[-*>]|\d+\.) +")
END_OF_SENTENCE = re.compile(r"(?<=[.:!?])[)*_\"]*\s+(?=[A-Z`*\[\"])")


@dataclass
class Block:
    """Code between fences; `line` is the number of its first line."""

    language: str
    line: int
    text: str
    before: str  # the last line that is not empty before it


class Page:
    def __init__(self, path: Path) -> None:
        self.path = path
        self.lines = path.read_text().splitlines()
        self.blocks: list[Block] = []
        self.prose: list[tuple[int, str]] = []  # number and text of each line outside of code
        self._read()

    def _read(self) -> None:
        block: Block | None = None
        for number, line in enumerate(self.lines, 1):
            fence = line.strip()
            if block is None and fence.startswith("```"):
                before = next((text for _, text in reversed(self.prose) if text.strip()), "")
                block = Block(fence.strip("`"), number + 1, "", before)
            elif block is not None and fence == "```":
                self.blocks.append(block)
                block = None
            elif block is not None:
                block.text += line + "\n"
            else:
                self.prose.append((number, line))

    def links(self) -> Iterator[tuple[int, str]]:
        """Line and target of each link and picture that is a file or a heading."""
        for number, line in self.prose:
            for target in LINK.findall(re.sub(r"`[^`]*`", "", line)):
                if "://" not in target:
                    yield number, target

    def anchors(self) -> set[str]:
        """Of the headings, as GitHub and the site name them."""
        titles = [found[1] for _, line in self.prose if (found := HEADING.match(line))]
        plain = [re.sub(r"[^\w\- ]", "", title.lower()) for title in titles]
        return {title.strip().replace(" ", "-") for title in plain}

    def commands(self) -> Iterator[tuple[int, str, str]]:
        """Line, verb and arguments of each `./steadyhand` in code; a line that ends with `\\` continues."""
        text = "\n".join(self.lines)
        for found in COMMAND.finditer(re.sub(r"\\\n", "  ", text)):
            yield text[: found.start()].count("\n") + 1, found[1], found[2]

    def long_sentences(self, words: int) -> list[str]:
        """Sentences of more than so many words. A link counts as its text, an item of a list as a paragraph."""
        paragraphs, last = [""], 0
        for number, line in self.prose:
            indented_code = line.startswith("    ") and not paragraphs[-1]
            if number != last + 1 or not line.strip() or NOT_PROSE.match(line) or indented_code:
                paragraphs.append("")
            elif BEGINS_ITEM.match(line):
                paragraphs.append(BEGINS_ITEM.sub("", line))
            else:
                paragraphs[-1] += " " + line.strip()
            last = number
        plain = [re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"`[^`]*`", "Code", text)) for text in paragraphs]
        found = [sentence.strip() for text in plain for sentence in END_OF_SENTENCE.split(text)]
        return [sentence for sentence in found if len(sentence.split()) > words]
