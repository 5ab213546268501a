#!/usr/bin/env bash
# Gives a verdict on this machine's GPU, offline, in at most 9 minutes: tests with validation, sorts, rates, frames, training, a soak.
# Every step has a time limit, and the next one runs whatever became of it. A step that did not run never counts as passed.
# usage: run.sh OUT_DIR      writes OUT_DIR/verdict.json, verdict.md and logs.tar.gz; fails if a step did not pass
#   EFFIGY_GPU_SECONDS  time for everything [default: 530, and 1200 to rehearse]
#   EFFIGY_GPU_SHORT=1  the demo in small images, few of everything and longer limits, to rehearse on a CPU driver
#   VK_DRIVER_FILES     the driver's manifest; otherwise it is looked for
set -uo pipefail
[ $# = 1 ] && [ "${1#-}" = "$1" ] || { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd) || exit 1
mkdir -p "$1" && out=$(cd "$1" && pwd) || exit 1
work=$(mktemp -d) || exit 1
effigy=$here/bin/effigy
# Seconds that the verdict itself may take, and the least that is worth beginning a step.
verdict_seconds=15 least=5

# Loader and libraries of the bundle, caches of this run alone.
export LD_LIBRARY_PATH=${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}$here/lib
export XDG_CACHE_HOME=$work/cache HOME=${HOME:-$work}
# Mesa keeps compiled shaders where it is told to; none of an earlier run.
export MESA_SHADER_CACHE_DIR=$work/cache/mesa

# NVIDIA's driver where no manifest names it to the loader, as in containers: beside what else is there.
find_driver() {
  [ -z "${VK_DRIVER_FILES:-${VK_ICD_FILENAMES:-}}" ] || return 0
  local file library
  for file in /etc/vulkan/icd.d/*nvidia*.json /usr/share/vulkan/icd.d/*nvidia*.json /usr/local/share/vulkan/icd.d/*nvidia*.json; do
    [ ! -s "$file" ] || return 0
  done
  for file in /usr/local/nvidia/share/vulkan/icd.d/*.json; do
    [ ! -s "$file" ] || { export VK_ADD_DRIVER_FILES=$file; return 0; }
  done
  for library in libGLX_nvidia.so.0 libEGL_nvidia.so.0; do
    if ldconfig -p 2>/dev/null | grep -q "$library" || [ -e "/usr/local/nvidia/lib64/$library" ]; then
      printf '{"file_format_version": "1.0.0", "ICD": {"library_path": "%s", "api_version": "1.3.0"}}\n' "$library" > "$work/nvidia.json"
      export VK_ADD_DRIVER_FILES=$work/nvidia.json LD_LIBRARY_PATH=$LD_LIBRARY_PATH:/usr/local/nvidia/lib64
      return 0
    fi
  done
}
find_driver

{
  sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' /etc/os-release
  uname -srm
  sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | sort | uniq -c | sed 's/^ *//'
  command -v nvidia-smi >/dev/null && timeout 20 nvidia-smi --query-gpu=name,driver_version,memory.total,clocks.max.sm,clocks.max.mem --format=csv,noheader
  echo "driver manifest: ${VK_DRIVER_FILES:-${VK_ICD_FILENAMES:-those of the system ${VK_ADD_DRIVER_FILES:-}}}"
  echo "bundle: $(cat "$here/commit.txt" 2>/dev/null)"
} > "$work/machine.txt" 2>/dev/null

body=()
[ ! -s "$here/data/body.avatar" ] || body=("$here/data/body.avatar" --motion "$here/data/01_01.motion")
if [ -n "${EFFIGY_GPU_SHORT:-}" ]; then
  # The built-in demo, in so few pixels that a CPU driver and the reference keep up.
  body=() total=${EFFIGY_GPU_SECONDS:-1200} slower=3
  frames=(--size 192x192 --frames 3 --check 1 --spread 0) sweep=(--rounds 1)
  sorts=(--max-keys 16384 --keys 22 --runs 2) rates=(--size 256x256 --max-copy 8 --min-ms 2)
  soak_seconds=12 soak=(--size 192x192 --fps 0.5 --late 90) tests=(rates::) train=(--size 128x128 --views 2 --window 64 --seconds 1)
else
  total=${EFFIGY_GPU_SECONDS:-530} slower=1
  frames=(--size 2048x2048 --check 1 --spread 0) sweep=(--frames 16 --rounds 2)
  sorts=() rates=()
  soak_seconds=120 soak=(--size 2048x2048) tests=() train=(--seconds 12)
fi

# Name and most seconds of each step, in the order in which they run.
plan='
devices 45
rates 45
sorts 120
frames-quads 60
frames-tiles 60
tests 150
train 75
frames-cameras 30
exact-quads 45
exact-tiles 45
skips-quads 60
soak 150
'
# What no step before the soak may take of its time.
soak_reserve=$((soak_seconds + 20))
printf '%s\n' "$plan" | awk 'NF { print $1 }' > "$work/plan.txt"

# All whose frames are timed: what flickers is for the reference to say, which takes minutes.
cases=full,camera,orbit,expression,static,close,far30,far,far120,far240,four,crowd
bench() { # NAME ARGS...
  local name=$1; shift
  "$effigy" bench "${body[@]}" "${frames[@]}" --json "$work/bench-$name.json" "$@"
}
do_step() { # NAME SECONDS
  case $1 in
    devices) "$effigy" devices --json "$work/devices.json" && "$effigy" devices ;;
    rates) "$here/bin/effigy-lab" bench-device "${rates[@]}" --json "$work/rates.json" ;;
    sorts) "$here/bin/effigy-lab" bench-sort --subgroups --minutes 60 "${sorts[@]}" --json "$work/sorts.json" ;;
    tests)
      "$here/bin/gpu-tests" --list "${tests[@]}" > "$work/tests-list.txt" &&
        VK_LAYER_PATH=$here/layers VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC=1 EFFIGY_VALIDATION=1 \
          EFFIGY_PROGRAM=$here/bin/effigy EFFIGY_TEST_SECONDS=60 EFFIGY_TEST_LABEL=gpu EFFIGY_TEST_RESULTS=$work/tests.txt "$here/bin/gpu-tests" "${tests[@]}"
      ;;
    train) "$here/bin/effigy-lab" bench-train "${body[@]:0:1}" "${train[@]}" --json "$work/training.json" ;;
    frames-quads) bench quads --raster quads --case "$cases" ;;
    frames-tiles) bench tiles --raster tiles-shared --case "$cases" ;;
    frames-cameras) bench cameras --cameras "$here/data/cameras.json" --case full ;;
    exact-quads) bench exact-quads --raster quads --sweep exact "${sweep[@]}" ;;
    exact-tiles) bench exact-tiles --raster tiles-shared --sweep exact "${sweep[@]}" ;;
    skips-quads) bench skips-quads --raster quads --sweep skip-but "${sweep[@]}" ;;
    soak)
      # What is left once the device is open and the last frame is compared.
      local seconds=$(($2 - 20)); [ $seconds -lt $soak_seconds ] || seconds=$soak_seconds
      [ $seconds -ge 10 ] || { echo "error: no time is left for a soak"; return 1; }
      [ $seconds = $soak_seconds ] || echo "note: shortened to $seconds s"
      "$effigy" soak "${body[@]}" "${soak[@]}" --minutes "$(awk "BEGIN { print $seconds / 60 }")" --out "$work/soak"
      ;;
  esac
}
export -f bench do_step

