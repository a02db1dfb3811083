#!/usr/bin/env bash
# Installs what was built, and uses it as a user does: the program from another directory, on good and bad paths, and the
# library from a project of its own.
#   installed_test.bash CMAKE BUILD_FOLDER
set -euo pipefail

cmake=$1
build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "FAILED: $1" >&2
    exit 1
}
# expect CODE ARGUMENTS...: the program's exit code; what it says goes to out and err.
expect() {
    local wanted=$1 got=0
    shift
    "$work/prefix/bin/walkcycle" "$@" >"$work/out" 2>"$work/err" </dev/null || got=$?
    [ $got = "$wanted" ] || fail "walkcycle $* ended with $got, not $wanted: $(head -c 500 "$work/err")"
}
says() { grep -q -- "$1" "$work/$2" || fail "no '$1' in: $(head -c 500 "$work/$2")"; }

"$cmake" --install "$build" --prefix "$work/prefix" >"$work/install.log"
mkdir "$work/Käfer und Füchse"
cd "$work/Käfer und Füchse"  # file names in any language
cp "$work"/prefix/share/walkcycle/walker.* .
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

mkdir "$work/consumer"
cat >"$work/consumer/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(consumer CXX)
find_package(walkcycle REQUIRED)
add_executable(consumer consumer.cpp)
target_link_libraries(consumer PRIVATE walkcycle::walkcycle)
END
cat >"$work/consumer/consumer.cpp" <<'END'
#include <walkcycle/walkcycle.h>
int main(int, char** arguments) { return walkcycle::loadCollada(arguments[1]).animations.size() == 1 ? 0 : 1; }
END
"$cmake" -S "$work/consumer" -B "$work/consumer/build" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_BUILD_TYPE=Debug \
    ${SANITIZE:+-DCMAKE_CXX_FLAGS=-fsanitize=$SANITIZE} >"$work/configure.log" || fail "$(cat "$work/configure.log")"
"$cmake" --build "$work/consumer/build" >"$work/build.log" || fail "$(cat "$work/build.log")"
"$work/consumer/build/consumer" walker.dae || fail "the consumer does not load the walker"
echo "installed, used, and linked against"
