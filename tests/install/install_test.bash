#!/usr/bin/env bash
# Installs the build into a folder of its own, runs the installed program on good and bad paths, and builds programs
# against the installed library: with find_package (loaders alone, and all) and with pkg-config.
#   install_test.bash BUILD_FOLDER SOURCE_FOLDER CXX_COMPILER
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# expect CODE ARGUMENTS...: the program's exit code; what it says goes to out and err.
expect() {
    local wanted=$1 got=0
    shift
    "$walkcycle" "$@" >"$work/out" 2>"$work/err" </dev/null || got=$?
    [ $got = "$wanted" ] || fail "walkcycle $* ended with $got, not $wanted: $(head -c 500 "$work/err")"
}
says() { grep -q -- "$1" "$work/$2" || fail "no '$1' in: $(head -c 500 "$work/$2")"; }

install_from "$build"
walkcycle=$prefix/bin/walkcycle
cd /
"$walkcycle" check "$prefix/share/walkcycle" || fail "the installed characters are not fine"
"$walkcycle" --version | grep -q '^walkcycle [0-9]' || fail "--version"
# With no file and no display, the message names the built-in character, which must be the installed one.
env -u DISPLAY -u WAYLAND_DISPLAY "$walkcycle" 2>"$work/no_display" && fail "a window without a display"
grep -q "$prefix/share/walkcycle/walker.dae" "$work/no_display" || fail "the built-in character: $(cat "$work/no_display")"
if grep -aq -e "$source/" -e "$build/" "$walkcycle"; then fail "the installed program names folders of its build"; fi

mkdir "$work/Käfer und Füchse"
cd "$work/Käfer und Füchse"  # file names in any language
cp "$prefix"/share/walkcycle/walker.* .
export LC_ALL=C

expect 0 --version
says walkcycle out
expect 0 --help
says render out
expect 0 info walker.dae
says walker out
expect 0 check walker.dae
expect 0 pose walker.dae --time 0.25 --json
says '"pelvis"' out
expect 0 render walker.dae -o walk.png --resolution 160,120 --time 0.25
[ "$(head -c 4 walk.png | tail -c 3)" = PNG ] || fail "walk.png is no PNG"
expect 0 explain WC0201

unset DISPLAY WAYLAND_DISPLAY
expect 3 view walker.dae
expect 2 info nobody.dae
says nobody.dae err
expect 2 render walker.dae -o nowhere/walk.png
[ ! -e nowhere ] || fail "a folder was made"
expect 2 render walker.dae --no-such-option -o walk2.png
expect 2 info .
head -c 2000 walker.dae >cut.dae
expect 1 check cut.dae
says 'cut.dae:[0-9]*: error WC0' err
expect 1 info cut.dae
printf 'hello' >hello.dae
expect 1 check hello.dae
[ "$(find . -name 'walk2*' -o -name '*.tmp*' | wc -l)" = 0 ] || fail "unfinished files were left"

check_headers
consumers
with_pkg_config
echo "installed, ran, and built against"
