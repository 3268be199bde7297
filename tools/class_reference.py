"""Writes the class reference of extension/doc_classes as a C++ source, for the editor's help."""

from pathlib import Path

DELIMITER = "steadyhand_xml"


def write_source(target: Path, pages: list[Path]) -> None:
    """Defines STEADYHAND_DOC_XML: one XML text for each class, then a null pointer."""
    texts = [f'R"{DELIMITER}({page.read_text()}){DELIMITER}",' for page in pages]
    lines = [
        "extern const char *const STEADYHAND_DOC_XML[];",
        "const char *const STEADYHAND_DOC_XML[] = {",
        *texts,
        "nullptr };",
    ]
    text = "\n".join(lines) + "\n"
    if not target.exists() or target.read_text() != text:
        target.write_text(text)
