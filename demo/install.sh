#!/bin/sh
# Installs what a fresh Debian 12 lacks: install.sh demo|tests. Asks for nothing that is there.
set -eu
demo="build-essential meson ninja-build pkg-config python3 libgl-dev libegl1 libgl1-mesa-dri
      libosmesa6 libglm-dev libopenmesh-dev libpng-dev libtinyexr-dev libglfw3-dev libimgui-dev
      libembree-dev"
tests="libcmocka-dev liblapacke-dev glslang-tools libvulkan-dev mesa-vulkan-drivers xvfb xauth git"
case "${1:-}" in
demo) packages=$demo ;;
tests) packages="$demo $tests" ;;
*) echo "usage: install.sh demo|tests" >&2; exit 2 ;;
esac

missing=
for package in $packages; do
    state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0
if ! command -v apt-get >/dev/null; then
    echo "install.sh: not Debian; needed are:$missing" >&2
    exit 1
fi
as_root=
[ "$(id -u)" -eq 0 ] || as_root=sudo
echo "installing:$missing"
$as_root apt-get update -qq
# shellcheck disable=SC2086
DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends $missing \
    >/dev/null
