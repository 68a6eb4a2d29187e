#!/usr/bin/env bash
# release.sh ROOT VERSION: writes the version where it stands, commits that, tags it vVERSION, by which all that is built of
# it knows that it is the release (cmake/version.cmake), and puts into build/release-VERSION what is published: the source
# archive, from which the program is built and run here, the wheels that ./dev wheels has made of that tag, the studio, and
# their checksums. It says what is left to do; it sends nothing anywhere.
set -euo pipefail
say() { echo "release: $*" >&2; }
root=$1 version=${2:-}
[[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || { say "which version? ./dev release 1.2.3"; exit 1; }
cd "$root"
[ -z "$(git status --porcelain)" ] || { say "there are changes that are not committed"; exit 1; }
if ! grep -q "^## $version (.*)$" CHANGELOG.md; then
  say "CHANGELOG.md has no entry '## $version (unreleased)'"
  exit 1
fi
sed -i "s/^## $version (unreleased)$/## $version ($(date +%F))/" CHANGELOG.md
date=$(sed -n "s/^## $version (\(.*\))$/\1/p" CHANGELOG.md)
sed -i "s/^project(bentur VERSION [0-9.]* /project(bentur VERSION $version /" CMakeLists.txt
sed -i -e '/^date-released: /d' -e "s/^version: .*/version: $version\ndate-released: $date/" CITATION.cff
python3 tools/addresses.py .
[ -s packaging/address ] || say "packaging/address is empty: README and packages name no place where the sources are"
if [ -n "$(git status --porcelain)" ]; then git commit -qam "Version $version"; fi
if ! git rev-parse --quiet --verify "refs/tags/v$version" >/dev/null; then
  git tag -a "v$version" -m "Version $version"
elif [ "$(git rev-parse "v$version^{commit}")" != "$(git rev-parse HEAD)" ]; then
  say "the tag v$version is of another commit; git tag -d v$version removes it, where it has not been published"
  exit 1
fi

out=$root/build/release-$version
rm -rf "$out"
mkdir -p "$out"
archive=$out/bentur-$version.tar.gz
git archive --prefix="bentur-$version/" -o "$archive" HEAD
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tar -C "$scratch" -xf "$archive"
say "building the program from the archive"
(cd "$scratch/bentur-$version" && ./dev build) >"$out/build.log" 2>&1 || { tail -n 20 "$out/build.log" >&2; exit 1; }
told=$("$scratch/bentur-$version/build/release/apps/bentur/bentur" --version)
[ "$told" = "bentur $version" ] || { say "the program says that it is $told"; exit 1; }
"$scratch/bentur-$version/build/release/apps/bentur/bentur" run >"$out/run.txt"
tail -n 1 "$out/run.txt"
rm "$out/run.txt" "$out/build.log"
if ls build/wheels/bentur-"$version"-*.whl >/dev/null 2>&1; then
  cp build/wheels/bentur-"$version"-*.whl "$out"
else
  say "no wheels of $version: ./dev wheels makes them, then ./dev release $version again"
fi
if "$scratch/bentur-$version/web/build.sh" page >"$out/studio.log" 2>&1; then
  cp "$scratch/bentur-$version/build/web/bentur-studio.html" "$out"
else
  say "no studio: $(tail -n 1 "$out/studio.log")"
fi
rm "$out/studio.log"
(cd "$out" && sha256sum -- * >SHA256SUMS && sha512sum "bentur-$version.tar.gz")
ls "$out"
say "left to do: push the tag v$version, and publish build/release-$version with the entry of CHANGELOG.md"
