#!/usr/bin/env bash
# Runs a command inside a Debian root made by make_root.sh.
#
# Usage: in_root.sh ROOT [--bind FOLDER PLACE]... COMMAND...
#   The project lies at /project in the root; --bind puts another folder at PLACE, for reading. pip in the root trusts the
#   certificates that this machine trusts, and takes its packages from where this machine's pip does.
# Mounts and processes have namespaces of their own: whatever happens, nothing stays mounted and nothing keeps running.
set -euo pipefail
project="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
root="$(cd "$1" && pwd)"
shift
binds=()
while [ "${1:-}" = --bind ]; do
  binds+=("$2" "$3")
  shift 3
done

settings=(LANG=C.UTF-8 LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive PIP_DISABLE_PIP_VERSION_CHECK=1)
if [ -f /etc/ssl/certs/ca-certificates.crt ]; then
  binds+=(/etc/ssl/certs /machine/certificates)
  settings+=(PIP_CERT=/machine/certificates/ca-certificates.crt)
fi
for name in PIP_INDEX_URL PIP_EXTRA_INDEX_URL PIP_TRUSTED_HOST PIP_DEFAULT_TIMEOUT; do
  [ -z "${!name:-}" ] || settings+=("$name=${!name}")
done

# The rest runs where its mounts are seen by nobody else. Its arguments: root, project, number of binds, binds, command.
exec unshare --mount --pid --fork --kill-child -- bash -euo pipefail -c '
  root="$1" project="$2" binds="$3"
  shift 3
  mount -t proc proc "$root/proc"
  mkdir -p "$root/project" "$root/dev/shm"
  mount -t tmpfs tmpfs "$root/dev/shm"
  mount -t tmpfs tmpfs "$root/tmp" # locks of a display that was killed must not be met again
  mount --bind "$project" "$root/project"
  while [ "$binds" -gt 0 ]; do
    mkdir -p "$root$2"
    mount --bind "$1" "$root$2"
    shift 2
    binds=$((binds - 2))
  done
  exec chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"
' in_root "$root" "$project" "${#binds[@]}" ${binds[@]+"${binds[@]}"} "${settings[@]}" "$@"
