"""Common style of all pictures."""

import logging
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import font_manager
from matplotlib import pyplot as plt
from matplotlib.figure import Figure
from whole_file import whole

__all__ = ["BLACK", "BLUE", "GREEN", "GREY", "ORANGE", "PURPLE", "SKY", "VERMILION", "plt", "save"]

# Okabe and Ito's palette, which colour-blind people can distinguish.
BLACK, ORANGE, SKY, GREEN = "#000000", "#e69f00", "#56b4e9", "#009e73"
BLUE, VERMILION, PURPLE, GREY = "#0072b2", "#d55e00", "#cc79a7", "#999999"

# Fonts of tools/requirements/debian-fonts.txt for letters that matplotlib's own font does not have: Chinese, Japanese
# and Korean first, then any letter.
FALLBACKS = {"DroidSansFallbackFull.ttf": "Droid Sans Fallback", "unifont.otf": "Unifont"}
# The fallbacks have no bold. Matplotlib then takes the plain font, and warns of it at each bold text.
logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)
# Matplotlib's list of fonts may be older than these fonts.
installed = {Path(path).name: path for path in font_manager.findSystemFonts()}
for name in FALLBACKS.keys() & installed.keys():
    font_manager.fontManager.addfont(installed[name])
families = [family for name, family in FALLBACKS.items() if name in installed]

plt.rcParams.update(
    {
        "font.family": ["DejaVu Sans", *families],  # the first is matplotlib's own
        "font.size": 11,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.alpha": 0.25,
    }
)


def save(figure: Figure, path: Path) -> None:
    """Writes in one step, so that no incomplete file appears.

    Ends the program with one line if that fails.
    """
    try:
        with whole(path) as part:
            figure.savefig(part, dpi=150, format="png")
    except OSError as fault:
        sys.exit(f"{path}: the picture cannot be written: {fault.strerror or fault}")
    plt.close(figure)
