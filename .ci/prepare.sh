# Shared by ./studio and ./check: what is missing is installed, what changed is built. All words go to stderr.
set -eu
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { echo "crest: $*" >&2; }

# took STAGE: notes in `times` how long it was since the last stage.
stage_began=$SECONDS times=
took() {
  times+="${times:+, }$1 $((SECONDS - stage_began)) s"
  stage_began=$SECONDS
}

# install_packages FILE...: the Debian packages listed in these files, those that are not there.
install_packages() {
  local missing=() package
  local installed
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' 2>/dev/null || true)
  while read -r package; do
    grep -qxF "$package installed" <<<"$installed" || missing+=("$package")
  done < <(cat "$@")
  [ ${#missing[@]} -eq 0 ] && return
  command -v apt-get >/dev/null || { say "these Debian packages are needed: ${missing[*]}"; exit 1; }
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { say "run this as root, or with sudo, to install: ${missing[*]}"; exit 1; }
    sudo=(sudo)
  fi
  say "installing ${#missing[@]} packages: ${missing[*]}"
  "${sudo[@]}" apt-get update -qq >&2
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2 ||
    { say "the packages could not be installed"; exit 1; }
}

# Ninja's output as one line that counts; what went wrong is shown in full, and nothing where nothing is to do.
show_progress() {
  awk -v name="$1" -v tty="$([ -t 2 ] && echo 1)" '
    /^ninja: (Entering|no work)/ || /Re-checking globbed|Re-running CMake/ || /^-- / { next }
    match($0, /^\[[0-9]+\/[0-9]+\]/) {
      split(substr($0, 2, RLENGTH - 2), count, "/")
      if (tty) { printf "\rcrest: building %s: %d of %d ", name, count[1], count[2]; shown = 1; fflush() }
      else if (count[1] == 1 || count[1] == count[2] || count[1] % 20 == 0) {
        printf "crest: building %s: %d of %d\n", name, count[1], count[2]; fflush()
      }
      next
    }
    { if (shown) print ""; shown = 0; print; fflush() }
    END { if (shown) print "" }'
}

# build FOLDER CMAKE_OPTION... -- TARGET...: configures once, builds what changed.
build() {
  local folder=$1 options=() targets=()
  shift
  while [ "$1" != -- ]; do options+=("$1"); shift; done
  shift
  targets=("$@")
  if [ ! -f "$folder/build.ninja" ]; then
    say "configuring $folder"
    mkdir -p "$folder"
    if ! cmake -S "$root" -B "$folder" -G Ninja "${options[@]}" >"$folder/configure.log" 2>&1; then
      cat "$folder/configure.log" >&2
      rm -f "$folder/build.ninja"
      exit 1
    fi
  fi
  ninja -C "$folder" "${targets[@]}" 2>&1 | show_progress "${folder#"$root"/}" >&2
  [ "${PIPESTATUS[0]}" -eq 0 ] || { say "the build failed"; exit 1; }
}
