#!/usr/bin/env bash
# fresh.sh ROOT SUITE COMMAND...: runs commands of ./dev (or `wheel`: build/wheels for a newcomer, tools/newcomer.sh;
# `walk`: tools/walk.sh) in a Debian as debootstrap leaves it, on a clean clone of what is committed at ROOT. It uses this machine's mirror, proxies, name servers and certificates, and nothing else of it.
# Status 77: cannot be tried here (no root, no debootstrap, no network). The bare system is kept as build/fresh/SUITE.tar
# (remove it to fetch it anew), a folder in which a command failed as build/fresh/SUITE.
# What `run` and `test` compile is kept in build/fresh/SUITE.ccache for the next time, in the same way: BENTUR_FRESH=cold does
# without. What newcomers are told to wait for (`walk`, `wheel`) is always compiled.
# What is mounted is mounted in a namespace of its own, and gone with the last process in there, whatever happens.
set -euo pipefail

say() { echo "fresh: $*" >&2; }
skip() {
  say "$*"
  exit 77
}

# Inside the namespace: devices of its own, so that no command reaches this machine's; CACHE is a folder, or empty.
inside() {
  local tree=$1 cache=$2 node
  shift 2
  if [ -n "$cache" ]; then
    mkdir -p "$tree/root/.cache/ccache"
    mount --bind "$cache" "$tree/root/.cache/ccache"
  fi
  mount -t proc proc "$tree/proc"
  mount -t sysfs -o ro sysfs "$tree/sys"
  mount -t tmpfs -o mode=755 devices "$tree/dev"
  for node in null:3 zero:5 full:7 random:8 urandom:9; do mknod -m 666 "$tree/dev/${node%:*}" c 1 "${node#*:}"; done
  mknod -m 666 "$tree/dev/tty" c 5 0
  mkdir "$tree/dev/pts" "$tree/dev/shm"
  mount -t devpts -o newinstance,ptmxmode=666 devpts "$tree/dev/pts"
  mount -t tmpfs -o mode=1777 shm "$tree/dev/shm"
  ln -s pts/ptmx "$tree/dev/ptmx"
  ln -s /proc/self/fd "$tree/dev/fd"
  for node in 0:stdin 1:stdout 2:stderr; do ln -s "/proc/self/fd/${node%:*}" "$tree/dev/${node#*:}"; done
  exec chroot "$tree" "$@"
}

if [ "${1:-}" = --inside ]; then
  shift
  inside "$@"
fi

root=$1 suite=$2
shift 2
[ "$(id -u)" = 0 ] || skip "a fresh $suite needs root"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
unshare --mount --pid --fork true 2>/dev/null || skip "no namespaces for mounts and processes here"
git -C "$root" rev-parse --quiet --verify HEAD >/dev/null || skip "$root is no git repository to clone"
folder=$root/build/fresh
mkdir -p "$folder"
exec 9>"$folder/$suite.lock"
flock --nonblock 9 || { say "another run has $folder/$suite"; exit 1; }
tree=$folder/$suite base=$folder/$suite.tar
rm -rf --one-file-system "$tree"

# Proxies of apt are for debootstrap too.
for scheme in http https; do
  eval "$(apt-config shell apt_proxy "Acquire::$scheme::Proxy" 2>/dev/null)"
  if [ -n "${apt_proxy:-}" ]; then export "${scheme}_proxy=$apt_proxy"; fi
  unset apt_proxy
