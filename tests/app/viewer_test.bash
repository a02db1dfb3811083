#!/usr/bin/env bash
# Plays the walker in a window on a display in memory, presses keys, and looks at what the screen shows.
#   viewer_test.bash WALKCYCLE FILE
# Exits with 77 (to ctest: skipped) where Xvfb or xdotool is not installed.
set -euo pipefail

walkcycle=$1
document=$2
for tool in Xvfb xdotool; do
    command -v $tool >/dev/null || { echo "$tool is not installed"; exit 77; }
done

work=$(mktemp -d)
server= viewer=
stop_all() {
    for process in $viewer $server; do kill "$process" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$work"
}
trap stop_all EXIT
fail() {
    echo "FAILED: $1" >&2
    cat "$work/viewer.log" >&2 2>/dev/null || true
    exit 1
}

# The server keeps its screen in the file Xvfb_screen0, so a screenshot is a copy of it.
screenshot() { cp "$work/Xvfb_screen0" "$work/$1"; }
differing_bytes() { cmp -l "$work/$1" "$work/$2" 2>/dev/null | wc -l; }

# until_true SECONDS COMMAND...
until_true() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.2
    done
}
shows_a_window() {
    kill -0 "$viewer" 2>/dev/null || fail "the viewer ended by itself"
    screenshot now
    [ "$(differing_bytes empty now)" -gt 100000 ]
}
moves() {
    screenshot before
    sleep 0.4
    screenshot after
    [ "$(differing_bytes before after)" -gt 1000 ]
}
stands_still() {
    screenshot before
    sleep 0.6
    screenshot after
    [ "$(differing_bytes before after)" = 0 ]
}
differs_from() {
    screenshot now
    [ "$(differing_bytes "$1" now)" -gt 500 ]
}
has_ended() { ! kill -0 "$viewer" 2>/dev/null; }
title_has() { xdotool getwindowname "$window" 2>/dev/null | grep -q -e "$1"; }
title_lacks() { ! title_has "$1"; }
find_window() {
    window=$(xdotool search --onlyvisible --name "$(basename "$document" .dae)" | head -n 1)
    [ -n "$window" ] || fail "the window's title does not name the file"
    xdotool mousemove --window "$window" 40 40
    xdotool windowfocus "$window"
}

Xvfb -displayfd 3 -screen 0 1400x900x24 -fbdir "$work" -nolisten tcp 3>"$work/display" 2>"$work/server.log" &
server=$!
until_true 20 test -s "$work/display" || fail "Xvfb does not start: $(cat "$work/server.log")"
DISPLAY=:$(cat "$work/display")
export DISPLAY
unset WAYLAND_DISPLAY
screenshot empty

"$walkcycle" view "$document" >"$work/viewer.log" 2>&1 &
viewer=$!
until_true 60 shows_a_window || fail "nothing appears on the screen"
find_window

until_true 30 moves || fail "the walk does not play"

xdotool key space
until_true 20 stands_still || fail "Space does not pause"

screenshot paused
xdotool key period
until_true 20 differs_from paused || fail "the period does not step"
until_true 20 stands_still || fail "a step goes on by itself"

screenshot stepped
xdotool key shift+a
until_true 20 differs_from stepped || fail "Shift+A does not show the skeleton"

xdotool windowsize "$window" 700 500
xdotool key space
until_true 30 moves || fail "Space does not play on after the window was resized"

xdotool key minus
until_true 20 title_has "x0.79" || fail "the minus does not slow the walk down"
xdotool key BackSpace
until_true 20 title_lacks " - x" || fail "Backspace does not give the clip its own speed"

xdotool key q
until_true 20 has_ended || fail "Q does not close the window"
status=0
wait "$viewer" || status=$?
[ $status = 0 ] || fail "the viewer ended with exit code $status"
viewer=
# Once and backwards: from the clip's end to its start, where it stays until Space plays it again.
"$walkcycle" view "$document" --loop once --speed -1 >"$work/viewer.log" 2>&1 &
viewer=$!
until_true 60 shows_a_window || fail "nothing appears on the screen when it plays backwards"
find_window
until_true 30 title_has " - 0.00 / .* - x-1.00" || fail "played backwards, it does not come to the clip's start"
until_true 20 stands_still || fail "played once, it does not stop"
xdotool key space
until_true 20 moves || fail "Space does not play it again"
kill "$viewer"
until_true 20 has_ended || fail "a signal does not end the viewer"
wait "$viewer" || true

# A display that goes away under the window is an error of its own, not a hang.
"$walkcycle" view "$document" >"$work/viewer.log" 2>&1 &
viewer=$!
until_true 60 shows_a_window || fail "nothing appears on the screen the second time"
kill -KILL "$server"
until_true 20 has_ended || fail "the viewer goes on without a display"
status=0
wait "$viewer" || status=$?
viewer= server=
[ $status = 3 ] || fail "without its display, the viewer ended with exit code $status"
[ "$(cat "$work/viewer.log")" = "walkcycle: error: the display is gone" ] || fail "it does not say that the display is gone"
echo "played, paused, stepped, drew the skeleton, was resized, closed, and lost its display"
