# Shared by the tests beside it: a folder to install into, and programs that use what is there.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$1 source=$2 compiler=$3 generator=${4:-Unix Makefiles}
work=$(mktemp -d)
prefix=$work/usr
trap 'rm -rf "$work"' EXIT

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

# logged COMMAND...: says what the command printed only where it fails.
logged() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; fail "$*"; }; }

install_from() { logged cmake --install "$1" --prefix "$prefix"; }

# What is installed is the public face and nothing else; each header can be included alone.
check_headers() {
    [ "$(ls "$prefix/include")" = walkcycle ] || fail "headers outside of include/walkcycle"
    (cd "$prefix/include" && find walkcycle -name '*.h' | sort) >"$work/headers"
    (cd "$source/include" && find walkcycle -name '*.h' | sort) | diff - "$work/headers" || fail "other headers than include/ has"
    xargs -P 2 -I HEADER "$compiler" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I "$prefix/include" -include HEADER -x c++ /dev/null \
        <"$work/headers" || fail "a header that cannot be included alone"
}

# build_consumer NAME: a project that uses find_package(walkcycle).
build_consumer() {
    logged cmake -S "$work/$1" -B "$work/$1/build" -G "$generator" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler" \
        -DCMAKE_BUILD_TYPE=Debug
    logged cmake --build "$work/$1/build"
}

# run_loads PROGRAM: on a good file and on none.
run_loads() {
    "$1" "$source/res/walker.dae" | grep -q pelvis || fail "$1 walker.dae"
    "$1" "$work/nobody.dae" 2>"$work/err" && fail "$1 loads a file that is not there"
    grep -q '^LoadError: .*nobody.dae' "$work/err" || fail "$1 nobody.dae: $(cat "$work/err")"
    if ldd "$1" | grep -E 'libGL|libEGL|libepoxy|libglfw'; then fail "$1 only loads, but needs OpenGL"; fi
}

run_draws() {
    "$1" "$source/res/walker.dae" "$work/walk.png" || fail "$1"
    [ "$(head -c 4 "$work/walk.png" | tail -c 3)" = PNG ] || fail "$1 wrote no picture"
}

consumers() {
    cp -r "$here/loaders" "$here/all" "$work"
    cp "$source/examples/walk_to_png.cpp" "$work/all"
    build_consumer loaders
    run_loads "$work/loaders/build/loads"
    build_consumer all
    run_draws "$work/all/build/walk_to_png"
}

with_pkg_config() {
    PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name walkcycle.pc)")
    export PKG_CONFIG_PATH
    local flags
    flags=$(pkg-config --cflags --libs walkcycle-loaders) || fail "pkg-config walkcycle-loaders"
    # shellcheck disable=SC2086
    logged "$compiler" -std=c++20 -I "$here/loaders" "$here/loaders/main.cpp" -o "$work/loads" $flags
    run_loads "$work/loads"
    flags=$(pkg-config --cflags --libs walkcycle) || fail "pkg-config walkcycle"
    # shellcheck disable=SC2086
    logged "$compiler" -std=c++20 "$source/examples/walk_to_png.cpp" -o "$work/draws" $flags
    run_draws "$work/draws"
}
