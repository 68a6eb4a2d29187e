#!/usr/bin/env bash
# container.sh ROOT: builds the image of packaging/Containerfile from what is committed, by buildah, and runs a case in it:
# build/container/bentur.tar is the image. Where a bare Debian is there already (./dev fresh trixie), it begins with that
# and asks no registry. Status 77: no buildah.
set -euo pipefail
say() { echo "container: $*" >&2; }
root=$1 out=$1/build/container
command -v buildah >/dev/null || { say "buildah is not installed"; exit 77; }
scratch=$(mktemp -d)
of=(--root "$scratch/images" --runroot "$scratch/run" --storage-driver vfs)
trap 'buildah "${of[@]}" rm --all >/dev/null 2>&1 || true; rm -rf "$scratch"' EXIT
mkdir -p "$out"
git clone --quiet --no-local "$root" "$scratch/bentur"
arguments=(--isolation chroot --network host -f "$scratch/bentur/packaging/Containerfile" -t bentur)
bare=$root/build/fresh/trixie.tar
if [ -f "$bare" ]; then
  first=$(buildah "${of[@]}" from scratch)
  buildah "${of[@]}" add -q "$first" "$bare" / >/dev/null
  buildah "${of[@]}" commit -q "$first" bare >/dev/null
  arguments+=(--build-arg BASE=localhost/bare)
fi
say "building the image"
buildah "${of[@]}" build "${arguments[@]}" "$scratch/bentur" >"$out/build.log" 2>&1 || {
  tail -n 30 "$out/build.log" >&2
  exit 1
}
made=$(buildah "${of[@]}" from bentur)
mkdir "$scratch/work"
in_it() { buildah "${of[@]}" run --isolation chroot --network host -v "$scratch/work:/work" "$made" -- bentur "$@"; }
in_it --version
in_it example m12-el-centro -o own
in_it run own/m12-el-centro.toml -o results --figures pdf -q
test -s "$scratch/work/results/summary.json" && test -s "$scratch/work/results/figures/force.pdf"
buildah "${of[@]}" push -q bentur "oci-archive:$out/bentur.tar"
say "$out/bentur.tar: podman load -i it"
