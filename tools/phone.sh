#!/usr/bin/env bash
# A phone's verdict over adb: installs the app, has it survey the phone for three minutes, and makes the page that
# tools/gpu.sh makes of a GPU. Leave the phone alone meanwhile.
# usage: tools/phone.sh [APK [OUT_DIR]]      [default: target/apk/effigy.apk, made where it is missing; target/phone]
# OUT_DIR then has survey.json, as the app wrote it, verdict.json and verdict.md: docs/gpu.md says what is in them.
# Needs a phone with USB debugging. ANDROID_SERIAL names one of several. MINUTES=N measures shorter or longer.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
case ${1:-} in -*) usage >&2; exit 2 ;; esac
apk=${1:-target/apk/effigy.apk} out=${2:-target/phone} minutes=${MINUTES:-3}
file=/sdcard/Android/data/app.effigy/files/effigy-survey.json
# A phone that is slower than planned gets three times as long.
limit=$(awk -v minutes="$minutes" 'BEGIN { printf "%d", 200 * minutes }')
need 'command -v adb' adb
[ -s "$apk" ] || tools/apk.sh --release "$apk"
mkdir -p "$out"; rm -f "$out"/{survey.json,verdict.json,verdict.md}

adb install -r "$apk" >/dev/null
adb shell rm -f "$file"
adb shell input keyevent KEYCODE_WAKEUP
adb shell am start -S -n app.effigy/android.app.NativeActivity --ef survey "$minutes" >/dev/null
echo "measuring, $minutes minutes; a locked screen has to be unlocked"
began=$SECONDS
until adb pull "$file" "$out/survey.json" >/dev/null 2>&1 && grep -q '"over":true' "$out/survey.json"; do
  [ $((SECONDS - began)) -lt "$limit" ] || { echo "the survey is not over after $limit s: this is what there is" >&2; break; }
  sleep 2
done
[ -s "$out/survey.json" ] || { echo "the app has written nothing: is the phone unlocked? adb logcat -s effigy" >&2; exit 1; }
failed=0
effigy_lab verdict "$out/survey.json" --json "$out/verdict.json" --markdown "$out/verdict.md" || failed=1
echo "$out/verdict.md"
exit $failed
