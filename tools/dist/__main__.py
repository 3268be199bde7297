"""Builds the add-on for several platforms and writes its zip: python3 -m dist --out DIR --platform PLATFORM.ARCH,..."""

import argparse
import subprocess
import sys
from pathlib import Path

from dist import addon


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, required=True, help="folder of the zip")
    parser.add_argument("--platform", required=True, help=", ".join(addon.STRIP))
    arguments = parser.parse_args()
    wanted = arguments.platform.split(",")
    for one in wanted:
        name, arch = one.split(".")
        for target in addon.TARGETS:
            print(f"== building {one}, {target}", file=sys.stderr, flush=True)
            options = [f"platform={name}", f"arch={arch}", f"target={target}", "extension"]
            if (status := subprocess.run(["scons", "-Q", *options], cwd=addon.ROOT).returncode) != 0:
                return status
    path = arguments.out / f"steadyhand-{addon.version()}.zip"
    addon.write(path, wanted)
    print(f"{path}: {path.stat().st_size / 1e6:.1f} MB, {', '.join(wanted)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
