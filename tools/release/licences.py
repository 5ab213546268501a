"""Writes the licences of every crate that a program, or several, is linked from.

usage: licences.py TARGET PACKAGE[,PACKAGE...] [FEATURE...] > FILE

The crates are those that `cargo tree` names for the target without build and development
dependencies; the texts are the files that each crate ships. A crate that ships none is listed with
the name of its licence. A crate without any licence fails the release.
"""

import json
import pathlib
import subprocess
import sys

NAMES = ("license", "licence", "copying", "notice", "unlicense", "ofl", "ufl")


def cargo(*arguments):
    return subprocess.run(["cargo", *arguments], check=True, capture_output=True, text=True).stdout


def main():
    target, package, *features = sys.argv[1:]
    tree = cargo(
        "tree", *(f"--package={name}" for name in package.split(",")), "--target", target, "--edges", "normal,no-proc-macro",
        "--features", ",".join(features), "--prefix", "none", "--format", "{p}",
    )
    linked = set()
    for line in tree.splitlines():
        if line.strip():
            name, version, *_ = line.split()
            linked.add((name, version.removeprefix("v")))
    metadata = json.loads(cargo("metadata", "--format-version", "1"))
    texts, unlicensed = {}, []
    for crate in sorted(metadata["packages"], key=lambda crate: (crate["name"], crate["version"])):
        name = (crate["name"], crate["version"])
        if name not in linked or crate["source"] is None:
            continue
        if not crate["license"] and not crate["license_file"]:
            unlicensed.append(" ".join(name))
            continue
        folder = pathlib.Path(crate["manifest_path"]).parent
        files = sorted(
            file for file in [*folder.iterdir(), *folder.glob("fonts/*")]
            if file.is_file() and file.suffix not in (".rs", ".ttf") and file.name.lower().startswith(NAMES)
        )
        text = "\n\n".join(file.read_text(errors="replace").strip() for file in files)
        entry = texts.setdefault(text, [])
        entry.append(f"{crate['name']} {crate['version']} ({crate['license'] or 'see below'})")
    if unlicensed:
        sys.exit(f"no licence is known of: {', '.join(unlicensed)}")
    print("The licences of the crates that this program is linked from.")
    for text, crates in sorted(texts.items(), key=lambda entry: entry[1]):
        print("\n" + "=" * 80)
        print("\n".join(crates))
        print("-" * 80)
        print(text or "These crates ship no text. Effigy's LICENSE-MIT and LICENSE-APACHE have the same terms.")


main()
