# Shared by the scripts beside it: saying what happens, installing packages, configuring and building.

set -Eeuo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=$(nproc 2>/dev/null || echo 2)
current_step="starting"
export CCACHE_SLOPPINESS=pch_defines,time_macros  # or ccache passes by what uses precompiled headers
export CCACHE_DEPEND=1  # the compiler says what a file includes: ccache need not preprocess it first

step() {
    current_step=$1
    printf '\n== %s\n' "$1"
}

fail() {
    trap - ERR
    printf '%s: %s\n' "$(basename "$0")" "$1" >&2
    exit 1
}
trap 'fail "stopped at the step \"$current_step\"; the messages above say why."' ERR

# packages GROUP...: the names of those groups in scripts/packages.
packages() {
    local group
    for group in "$@"; do sed -n "s/^$group: //p" scripts/packages; done
}

is_installed() {
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        fail "these packages are missing and need root or sudo to install: ${missing[*]}"
    fi
}

# install GROUP...: installs what is missing of those groups, without a question.
install() {
    step "Installing what is missing ($*)"
    command -v dpkg-query >/dev/null || {
        echo "This is not Debian: going on with the libraries that are there. Needed: $(packages "$@" | tr '\n' ' ')"
        return 0
    }
    local package
    missing=()
    for package in $(packages "$@"); do
        is_installed "$package" || missing+=("$package")
    done
    if [ ${#missing[@]} = 0 ]; then
        echo "Nothing is missing."
        return 0
    fi
    echo "Missing: ${missing[*]}"
    as_root apt-get update -q
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}

release=(-DCMAKE_BUILD_TYPE=Release -DWALKCYCLE_PRECOMPILE=ON)  # the build in build/

# configure FOLDER [CMAKE OPTION...]: Ninja and ccache where they are there; a folder keeps the generator it has.
configure() {
    local folder=$1 generator=()
    shift
    if [ ! -e "$folder/CMakeCache.txt" ] && command -v ninja >/dev/null; then generator=(-G Ninja); fi
    if command -v ccache >/dev/null; then
        set -- "$@" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_C_COMPILER_LAUNCHER=ccache
    fi
    cmake -S . -B "$folder" "${generator[@]}" "$@"
}

# build FOLDER [TARGET]
build() {
    cmake --build "$1" --parallel "$jobs" ${2:+--target "$2"}
}
