# Functions shared by the scripts in this folder. To be sourced.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=${AUTOCUTS_JOBS:-$(nproc)}

fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

# missing_packages LIST...: names of the packages in the lists that are not installed.
missing_packages() {
    local package
    cat "$@" | while read -r package; do
        case $package in '' | '#'*) continue ;; esac
        if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
            printf '%s\n' "$package"
        fi
    done
}

# install_packages [LIST...]: installs what is missing of scripts/packages and further lists, as root or through sudo;
# without either says what to install.
install_packages() {
    command -v dpkg-query >/dev/null ||
        fail "this is not a Debian system: install the equivalents of the packages in scripts/packages, then build with cmake"
    local missing
    mapfile -t missing < <(missing_packages "$root/scripts/packages" "$@")
    [ ${#missing[@]} -gt 0 ] || return 0
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
            as_root=(sudo)
        else
            fail "packages are missing; as root, run: apt-get install ${missing[*]}"
        fi
    fi
    printf 'Installing %s\n' "${missing[*]}"
    "${as_root[@]}" apt-get update -q || fail "apt-get update failed: is the network reachable?"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -q --no-install-recommends "${missing[@]}" ||
        fail "apt-get could not install: ${missing[*]}"
}

# configure PRESET: warnings are errors when CI is set.
configure() {
    local werror=OFF
    [ -z "${CI:-}" ] || werror=ON
    (cd "$root" && cmake --preset "$1" -DAUTOCUTS_WERROR=$werror) || fail "configuring the $1 build failed"
}

# build PRESET [cmake --build options]
build() {
    local preset=$1
    shift
    (cd "$root" && cmake --build --preset "$preset" --parallel "$jobs" "$@") || fail "the $preset build failed"
}

# run_tests PRESET [ctest options]
run_tests() {
    local preset=$1
    shift
    local failed=
    (cd "$root" && ctest --preset "$preset" --no-tests=error --output-on-failure --parallel "$jobs" "$@") ||
        failed=1
    say_skipped "$root/build/$preset/Testing/Temporary/LastTest.log"
    [ -z "$failed" ] || fail "tests failed in the $preset build"
}

# say_skipped LOG: says how many cases of the last run of ctest lacked the real meshes, Blender, or another program that
# is not installed; nothing when none did. They give "no meshes: ...", "no Blender: ..." or "no program: ..." as the reason.
say_skipped() {
    [ -f "$1" ] || return 0
    local want
    for want in meshes Blender program; do
        awk -v want="$want" '
            $0 ~ "^SKIP +: .* no " want ": " {
                ++cases
                program = $3
                sub(/::.*/, "", program)
                if (!(program in seen)) {
                    seen[program] = 1
                    ++programs
                }
            }
            END {
                if (cases > 0)
                    printf "skipped without %s: %d cases in %d programs\n",
                        want == "program" ? "other programs" : want, cases, programs
            }' "$1"
    done
}