done
if [ ! -f "$base" ]; then
  debian_mirror() { apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' 'Label: Debian' 2>/dev/null | head -n 1 || true; }
  mirror=$(debian_mirror)
  if [ -z "$mirror" ]; then apt-get update -q >"$folder/$suite.log" 2>&1 || true; mirror=$(debian_mirror); fi
  say "fetching a bare $suite"
  # Without a mirror debootstrap has its own.
  debootstrap --variant=minbase "$suite" "$tree" ${mirror:+"$mirror"} >"$folder/$suite.log" 2>&1 || {
    tail -n 5 "$folder/$suite.log" >&2
    rm -rf --one-file-system "$tree"
    skip "cannot fetch a bare $suite; is there a network?"
  }
  tar -C "$tree" -cf "$base.part" . && mv "$base.part" "$base"
else
  mkdir "$tree"
  tar -C "$tree" -xf "$base"
fi
# What this machine needs to reach its mirror.
cp -L /etc/resolv.conf /etc/hosts "$tree/etc/"
apt-config dump 2>/dev/null | grep -E '^Acquire::(http|https|Retries|ForceIPv|Check-|AllowInsecureRepositories)' \
  >"$tree/etc/apt/apt.conf.d/99outer" || true
mkdir -p "$tree/etc/ssl/certs" "$tree/usr/local/share/ca-certificates"
for file in /etc/ssl/certs/ca-certificates.crt /usr/local/share/ca-certificates/*.crt; do
  if [ -f "$file" ]; then cp -L "$file" "$tree$file"; fi
done
git clone --quiet --no-local "$root" "$tree/root/bentur"

variables=(HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb)
for name in http_proxy https_proxy no_proxy; do
  if [ -n "${!name:-}" ]; then variables+=("$name=${!name}"); fi
done
# What the package that was built in there does in another such Debian, where nothing else is.
try_package() {
  local other=$folder/$suite-installed
  rm -rf --one-file-system "$other"
  mkdir "$other"
  tar -C "$other" -xf "$base"
  cp -L /etc/resolv.conf /etc/hosts "$other/etc/"
  cp -r "$tree/etc/apt/apt.conf.d/." "$other/etc/apt/apt.conf.d/"
  mkdir -p "$other/etc/ssl/certs"
  cp -r "$tree/etc/ssl/certs/." "$other/etc/ssl/certs/"
  cp "$tree"/root/bentur/build/package/*.deb "$other/root"
  setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child "${BASH_SOURCE[0]}" --inside "$other" "" \
    /usr/bin/env -i "${variables[@]}" bash -euc '
      cd ~
      export DEBIAN_FRONTEND=noninteractive
      apt-get update -q
      apt-get install -y -q --no-install-recommends ./bentur_*.deb
      bentur --version
      bentur example m12-el-centro -o own
      bentur run own/m12-el-centro.toml -o results
      ls results/summary.json
      apt-get install -y -q --no-install-recommends ./libbentur-dev_*.deb
      ls /usr/include/bentur/pounding/pounding.h' >"$folder/$suite-installed.log" 2>&1 || {
    tail -n 30 "$folder/$suite-installed.log" >&2
    echo "$suite: the package cannot be installed or does not run; all of it: $folder/$suite-installed.log"
    exit 1
  }
  rm -rf --one-file-system "$other"
}

for name in "$@"; do
  say "./dev $name in a bare $suite"
  command="cd ~/bentur && time ./dev $name"
  [ "$name" != walk ] || command="time ~/bentur/tools/walk.sh ~/bentur"
  if [ "$name" = wheel ]; then
    ls "$root"/build/wheels/*.whl >/dev/null || { say "no wheels: ./dev wheels builds them"; exit 1; }
    mkdir -p "$tree/root/wheels"
    cp "$root"/build/wheels/*.whl "$tree/root/wheels"
    if [ -f /etc/pip.conf ]; then cp -L /etc/pip.conf "$tree/etc/pip.conf"; fi
    while IFS= read -r setting; do variables+=("$setting"); done < <(env | grep '^PIP_' || true)
    command="(apt-get update -q && apt-get install -y -q --no-install-recommends python3-venv ca-certificates) >/dev/null &&
      time ~/bentur/tools/newcomer.sh ~/wheels"
  fi
  cache=
  if [ "${BENTUR_FRESH:-}" != cold ] && [[ $name == run || $name == test ]]; then
    cache=$folder/$suite.ccache
    mkdir -p "$cache"
  fi
  log=$folder/$suite-$name.log begin=$(date +%s) status=0
  # All processes in there end when this one does, however it ends.
  setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child "${BASH_SOURCE[0]}" --inside "$tree" "$cache" \
    /usr/bin/env -i "${variables[@]}" bash -c "$command" >"$log" 2>&1 || status=$?
  seconds=$(($(date +%s) - begin))
  if [ $status != 0 ]; then
    tail -n 60 "$log" >&2
    echo "$suite: ./dev $name failed with status $status after $seconds s; all of it: $log"
    exit 1
  fi
  processor=$(awk '/^(user|sys)\t/ { split($2, part, /[ms]/); sum += 60 * part[1] + part[2] } END { print int(sum + 0.5) }' "$log")
  summary=$(grep -E '^[0-9]+ passed, ' "$log" | tail -n 1 || true)
  grep -E '^(first case|package installed|what the examples) ' "$log" | sed "s/^/$suite: /" || true
  if [ "$name" = package ]; then try_package; fi
  echo "$suite: ./dev $name passed in $seconds s ($processor s of processors)${summary:+: $summary}"
done
rm -rf --one-file-system "$tree"
