#!/usr/bin/env bash
# package.sh ROOT: the Debian packages of what is committed, by dpkg-buildpackage from the source archive, in build/package.
# Their version is the program's, with ~ before dev, which Debian sorts before the release.
set -euo pipefail
root=$1 out=$1/build/package
rm -rf "$out"
mkdir -p "$out"
source=$out/bentur
git -C "$root" archive --prefix=bentur/ -o "$source.tar.gz" HEAD
tar -C "$out" -xf "$source.tar.gz"
version=$(cmake -P "$source/cmake/version.cmake" | sed 's/[.]dev/~dev/')
mv "$source.tar.gz" "${source}_$version.orig.tar.gz"
cp -r "$source/packaging/debian" "$source/debian"
cat "$source/LICENSE" | sed -e 's/^$/./' -e 's/^/ /' >>"$source/debian/copyright"
cat >"$source/debian/changelog" <<END
bentur ($version-1) unstable; urgency=medium

  * As CHANGELOG.md says.

 -- bentur contributors <maintainers@bentur.invalid>  $(git -C "$root" log -1 --format=%cD)
END
(cd "$source" && dpkg-buildpackage --no-sign --build=binary)
ls "$out"/*.deb