# A step in a shell of its own, so that its time limit covers all of it. Arrays are not exported: they travel as text.
settings=$(declare -p work here effigy body cases frames sweep sorts rates soak soak_seconds tests train)
run_step() { # NAME LIMIT
  local name=$1 limit=$(($2 * slower)) left=$((total - verdict_seconds - SECONDS)) begin=$SECONDS code=0 outcome note=''
  [ "$name" = soak ] || left=$((left - soak_reserve))
  [ "$limit" -le "$left" ] || limit=$left
  if [ "$limit" -lt $least ]; then
    printf '%s\tnot-run\t0\t%s\tno time was left\n' "$name" $(($2 * slower)) >> "$work/steps.tsv"
    echo "$name: did not run, no time was left"
    return
  fi
  timeout -k 5 "$limit" bash -c "$settings; set -o pipefail; do_step $name $limit" > "$work/$name.log" 2>&1 < /dev/null || code=$?
  case $code in
    0) outcome=passed note=$(sed -n 's/^note: //p' "$work/$name.log" | head -n 1) ;;
    124 | 137) outcome=timed-out note="stopped after $limit s" ;;
    *)
      outcome=failed
      note=$(grep -a '^error: ' "$work/$name.log" | tail -n 1 | cut -c 1-300 | tr '\t' ' ')
      note=${note:-exit code $code}
      ;;
  esac
  printf '%s\t%s\t%s\t%s\t%s\n' "$name" $outcome $((SECONDS - begin)) "$limit" "$note" >> "$work/steps.tsv"
  echo "$name: $outcome, $((SECONDS - begin)) s${note:+ ($note)}"
}

# What was measured so far comes back, whatever ends the run.
finish() {
  trap - EXIT
  timeout -k 5 $verdict_seconds "$here/bin/effigy-lab" verdict "$work" --json "$out/verdict.json" --markdown "$out/verdict.md"
  local code=$?
  rm -rf "$work/cache"
  tar czf "$out/logs.tar.gz" -C "$work" .
  rm -rf "$work"
  echo "$out: verdict.json, verdict.md, logs.tar.gz ($SECONDS s)"
  exit $code
}
trap finish EXIT
trap 'exit 1' INT TERM
while read -r name limit; do
  [ -z "$name" ] || run_step "$name" "$limit"
done <<< "$plan"
