#!/usr/bin/env bash
# package.sh ROOT: the Debian packages of what is committed, by dpkg-buildpackage from the source archive, in build/package.
set -euo pipefail
root=$1 out=$1/build/package
version=$(sed -n 's/^project(bentur VERSION \([0-9.]*\) .*/\1/p' "$root/CMakeLists.txt")
rm -rf "$out"
mkdir -p "$out"
git -C "$root" archive --prefix="bentur-$version/" -o "$out/bentur_$version.orig.tar.gz" HEAD
tar -C "$out" -xf "$out/bentur_$version.orig.tar.gz"
source=$out/bentur-$version
cp -r "$source/packaging/debian" "$source/debian"
cat "$source/LICENSE" | sed -e 's/^$/./' -e 's/^/ /' >>"$source/debian/copyright"
cat >"$source/debian/changelog" <<END
bentur ($version-1) unstable; urgency=medium

  * As CHANGELOG.md says.

 -- bentur contributors <maintainers@bentur.invalid>  $(git -C "$root" log -1 --format=%cD)
END
(cd "$source" && dpkg-buildpackage --no-sign --build=binary)
ls "$out"/*.deb
