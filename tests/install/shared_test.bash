#!/usr/bin/env bash
# Builds the library alone as shared libraries, installs it, and builds programs against it; then builds one with the
# library as a subproject. Without optimization and through the compiler cache, where there is one.
#   shared_test.bash BUILD_FOLDER SOURCE_FOLDER CXX_COMPILER
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# Folders that stay the same from run to run, for the compiler cache's sake.
shared=$build/install_test/shared parent=$build/install_test/parent
cache=()
if command -v ccache >/dev/null; then cache=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
settings=(-G "$generator" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS=-O0 -DCMAKE_CXX_FLAGS_DEBUG= -DCMAKE_POSITION_INDEPENDENT_CODE=ON "${cache[@]}")

logged cmake -S "$source" -B "$shared" "${settings[@]}" -DCMAKE_BUILD_TYPE=Debug -DBUILD_SHARED_LIBS=ON \
    -DBUILD_TESTING=OFF -DWALKCYCLE_BUILD_APP=OFF
[ ! -e "$shared/tests" ] || fail "BUILD_TESTING=OFF made tests"
logged cmake --build "$shared" --parallel
install_from "$shared"
[ ! -e "$prefix/bin" ] || fail "WALKCYCLE_BUILD_APP=OFF installed a program"

library=$(find "$prefix" -name libwalkcycle.so)
[ -n "$library" ] || fail "there is no libwalkcycle.so"
readelf -d "$library" | grep -q 'SONAME.*libwalkcycle\.so\.[0-9][0-9.]*\]' || fail "libwalkcycle.so has no versioned SONAME"
if readelf -d "$library" | grep -E 'NEEDED.*(libGL|libEGL|epoxy|glfw)'; then fail "libwalkcycle.so needs OpenGL"; fi
nm -DC --defined-only "$library" >"$work/symbols"
grep -q ' T walkcycle::loadCollada' "$work/symbols" || fail "loadCollada is not shown"
for private in XmlNode ColladaDocument FastPoser Curve KeyFrameFitter MeshBuilder Archive; do
    if grep -E " [TVWB] (vtable for |typeinfo for )?walkcycle::$private(::|$)" "$work/symbols"; then
        fail "the private $private is shown"
    fi
done

check_headers
export LD_LIBRARY_PATH=$(dirname "$library")
consumers
with_pkg_config

# As a subproject. An empty build type stays empty.
logged cmake -S "$here/subdirectory" -B "$parent" "${settings[@]}" -DWALKCYCLE_SOURCE="$source" \
    -DWALKCYCLE_BUILD_RENDER=OFF -DCMAKE_BUILD_TYPE= -DEXPECTED_BUILD_TYPE=
logged cmake --build "$parent" --parallel
"$parent/loads" "$source/res/walker.dae" | grep -q pelvis || fail "the subproject's program"
logged cmake --install "$parent" --prefix "$work/parent"
[ "$(cd "$work/parent" && find . -type f)" = ./bin/loads ] || fail "the subproject was installed: $(find "$work/parent" -type f)"
echo "shared, and as a subproject"
