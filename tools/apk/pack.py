#!/usr/bin/env python3
"""pack.py IN.apk LIBRARIES OUT.apk: IN with the files of the folder LIBRARIES added under lib/, not compressed.

Each library begins on a page of 16 KiB, so that the system maps it straight out of the package. Field 0xd935 of its entry says so:
without it, older versions of apksigner move the library when they write their own copy."""
import pathlib
import struct
import sys
import zipfile

PAGE = 16384


def entry(name, stored, at):
    info = zipfile.ZipInfo(name)  # dated 1980: the same input makes the same package
    info.external_attr = 0o644 << 16
    info.compress_type = zipfile.ZIP_STORED if stored else zipfile.ZIP_DEFLATED
    if stored:
        align = PAGE if name.endswith(".so") else 4
        data = at + 30 + len(name.encode()) + 6  # after the entry's head, its name and the field's own head
        pad = -data % align
        info.extra = struct.pack("<HHH", 0xD935, 2 + pad, align) + bytes(pad)
    return info


def main(source, libraries, target):
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w", compresslevel=9) as new:
        for item in old.infolist():
            stored = item.compress_type == zipfile.ZIP_STORED
            new.writestr(entry(item.filename, stored, new.fp.tell()), old.read(item))
        for path in sorted(pathlib.Path(libraries).rglob("*.so")):
            name = "lib/" + path.relative_to(libraries).as_posix()
            new.writestr(entry(name, True, new.fp.tell()), path.read_bytes())


if __name__ == "__main__":
    main(*sys.argv[1:])
