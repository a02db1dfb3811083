#!/usr/bin/env bash
# Installs the build into a folder of its own, runs the installed program, and builds the examples against the
# installed library with find_package(walkcycle), as a user's project would.
#   install_test.bash BUILD_FOLDER SOURCE_FOLDER CXX_COMPILER
set -euo pipefail

build=$1 source=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "FAILED: $1" >&2
    exit 1
}

cmake --install "$build" --prefix "$work/usr" >"$work/install.log" || { cat "$work/install.log"; fail "cmake --install"; }
walkcycle=$work/usr/bin/walkcycle
cd /
"$walkcycle" check "$work/usr/share/walkcycle" || fail "the installed characters are not fine"
"$walkcycle" --version | grep -q '^walkcycle [0-9]' || fail "--version"
# With no file and no display, the message names the built-in character, which must be the installed one.
env -u DISPLAY -u WAYLAND_DISPLAY "$walkcycle" 2>"$work/no_display" && fail "a window without a display"
grep -q "$work/usr/share/walkcycle/walker.dae" "$work/no_display" || fail "the built-in character: $(cat "$work/no_display")"

mkdir "$work/user"
cp "$source"/examples/*.cpp "$work/user"
cat >"$work/user/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES C CXX)
find_package(walkcycle REQUIRED)
add_executable(walk_to_png walk_to_png.cpp)
target_link_libraries(walk_to_png walkcycle::walkcycle)
add_executable(print_joints print_joints.cpp)
target_link_libraries(print_joints walkcycle::loaders)
END
cmake -S "$work/user" -B "$work/user/build" -DCMAKE_PREFIX_PATH="$work/usr" -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_BUILD_TYPE=Debug >"$work/user.log" 2>&1 || { cat "$work/user.log"; fail "find_package(walkcycle)"; }
cmake --build "$work/user/build" >"$work/user.log" 2>&1 || { cat "$work/user.log"; fail "building with the library"; }
"$work/user/build/print_joints" "$work/usr/share/walkcycle/walker.dae" >/dev/null || fail "print_joints"
"$work/user/build/walk_to_png" "$work/usr/share/walkcycle/walker.dae" "$work/walk.png" || fail "walk_to_png"
[ -s "$work/walk.png" ] || fail "walk_to_png wrote no picture"
if ldd "$work/user/build/print_joints" | grep -qE 'libGL|libEGL|libepoxy|libglfw'; then
    fail "a program that only reads files needs OpenGL"
fi
echo "installed, ran, and built against"
