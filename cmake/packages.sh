# shellcheck shell=bash
# Sourced by play and check: install what is missing of cmake/packages.txt, without ever asking a question.

# need_packages SCOPE...: the packages of those scopes are installed when this returns.
need_packages() {
    local list missing=() name
    list=$(dirname "${BASH_SOURCE[0]}")/packages.txt
    if ! command -v dpkg-query >/dev/null; then
        echo "This is not a Debian system: the packages of $list are assumed to be there under other names." >&2
        return 0
    fi
    for name in $(for scope in "$@"; do awk -v scope="$scope" '$1 == scope {print $2}' "$list"; done); do
        [[ $(dpkg-query -W -f='${Status}' "$name" 2>/dev/null) == *" installed" ]] || missing+=("$name")
    done
    ((${#missing[@]})) || return 0

    echo "Installing ${missing[*]}"
    local as_root=()
    if ((EUID != 0)); then
        as_root=(sudo -n)
        if ! sudo -n true 2>/dev/null; then
            explain_packages "Neither root nor sudo without a password" "${missing[@]}"
        fi
    fi
    # An old package list may name versions that are gone; without a network it must do.
    "${as_root[@]}" apt-get update -qq || echo "The package list could not be refreshed; trying the one there is." >&2
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" ||
        explain_packages "apt-get could not install them" "${missing[@]}"
}

# explain_packages REASON PACKAGE...: says what to do by hand, and stops.
explain_packages() {
    local reason=$1
    shift
    printf '%s. Please install these packages and run this again:\n\n    apt-get install %s\n\n' "$reason" "$*" >&2
    exit 3
}
