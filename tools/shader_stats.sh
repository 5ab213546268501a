#!/usr/bin/env bash
# What Mesa's compilers for phones make of every shader, without a phone: builds the program, runs `effigy-lab shader-stats` on
# emulated Adreno and Mali devices, and prints a table. Nothing runs on those devices.
# usage: tools/shader_stats.sh DRIVERS [FILE.csv]
#   DRIVERS   a folder with two programs, `adreno GPU_ID COMMAND…` and `mali GPU_ID COMMAND…`, that run a command with Mesa's turnip or
#             panvk over a kernel that does nothing (Mesa's drm-shim), as those drivers' own option `-Dtools=drm-shim` builds them
#   FILE.csv  where to write the numbers: of all pipelines of a shader, the worst (docs/experiments/data/shaders.csv has the last)
# EFFIGY_LAB=PROGRAM uses a laboratory that is built already.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
[ $# = 1 ] || [ $# = 2 ] || { usage >&2; exit 2; }
case $1 in -*) usage >&2; exit 2 ;; esac
drivers=$1
[ -x "$drivers/adreno" ] && [ -x "$drivers/mali" ] || { echo "$drivers has no programs \`adreno\` and \`mali\`" >&2; exit 2; }
[ -n "${EFFIGY_LAB:-}" ] || need_rust
effigy_lab --version >/dev/null
lab=$EFFIGY_LAB
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
limit=${EFFIGY_STATS_SECONDS:-300}

# All rows: device, shader, program of the driver's, statistic, value.
adreno() { # GPU_ID
  timeout "$limit" "$drivers/adreno" "$1" "$lab" shader-stats --csv "$work/one.csv" >/dev/null 2>"$work/log" ||
    { tail -n 3 "$work/log" >&2; return 1; }
  awk -F, -v OFS=, -v device="Adreno $1" 'NR > 1 { print device, $2, $4, $6, $7 }' "$work/one.csv"
}
# Mesa 25.0's panvk tells the size of the code only, and prints the rest in the order of compilation; for Bifrost it declares Vulkan 1.0.
mali() { # GPU_ID NAME
  MESA_VK_VERSION_OVERRIDE=1.1 timeout "$limit" "$drivers/mali" "$1" "$lab" -vv shader-stats >/dev/null 2>"$work/log" ||
    { tail -n 3 "$work/log" >&2; return 1; }
  awk -v OFS=, -v device="Mali $2" '
    / compiling / { sub(/.* compiling /, ""); split($1, file, "+") }
    /^SHADER-DB: / {
      stage = $2; sub(/MESA_SHADER_/, "", stage)
      shader = stage == "FRAGMENT" && file[2] != "" ? file[2] : file[1]
      sub(/.* shader: /, "")
      count = split($0, parts, ", ")
      for (i = 1; i <= count; ++i) {
        split(parts[i], words, " ")
        if (split(words[2], names, ":") == 2) {
          split(words[1], values, ":")
          print device, shader, stage, names[1], values[1]
          print device, shader, stage, names[2], values[2]
        } else {
          print device, shader, stage, words[2], words[1]
        }
      }
    }' "$work/log"
}
{
  for id in 630 660 740; do adreno $id; done
  mali 7402 G52
  mali a867 G610
} > "$work/all.csv"

# The same names for both makers, and of several pipelines the worst: the most of everything, the fewest waves.
awk -F, -v OFS=, '
  BEGIN {
    column["Instruction Count"] = column["inst"] = 1; column["Registers used"] = 2; column["Half-registers used"] = 3
    column["Max Waves Per Core"] = column["threads"] = 4
    column["Estimated cycles stalled on SS"] = 5; column["Estimated cycles stalled on SY"] = 6; column["cycles"] = 7
    column["STP Count"] = column["spills"] = 8; column["LDP Count"] = column["fills"] = 9
  }
  !($4 in column) { next }
  {
    key = $1 OFS $2 OFS $3; at = column[$4]
    if (!(key in seen)) { seen[key] = 1; order[++keys] = key }
    known = (key, at) in worst
    if (!known || (at == 4 ? $5 < worst[key, at] : $5 > worst[key, at])) worst[key, at] = $5 + 0
  }
  END {
    print "device,shader,program,instructions,registers,half_registers,waves,stalled_short,stalled_memory,cycles,spills,fills"
    for (k = 1; k <= keys; ++k) {
      line = order[k]
      for (at = 1; at <= 9; ++at) line = line OFS worst[order[k], at]
      print line
    }
  }' "$work/all.csv" > "$work/worst.csv"
[ $# = 1 ] || cp "$work/worst.csv" "$2"

# A line a program and a column a device.
awk -F, '
  NR == 1 || $4 == 0 { next }
  {
    program = $3 ~ /^Binning/ ? "binning" : $3 == "POSITION" || $3 == "VARYING" ? tolower($3) : ""
    row = $2 (program == "" ? "" : ", " program)
    if (!(row in seen)) { seen[row] = 1; rows[++count] = row }
    if (!($1 in known)) { known[$1] = 1; devices[++wide] = $1 }
    spilled = $11 + $12 > 0 ? ", **" $11 ":" $12 " spilled**" : ""
    cell[row, $1] = ($10 == "" ? $4 ", " $5 " r, " $7 " w" : $4 ", " sprintf("%.4g", $10) " c, " $7 " t") spilled
  }
  END {
    line = "| shader |"; rule = "|---|"
    for (d = 1; d <= wide; ++d) { line = line " " devices[d] " |"; rule = rule "---|" }
    print line; print rule
    for (r = 1; r <= count; ++r) {
      line = "| " rows[r] " |"
      for (d = 1; d <= wide; ++d) line = line " " ((rows[r], devices[d]) in cell ? cell[rows[r], devices[d]] : "–") " |"
      print line
    }
  }' "$work/worst.csv"
