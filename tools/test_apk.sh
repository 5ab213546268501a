#!/usr/bin/env bash
# Tests the Android app on this machine, without a phone: the package that is released, and the app's library, built
# for this processor, in a host harness that calls it as Android does.
# usage: tools/test_apk.sh [--package|--play] [LIVES [ORDERS]]      [default: both]
#   --package: makes the released package and checks it, its size too;  --play: runs the app
# LIVES: of the app, to play [default: 8], each of ORDERS random orders of 60 events [default: 4]. A life has 300 s, and
# 60 to bring the frames that a script waits for: other programs may be at work here too. What must answer at once
# (`limit`) must.
# The host harness is ../shared/android-host, with tools/android-host/more.patch on it: without it, --play fails.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
package=1 play=1
case ${1:-} in --package) play=''; shift ;; --play) package=''; shift ;; -*) usage >&2; exit 2 ;; esac
seeds=${1:-8} orders=${2:-4} host=../shared/android-host
most_apk=12000000 most_library=6000000
at_most() { # BYTES FILE
  [ "$(stat -c %s "$2")" -le "$1" ] || { echo "$2 is larger than $1 bytes" >&2; exit 1; }
}
if [ -n "$package" ]; then
  tools/apk.sh --release target/apk/effigy.apk
  at_most $most_apk target/apk/effigy.apk
  at_most $most_library target/apk/release/lib/arm64-v8a/libmain.so
fi
[ -n "$play" ] || exit 0
[ -d $host ] || {
  echo "the app can't be run: the host harness is not part of this repository, and there is no $host" >&2
  exit 1
}
tools/apk.sh --targets x86_64-linux-android target/apk/effigy-x86_64.apk
need 'command -v patch' patch
need 'command -v gcc && [ -s /usr/include/vulkan/vulkan.h ]' gcc libvulkan-dev libvulkan1
tools/drivers.sh
work=target/apk/host
rm -rf $work; mkdir -p $work/scripts
cp -r $host $work/player; chmod -R u+w $work/player
patch -s -d $work/player -p1 < tools/android-host/more.patch
for seed in $(seq 1 "$seeds"); do
  python3 tools/android-host/orders.py "$seed" "$orders" 60 > "$work/scripts/orders-$seed.txt"
done

library=target/apk/debug/lib/x86_64/libmain.so driver=target/drivers/mesa25.json assets=target/apk/debug/assets
failed=0
fail() { echo "FAILED $*"; failed=1; }
play() { # SCRIPT [VARIABLE=VALUE...]: plays a script in a folder of its own
  local name; name=$(basename "$1" .txt)
  if env "${@:2}" bash $work/player/run.sh $library $driver $assets "$work/$name" "$1" > "$work/$name.log" 2>&1 &&
    ! grep -qE "panicked|validation:|${refusal:-E/effigy}" "$work/$name.log" &&
    grep -q 'the activity is over' "$work/$name.log"; then
    echo "  $name"
  else
    fail "$name: $work/$name.log"; tail -n 25 "$work/$name.log"
  fi
}
export EFFIGY_VALIDATION=1 VK_LAYER_PATH=$PWD/target/drivers/layers VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC=1
for script in early destroy lifecycle picture touch pace; do play tools/android-host/scripts/$script.txt; done
play tools/android-host/scripts/timed.txt HOST_TIMING=1
play tools/android-host/scripts/soak.txt HOST_SOAK=5
for file in json csv; do
  [ -s $work/soak/data/soak.$file ] || fail "soak: it left no soak.$file"
done
# Surveys, of a tenth of their length: one to its end, one that the user leaves, one whose activity is destroyed in its soak.
survey() { # SCRIPT UNFINISHED...: its file is read as a page's, and names these steps as not finished, and nothing of this machine
  local name=$1 data=$work/$1/data/effigy-survey.json step; shift
  play "tools/android-host/scripts/$name.txt" HOST_SURVEY=0.3
  if effigy_lab verdict "$data" --markdown "$work/$name.md" > "$work/$name-verdict.log" 2>&1; then
    [ $# = 0 ] || fail "$name: it counts as complete"
  else
    [ $# != 0 ] || { fail "$name: it is not complete"; cat "$work/$name-verdict.log"; }
  fi
  for step; do grep -q "$step did not run" "$work/$name.md" || fail "$name: its page does not say that $step did not run"; done
  grep -q '"over":true' "$data" || fail "$name: its file does not say that it is over"
  ! grep -qF -e "$PWD" -e "$HOME" -e demo "$data" || fail "$name: its file names a path or an avatar"
}
survey survey
survey survey-left frames soak
survey survey-soak soak
grep -q '"lasted_seconds":[1-9]' $work/survey-soak/data/effigy-survey.json || fail "survey-soak: it does not keep its soak"
play tools/android-host/scripts/open.txt HOST_OPEN="$PWD/src/demo/demo.avatar"
[ "$(grep -c 'showing `' $work/open.log)" = 2 ] || fail "open: the file that was opened is not shown"
# Of other programs: an avatar, and motion for the demo.
for file in webavatar/small.npz motion/mixamo.bvh; do
  name=open-$(basename "${file%.*}")
  cp tools/android-host/scripts/open.txt "$work/scripts/$name.txt"
  play "$work/scripts/$name.txt" HOST_OPEN="$PWD/tests/data/$file"
  [ "$(grep -c 'showing `' "$work/$name.log")" = 2 ] || fail "$name: the file that was opened is not shown"
done
play tools/android-host/scripts/refused.txt HOST_OPEN="$PWD/README.md"
grep -q "the file that was opened can't be shown" $work/refused.log ||
  fail "refused: nothing is said of a file that can't be shown"
for seed in $(seq 1 "$seeds"); do play "$work/scripts/orders-$seed.txt"; done
unset EFFIGY_VALIDATION
refusal="F/effigy" play tools/android-host/scripts/refuse.txt HOST_VULKAN_10=1
grep -q "Vulkan 1.1 is needed" $work/refuse.log || fail "refuse: it does not say what the device lacks"
[ $failed = 0 ] || exit 1
VK_DRIVER_FILES=$PWD/target/drivers/mesa25.json VK_ICD_FILENAMES=$PWD/target/drivers/mesa25.json \
  effigy render --size 540x960 --out $work/rendered.png
effigy render --size 540x960 --reference --out $work/reference.png
python3 tools/android-host/compare.py $work $work/rendered.png $work/reference.png
# Once for the caches, once for the time from the activity's creation to its first frame.
mkdir -p $work/start/data
for run in first second; do
  bash $work/player/run.sh $library $driver $assets $work/start tools/android-host/scripts/start.txt \
    > $work/start.log 2>&1 || { tail -n 25 $work/start.log; exit 1; }
  # The verdict is worked out before it is printed: inside printf's arguments some awks take > for a file to write to.
  awk -v run=$run '/H\/host: onCreate$/ { from = $1 } /the first frame/ { took = $1 - from; late = ""
    if (took > 1) late = ": MORE THAN THE 1 s that it is to take; was this machine busy?"
    printf "  the %s start takes %.2f s to the first frame%s\n", run, took, late }' \
    $work/start.log
done
