"""A page of the class reference: extension/doc_classes/NAME.xml as Markdown."""

import html
import re
import textwrap
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

PAGES = Path(__file__).resolve().parents[2] / "extension/doc_classes"
GODOT = "https://docs.godotengine.org/en/stable/classes/class_"
CODE_BLOCK = re.compile(r"\s*\[codeblock\]\n(.*?)\[/codeblock\]\s*", re.DOTALL)
REFERENCE = re.compile(r"\[(member|method|signal|constant|enum) ([\w@.]+)\]")
CLASS = re.compile(r"\[(@?[A-Z]\w+)\](?!\()")
PARAMETER = re.compile(r"\[param (\w+)\]")
PLAIN = {"[code]": "`", "[/code]": "`", "[i]": "*", "[/i]": "*", "[b]": "**", "[/b]": "**"}


def read_classes() -> dict[str, Element]:
    return {path.stem: ElementTree.parse(path).getroot() for path in sorted(PAGES.glob("*.xml"))}


def as_markdown(name: str, classes: dict[str, Element]) -> str:
    page = classes[name]

    def text(element: Element | None) -> str:
        return to_markdown((element.text or "") if element is not None else "", name, classes)

    parts = [f"# {name}", f"Inherits {link(page.get('inherits', ''), classes)}.", text(page.find("brief_description"))]
    parts.append(text(page.find("description")))
    members = page.findall("members/member")
    parts += ["## Properties"] if members else []
    for member in members:
        parts += [f"### {member.get('name')}", declaration(member, classes), text(member)]
    for kind in ("method", "signal"):
        found = page.findall(f"{kind}s/{kind}")
        parts += [f"## {kind.capitalize()}s"] if found else []
        for entry in found:
            parts += [f"### {entry.get('name')}", signature(entry, classes), text(entry.find("description"))]
    enums = dict.fromkeys(constant.get("enum", "") for constant in page.findall("constants/constant"))
    for enum in enums:
        parts += [f"## enum {enum}"]
        own = [constant for constant in page.findall("constants/constant") if constant.get("enum", "") == enum]
        rows = [f"| <a id='{c.get('name')}'></a>`{c.get('name')}` | {c.get('value')} | {text(c)} |" for c in own]
        parts += ["\n".join(["| constant | value | meaning |", "| --- | ---: | --- |", *rows])]
    return "\n\n".join(part for part in parts if part) + "\n"


def declaration(member: Element, classes: dict[str, Element]) -> str:
    default = member.get("default")
    ending = f" = `{html.unescape(default)}`" if default else ""
    return f"{type_of(member, classes)}{ending}" + ("" if member.get("setter") else " (read only)")


def signature(entry: Element, classes: dict[str, Element]) -> str:
    parameters = []
    for parameter in entry.findall("param"):
        default = f" = {parameter.get('default')}" if parameter.get("default") else ""
        parameters.append(f"{parameter.get('name')}: {type_of(parameter, classes)}{default}")
    returned = entry.find("return")
    ending = f" → {type_of(returned, classes)}" if returned is not None and returned.get("type") != "void" else ""
    return f"({', '.join(parameters)}){ending}"


def type_of(element: Element, classes: dict[str, Element]) -> str:
    if enum := element.get("enum"):
        owner, _, own = enum.rpartition(".")
        return f"[{enum}]({owner}.md#enum-{own.lower()})" if owner in classes else f"`{enum}`"
    kind = element.get("type", "")
    array = kind.endswith("[]")
    return link(kind.removesuffix("[]"), classes) + (r"\[\]" if array else "")


def link(name: str, classes: dict[str, Element]) -> str:
    if name in classes:
        return f"[{name}]({name}.md)"
    return f"[{name}]({GODOT}{name.lower()}.html)"


def to_markdown(text: str, own: str, classes: dict[str, Element]) -> str:
    """BBCode of a description, whose lines are paragraphs."""
    parts = CODE_BLOCK.split(textwrap.dedent(text.expandtabs(4)).strip())
    paragraphs = []
    for index, part in enumerate(parts):
        if index % 2:
            paragraphs.append(f"```gdscript\n{textwrap.dedent(part).rstrip()}\n```")
        else:
            paragraphs += [inline(line.strip(), own, classes) for line in part.splitlines() if line.strip()]
    return "\n\n".join(paragraphs)


def inline(text: str, own: str, classes: dict[str, Element]) -> str:
    text = text.replace("<", "&lt;").replace("*", r"\*")
    text = REFERENCE.sub(lambda found: reference(found[1], found[2], own, classes), text)
    text = CLASS.sub(lambda found: link(found[1], classes), text)
    text = PARAMETER.sub(r"`\1`", text)
    for tag, mark in PLAIN.items():
        text = text.replace(tag, mark)
    return text


def reference(kind: str, target: str, own: str, classes: dict[str, Element]) -> str:
    """A link to a part of a class; to what the engine's own classes have, only to their page."""
    owner, _, name = target.rpartition(".")
    owner = owner or own
    if owner not in classes:
        page = owner.lower().replace("@", "%40")
        return f"[{name}]({GODOT}{page}.html)"
    while kind != "enum" and not defines(classes[owner], name) and classes[owner].get("inherits") in classes:
        owner = classes[owner].get("inherits", "")
    if kind == "constant" and not defines(classes[owner], name):
        return f"[{name}]({GODOT}%40globalscope.html)"
    anchor = f"enum-{name.lower()}" if kind == "enum" else name if kind == "constant" else name.lower()
    return f"[{name}]({owner}.md#{anchor})"


def defines(page: Element, name: str) -> bool:
    return any(entry.get("name") == name for entry in page.iter())
