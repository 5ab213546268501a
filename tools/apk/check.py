#!/usr/bin/env python3
"""check.py APK --mode debug|release --tools PREFIX --system FOLDER: looks at a package as a store and a phone would.

PREFIX goes before the names of the SDK's tools; FOLDER/ABI holds the system libraries of the oldest Android that the app is for."""
import argparse
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zipfile

PAGE = 16384
ENTRY = "ANativeActivity_onCreate"


def fail(text):
    sys.exit(f"the package is not fit to install: {text}")


def said(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        fail(f"{' '.join(command[:2])}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


def functions(library):
    """Names that a library exports, and those that it wants of others."""
    given, wanted = set(), set()
    for line in said("readelf", "--dyn-syms", "--wide", library).splitlines():
        part = line.split()
        if len(part) >= 8 and part[0].rstrip(":").isdigit() and part[4] in ("GLOBAL", "WEAK"):
            (wanted if part[6] == "UND" else given).add(part[7].split("@")[0])
    return given, wanted


def check_library(name, library, system):
    given, wanted = functions(library)
    if ENTRY not in given:
        fail(f"{name} has no {ENTRY}")
    for export in given - {ENTRY}:
        if not re.match(r"(Java_|JNI_|ANativeActivity_|GameActivity_|android_main$|rust_eh_personality$)", export):
            fail(f"{name} exports {export}, which nobody asks for")
    needed = re.findall(r"NEEDED.*\[(.*)\]", said("readelf", "--dynamic", "--wide", library))
    public = {path.name for path in system.glob("lib*.so")}
    known = set().union(*(functions(str(system / lib))[0] for lib in needed if lib in public))
    if unknown := [lib for lib in needed if lib not in public]:
        fail(f"{name} needs {unknown}, which Android does not have for apps")
    if missing := sorted(wanted - known):
        fail(f"{name} imports {missing}, which the oldest Android that it is for does not have")
    for line in said("readelf", "--program-headers", "--wide", library).splitlines():
        if line.split()[:1] == ["LOAD"] and int(line.split()[-1], 16) % PAGE:
            fail(f"{name} is not made for pages of 16 KiB: {line.strip()}")
    print(f"  {name}: {pathlib.Path(library).stat().st_size} bytes, needs {' '.join(needed)}, {len(wanted)} imports")


def check_archive(apk, system):
    raw = pathlib.Path(apk).read_bytes()
    with zipfile.ZipFile(apk) as archive, tempfile.TemporaryDirectory() as folder:
        names = archive.namelist()
        for asset in ("assets/demo.avatar", "assets/demo.motion"):
            if asset not in names:
                fail(f"{asset} is missing")
        libraries = [item for item in archive.infolist() if item.filename.endswith(".so")]
        if not libraries:
            fail("it holds no library")
        for item in libraries:
            name, extra = struct.unpack_from("<HH", raw, item.header_offset + 26)
            start = item.header_offset + 30 + name + extra
            if item.compress_type or start % PAGE:
                fail(f"{item.filename} is compressed or begins at {start}: it can't be mapped from pages of 16 KiB")
            check_library(item.filename, archive.extract(item, folder), system / item.filename.split("/")[1])


def check_manifest(apk, tools, mode):
    badging = said(f"{tools}aapt", "dump", "badging", apk)
    for wanted in ("package: name='app.effigy'", "sdkVersion:'28'", "targetSdkVersion:'35'", "launchable-activity: name='android.app.NativeActivity'",
                   "application-label:'Effigy'", "native-code: '"):
        if wanted not in badging:
            fail(f"its badging lacks {wanted}:\n{badging}")
    if ("application-debuggable" in badging) != (mode == "debug"):
        fail(f"a {mode} package must {'' if mode == 'debug' else 'not '}be debuggable")
    for wanted in ("uses-permission",):
        if wanted in badging:
            fail(f"it asks for a permission, and needs none:\n{badging}")
    tree = said(f"{tools}aapt2", "dump", "xmltree", "--file", "AndroidManifest.xml", apk)
    for wanted in ("configChanges", "android.app.lib_name", "extractNativeLibs", "android.intent.action.VIEW", "stateNotNeeded",
                   "com.android.graphics.injectLayers.enable"):
        if wanted not in tree:
            fail(f"its manifest lacks {wanted}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("apk")
    parser.add_argument("--mode", choices=["debug", "release"], required=True)
    parser.add_argument("--tools", default="")
    parser.add_argument("--system", required=True)
    given = parser.parse_args()
    said(f"{given.tools}zipalign", "-c", "4", given.apk)
    check_archive(given.apk, pathlib.Path(given.system))
    check_manifest(given.apk, given.tools, given.mode)
    signed = said(f"{given.tools}apksigner", "verify", "--verbose", "--min-sdk-version", "24", given.apk)  # from 28 on only v3 is looked at
    for scheme in ("v2", "v3"):
        if not re.search(rf"{scheme} scheme.*: true", signed):
            fail(f"it has no {scheme} signature:\n{signed}")
    print(f"  signed v2 and v3, {given.mode}, {pathlib.Path(given.apk).stat().st_size} bytes")


if __name__ == "__main__":
    main()
